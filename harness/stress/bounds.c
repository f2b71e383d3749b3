#include "property.h"

/* All bounds, by group. Two steps of an image of 8 bits are 1/128: what nobody sees. */
const struct aob_bound aob_bounds[] = {
    /* --- projection --- */
    {"plane_is_open", 0.005, 0.005, "Nothing occludes a plane; 1/255 is one step of an 8-bit image, rounded up."},
    {"plane_any_fov", 0.005, 0.005, "An open plane has no occluder; 1/255 is one step of an 8-bit image, rounded up."},
    {"scaled_by_two", 0, 1.0 / 255, "Powers of two change exponents only; a GPU may flush a denormal."},
    /* --- numbers --- */
    /* --- near --- */
    /* --- normals --- */
    {"normal_encodings_plane", 1.0 / 255, 1.0 / 255,
     "One step of an 8-bit image; what the angle can do is taken off."},
    {"normal_encodings_image", 1.0 / 255, 1.0 / 255,
     "One step of an 8-bit image; what the angle can do is taken off."},
    {"zero_normal", 1.0 / 255, 1.0 / 255,
     "The normals are the same but for rounding, by which a tap may be another."},
    {"nan_normal", 1.0 / 255, 1.0 / 255,
     "The normals are the same but for rounding, by which a tap may be another."},
    {"flipped_normal", 1.0 / 255, 1.0 / 255,
     "Turned round they are the same bits; at a silhouette which way is round may be open."},
    {"unnormalised_normal", 1.0 / 255, 1.0 / 255,
     "The normals are the same but for rounding, by which a tap may be another."},
    {"axial_normals", 0.1, 0.1,
     "A tile of 4 x 4 patterns of 24 samples has 384, open or not: the mean deviates by up to 0.5/sqrt(384) "
     "= 0.026, two of four walls by four of that."},
    {"leaning_normals", 0.005, 0.005,
     "Nothing occludes a plane; 1/255 is one step of an 8-bit image, rounded up."},
    {"coarse_normals", 0.05, 0.05,
     "What three.js, Godot and ezEngine had to reach for facets not to be seen: 0.95 where 1 is right."},
    {"derived_at_step", 1.0 / 255, 1.0 / 255,
     "The normals are the same but for rounding, by which a tap may be another."},
    {"derived_at_border", 1.0 / 255, 1.0 / 255,
     "The normals are the same but for rounding, by which a tap may be another."},
    {"derived_plane", 1.0 / 255, 1.0 / 255,
     "The normals are the same but for rounding, by which a tap may be another."},
    {"mapped_plane", 1, 1,
     "An obscurance of intensity 1 loses 4/pi of the angle, all other definitions less."},
    /* --- resolution --- */
    /* --- edges --- */
    /* --- relations --- */
    /* --- instruments --- */
    {0},
};
