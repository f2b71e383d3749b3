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
    {"sizes_thin", 1.0 / 255, 1.0 / 255,
     "A filter is a mean, so nothing is darker; one step of an 8-bit image."},
    {"sizes_half", 1.0 / 255, 1.0 / 255,
     "A filter is a mean, so nothing is darker; one step of an 8-bit image."},
    {"centre_line", 1.0 / 255, 1.0 / 255,
     "What does not stand out elsewhere does not in the middle; one 8-bit step."},
    {"half_size_mean", 0.02, 0.02,
     "At most a pixel of 49 has its value from one beside it; the source's 2 %."},
    {"quarter_size_mean", 0.02, 0.02,
     "At most three pixels of 49 have theirs from one beside; the source's 2 %."},
    {"half_size_drift", 0.5, 0.5, "A wrong centre is 1, a right one 0, and there is noise."},
    {"phantom_depth", 1.0 / 255, 1.0 / 255,
     "Neither surface occludes the other; one step of an 8-bit image."},
    {"upsampled_edge", 0.02, 0.02, "Noise of 0.25 a pixel in the means of columns of 66 low pixels."},
    {"levels_in_pixels", 0.5, 0.5,
     "Of 96 pixels most lie beyond any offset; squared spacing leaves a third within 10."},
    {"taps_follow_radius", 0.1, 0.1,
     "Half a pixel of a mean of five at the edge; a wrong unit halves or doubles it."},
    {"impulse_centred", 0.1, 0.1,
     "A filter that is its own mirror image moves nothing; a tenth of a pixel is noise's."},
    {"impulse_transposed", 2, 2,
     "Four taps along one axis alone make it 3; two axes one after the other are no exact transpose."},
    {"constant_kept", 0.001, 0.001, "A target of half floats rounds to 1/2048 below 1."},
    {"resolution_invariant", 1, 1, "Half a pixel along all rims; noise of 0.25 a pixel over 25 taps, twice."},
    {"size_continuous", 0.01, 0.01,
     "Rims move by at most half a pixel: 200 of 4000 pixels change by a quarter of 0.3."},
    /* --- edges --- */
    /* --- relations --- */
    /* --- instruments --- */
    {0},
};
