#include "property.h"

#define STEP (1.0 / 255)
/* Of 1024 pixels that spread by .2 a mean is off by .006, and of two such means the difference by .009: 2.3 times that. */
#define BLOCK 0.02
#define BLOCK_REASON                                                                                         \
    "The mean of 1024 pixels that spread by .2 is off by .006, the difference of two by .009, of 16 the "    \
    "worst by .02."

/* All bounds, by group. Two steps of an image of 8 bits are 1/128: what nobody sees. */
const struct aob_bound aob_bounds[] = {
    /* --- projection --- */
    {"plane_is_open", 0.005, 0.005,
     "Nothing occludes a plane; 1/255 is one step of an 8-bit image, rounded up."},
    {"plane_any_fov", 0.005, 0.005,
     "An open plane has no occluder; 1/255 is one step of an 8-bit image, rounded up."},
    {"scaled_by_two", 0, 1.0 / 255, "Powers of two change exponents only; a GPU may flush a denormal."},
    {"scaled_by_ten", STEP, STEP,
     "Depths and taps round otherwise, and one in thousands of taps falls on the next texel."},
    {"moved_far", STEP, STEP,
     "The eye is taken off in double precision, where 1e6 leaves 1e-10; taps may round otherwise."},
    {"tilted_plane", 0.005, 0.005,
     "A plane has no occluder, however it lies; 1/255 is one step of an 8-bit image, rounded up."},
    {"rotated_to_corner", 0.03, 0.03,
     "A ball 30 degrees off the axis covers an ellipse 1/cos = 1.15 as long; who samples a disc sees so much "
     "too far, which is "
     "15 % of what a block is occluded, .2 at most."},
    {"off_centre", STEP, STEP,
     "The rays are the same up to rounding, so one in thousands of taps falls on the next texel."},
    {"ortho_like_far", 0.02, 0.02,
     "Places differ by up to a third of a pixel, so one tap in five falls on the next texel, which is 1/13 "
     "of the radius: "
     "a fifth's root times 1/26."},
    {"ortho_slides", STEP, STEP,
     "Depths round otherwise, and one in thousands of taps falls on the next texel."},
    {"reversed_depth", STEP, STEP,
     "A step is z^2 / near / 2^24 at most, some 1e-6: a tap may fall on the next texel."},
    {"reversed_depth_ortho", STEP, STEP,
     "A step is (far - near) / 2^24, some 1e-6: a tap may fall on the next texel."},
    {"infinite_far", STEP, STEP, "A step is z / 2^24; sky is known by its value."},
    {"half_depth_far", 0.005, 0.005,
     "Powers of two round alike, and a plane has no occluder; 1/255 rounded up."},
    {"far_plane", STEP, STEP,
     "A step is z^2 / near / 2^24 with any far plane: a tap may fall on the next texel."},
    {"tiny_near", STEP, STEP, "A step is z / 2^24 with any near plane: a tap may fall on the next texel."},
    {"tiny_near_forward", 2 * STEP, 2 * STEP,
     "A step is z^2 / near / 2^24 = 1.5e-4 z, so that slopes between pixels, z / 69 apart, are off by .01 at "
     "most and .005 on "
     "average; a horizon that is so much higher closes .005."},
    {"depth_24_bits", STEP, STEP,
     "A step is z^2 / near / 2^24, some 1e-6: a tap may fall on the next texel."},
    {"optical_axis", 0.005, 0.005,
     "Nothing occludes a plane; 1/255 is one step of an 8-bit image, rounded up."},
    /* --- numbers --- */
    /* --- near --- */
    /* --- normals --- */
    /* --- resolution --- */
    /* --- edges --- */
    /* --- relations --- */
    {"mirrored", BLOCK, BLOCK, BLOCK_REASON},
    {"quarter_turn", BLOCK, BLOCK, BLOCK_REASON},
    {"camera_roll", BLOCK, BLOCK, BLOCK_REASON},
    {"more_radius_darkens", 1e-4, 1e-4,
     "Halves as which visibilities are held round by 1/4096, which is 1e-6 on average."},
    {"more_occluders_darken", 1e-4, 1e-4,
     "Halves as which visibilities are held round by 1/4096, which is 1e-6 on average."},
    {"convex_sphere", 0.005, 0.005,
     "Nothing rises above a tangent plane; 1/255 is one step of an 8-bit image, rounded up."},
    {"shifted_by_tile", BLOCK, BLOCK,
     "The mean of 4096 pixels that spread by .2, of which four at a time may be one, is off by .006, the "
     "difference of two by "
     ".009."},
    {"seed_does_not_shift_mean", 0.01, 0.01,
     "6000 pixels whose noise spreads by .2, a tile of 16 being repeated: 16 of 384 patches, .2 / 20."},
    /* --- instruments --- */
    {0},
};
