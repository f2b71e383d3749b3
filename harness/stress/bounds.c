#include "property.h"

/* All bounds, by group. Two steps of an image of 8 bits are 1/128: what nobody sees. */
const struct aob_bound aob_bounds[] = {
    /* --- projection --- */
    {"plane_is_open", 0.005, 0.005, "Nothing occludes a plane; 1/255 is one step of an 8-bit image, rounded up."},
    {"plane_any_fov", 0.005, 0.005, "An open plane has no occluder; 1/255 is one step of an 8-bit image, rounded up."},
    {"scaled_by_two", 0, 1.0 / 255, "Powers of two change exponents only; a GPU may flush a denormal."},
    /* --- numbers --- */
    {"view_ray_sample", 1.0 / 255, 1.0 / 255,
     "A millionth of a turn is no step of an 8-bit image; a tap may fall on the next texel."},
    {"radius_below_pixel", 0.005, 0.005,
     "Nothing occludes a plane; 1/255 is one step of an 8-bit image, rounded up."},
    {"radius_smallest", 0.005, 0.005,
     "A pixel of the set is 500 times as large at least; 1/255 is one step of 8 bits, rounded up."},
    {"radius_enormous", 1.0 / 255, 1.0 / 255, "The truth is the same; one step of an 8-bit image."},
    {"falloff_ends", 1.0 / 255, 1.0 / 255,
     "A millionth of the radius or of the weight takes in a tap of an image at most; one step of 8 bits."},
    {"parameter_ends", 0, 0, "An image is finite and in 0..1 or it is not."},
    {"gradation", 0.004, 0.004,
     "An image of 8 bits has steps of 1/255, rounded up; none has coarser ones to give."},
    {"distinct_taps", 0.1, 0.1,
     "Chance is what a careless pattern reaches; a tenth is left to samples of one direction that share its "
     "pixels."},
    {"optical_axis", 1.0 / 255, 1.0 / 255,
     "The plane is the same in all pixels; places are rounded otherwise."},
    {"filter_contains_nan", 0, 0, "A pixel that does not read the changed one computes what it did."},
    {"nan_depth", 0, 0, "A pixel that does not read the changed one computes what it did."},
    {"infinite_depth", 0, 0, "A pixel that does not read the changed one computes what it did."},
    {"negative_depth", 0, 0, "A pixel that does not read the changed one computes what it did."},
    {"zero_depth", 0, 0, "A pixel that does not read the changed one computes what it did."},
    {"denormal_depth", 0, 0, "A pixel that does not read the changed one computes what it did."},
    {"half_overflow", 0, 1.0 / 255, "Powers of two change exponents only; a GPU may flush a denormal."},
    {"repeats_itself", 0, 0, "The same program on the same numbers."},
    {"after_other_sizes", 0, 0, "The same program on the same numbers."},
    {"same_by_storage", 0, 1.0 / 255,
     "The same arithmetic on the same texels; a GPU's compiler may round another text otherwise."},
    {"drawn_at_all", 0.75, 0.75,
     "A text may count occlusion more weakly than the truth; black, white and grey have none of its "
     "contrast."},
    {"finite_everywhere", 0, 0, "An image is finite and in 0..1 or it is not."},
    /* --- near --- */
    /* --- normals --- */
    /* --- resolution --- */
    /* --- edges --- */
    /* --- relations --- */
    /* --- instruments --- */
    {0},
};
