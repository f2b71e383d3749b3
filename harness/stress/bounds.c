#include "property.h"

/* All bounds, by group. Two steps of an image of 8 bits are 1/128: what nobody sees. */
const struct aob_bound aob_bounds[] = {
    /* --- projection --- */
    {"plane_is_open", 0.005, 0.005,
     "Nothing occludes a plane; 1/255 is one step of an 8-bit image, rounded up."},
    {"plane_any_fov", 0.005, 0.005,
     "An open plane has no occluder; 1/255 is one step of an 8-bit image, rounded up."},
    {"scaled_by_two", 0, 1.0 / 255, "Powers of two change exponents only; a GPU may flush a denormal."},
    /* --- numbers --- */
    /* --- near --- */
    {"approach_crease", 0.25, 0.25, "Few samples find three quarters of an occlusion that the image shows."},
    {"closer_than_radius", 0.25, 0.25,
     "Few samples find three quarters of an occlusion that the image shows."},
    {"behind_camera", 0.25, 0.25,
     "The image cuts the larger ball off more; three quarters of the occlusion stay."},
    {"inside_box", 0.25, 0.25, "Few samples find three quarters of an occlusion that the image shows."},
    /* --- normals --- */
    /* --- resolution --- */
    /* --- edges --- */
    {"guard_crop", 0, 1.0 / 255,
     "The same taps on the same numbers; a GPU may round another program's otherwise."},
    {"border_is_open", 0.005, 0.005, "A strip and the middle hold whole tiles of noise; 1/255, rounded up."},
    {"sky_is_open", 0, 0, "technique.h asks for 1 in the sky."},
    {"sky_only", 0, 0, "technique.h asks for 1 in the sky."},
    {"sky_rim", 1.0 / 255, 1.0 / 255,
     "Depths of another triangle differ in their last bit: a step of 8 bits."},
    {"step_edge_halo", 1.0 / 255, 1.0 / 255, "Nothing lies within the radius; one step of an 8-bit image."},
    {"thin_fence", 1.0 / 255, 1.0 / 255, "Nothing lies within the radius; one step of an 8-bit image."},
    {"thin_in_reach", 0.01, 0.01,
     "What a tap finds between bars it finds on a sheet; upsampling mixes other pixels."},
    {"pillar_round", 0.03, 0.03,
     "A tile of 16 pixels with 16 samples has 256 directions: a share is off by 1/32."},
    {"distant_terrain", 0.01, 0.01,
     "Nothing within a pixel can be told; two to three steps of an 8-bit image."},
    {"faces_alike", 0.03, 0.03,
     "A tile of 16 pixels with 16 samples has 256 directions: a share is off by 1/32."},
    {"degenerate_faces", 1.0 / 2048, 1.0 / 255,
     "In view space three corners on a line have the area of rounding."},
    {"coincident_faces", 0, 1.0 / 255, "The depth buffer is the same."},
    {"inverted_faces", 1.0 / 255, 1.0 / 255,
     "A tap may fall on the next texel where a depth's last bit differs."},
    {"tessellated_faces", 1.0 / 255, 1.0 / 255,
     "A tap may fall on the next texel where a depth's last bit differs."},
    /* --- relations --- */
    /* --- instruments --- */
    {0},
};
