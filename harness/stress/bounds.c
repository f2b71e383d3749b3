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
    {"crease_to_corner", 0.03, 0.03,
     "Occlusion falls from its most to none over the radius, and a tap lies up to half a texel, 1/50 of the "
     "radius at least, "
     "from where it is read. Slices even in the image leave the crease .06 to .09 lighter there."},
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
     "Directions by lot are what a careless pattern reaches. Chosen: a tenth is left to samples of one "
     "direction that share its pixels."},
    {"optical_axis", 1.0 / 255, 1.0 / 255,
     "The plane is the same in all pixels; places are rounded otherwise."},
    {"filter_contains_nan", 0, 0, "A pixel that does not read the changed one computes what it did."},
    {"nan_depth", 0, 0, "A pixel that does not read the changed one computes what it did."},
    {"infinite_depth", 0, 0, "A pixel that does not read the changed one computes what it did."},
    {"negative_depth", 0, 0, "A pixel that does not read the changed one computes what it did."},
    {"zero_depth", 0, 0, "A pixel that does not read the changed one computes what it did."},
    {"denormal_depth", 0, 0, "A pixel that does not read the changed one computes what it did."},
    {"half_overflow", 0, 1.0 / 255, "Powers of two change exponents only; a GPU may flush a denormal."},
    {"repeats_itself", 0, 0, "The same program computes on the same numbers."},
    {"after_other_sizes", 0, 0, "The same program computes on the same numbers."},
    {"same_by_storage", 0, 1.0 / 255,
     "The arithmetic and the texels are the same; a GPU's compiler may round another text otherwise."},
    {"drawn_at_all", 0.75, 0.75,
     "Chosen: a text may count occlusion more weakly than the truth; black, white and grey have none of its "
     "contrast."},
    {"finite_everywhere", 0, 0, "An image is finite and in 0..1 or it is not."},
    /* --- near --- */
    {"approach_crease", 0.25, 0.25,
     "Chosen: few samples must find three quarters of the occlusion that the image shows; a search that "
     "gives up near the eye finds none."},
    {"closer_than_radius", 0.25, 0.25,
     "Chosen: few samples must find three quarters of the occlusion that the image shows; a search that "
     "gives up near the eye finds none."},
    {"behind_camera", 0.25, 0.25,
     "Chosen: the image cuts the larger ball off more, and three quarters of the occlusion must stay."},
    {"inside_box", 0.25, 0.25,
     "Chosen: few samples must find three quarters of the occlusion that the image shows; a search that "
     "gives up near the eye finds none."},
    /* --- normals --- */
    {"normal_encodings_plane", 1.0 / 255, 1.0 / 255,
     "One step of an 8-bit image; what the angle can do is taken off."},
    {"normal_encodings_image", 1.0 / 255, 1.0 / 255,
     "One step of an 8-bit image; what the angle can do is taken off."},
    {"zero_normal", 0, 0,
     "Half is left to one pixel's noise, which no filter takes; beyond its reach the same numbers are read."},
    {"nan_normal", 0, 0,
     "Half is left to one pixel's noise, which no filter takes; beyond its reach the same numbers are read."},
    {"flipped_normal", 1.0 / 255, 1.0 / 255,
     "Turned round they are the same bits; filters still read some of those that are seen from the side."},
    {"unnormalised_normal", 1.0 / 255, 1.0 / 255,
     "The normals are the same but for rounding, by which a tap may be another."},
    {"axial_normals", 0.1, 0.1,
     "Chosen: a tile of 4 x 4 patterns of 24 samples has 384, open or not, so that a mean is off by "
     "0.5/sqrt(384) = 0.026 at most; four of that, rounded down."},
    {"leaning_normals", 0.005, 0.005,
     "Nothing occludes a plane; 1/255 is one step of an 8-bit image, rounded up."},
    {"coarse_normals", 0.05, 0.05,
     "Chosen by others: three.js, Godot and ezEngine came to 0.95 where 1 is right before facets were no "
     "longer seen."},
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
     "At most a pixel of 49 has its value from one beside it; the 2 % are the source's."},
    {"quarter_size_mean", 0.02, 0.02,
     "At most three pixels of 49 have theirs from one beside; the 2 % are the source's."},
    {"half_size_drift", 0.5, 0.5,
     "Chosen: half way between a right centre, which is 0 but for noise, and a wrong one, which is 1."},
    {"phantom_depth", 1.0 / 255, 1.0 / 255,
     "Neither surface occludes the other; one step of an 8-bit image."},
    {"upsampled_edge", 0.02, 0.02,
     "Chosen: noise of 0.25 a pixel leaves some 0.01 in the mean of a dozen columns of 33 low pixels; this "
     "is twice that."},
    {"levels_in_pixels", 0.5, 0.5,
     "Chosen: squared spacing leaves a third of the taps within 10 of 96 pixels, where the finest level is "
     "right; who chooses no level by pixels has 1."},
    {"taps_follow_radius", 0.1, 0.1,
     "Half a pixel at the edge is a tenth of a reach of five pixels; a wrong unit halves or doubles it."},
    {"impulse_centred", 0.1, 0.1,
     "A filter that is its own mirror image moves nothing; chosen: a tenth of a pixel is left to noise."},
    {"impulse_transposed", 2, 2,
     "Chosen: four taps along one axis alone make it 3; two axes one after the other, which are no exact "
     "transpose, leave it well below that."},
    {"constant_kept", 0.001, 0.001, "A target of half floats rounds to 1/2048 below 1."},
    {"resolution_invariant", 1, 1,
     "It is in units of what may be: half a pixel along all rims makes 0.01, and noise of 0.25 a pixel over "
     "25 taps makes 0.05, twice."},
    {"size_continuous", 0.01, 0.01,
     "Rims move by at most half a pixel, so that 200 of 4000 pixels change by a quarter of 0.3, which is "
     ".004; chosen: twice that, rounded up."},
    /* --- edges --- */
    {"guard_crop", 0, 1.0 / 255,
     "The taps and the numbers are the same; a GPU may round another program's otherwise."},
    {"border_is_open", 0.005, 0.005, "A strip and the middle hold whole tiles of noise; 1/255, rounded up."},
    {"sky_is_open", 0, 0, "technique.h asks for 1 in the sky."},
    {"sky_only", 0, 0, "technique.h asks for 1 in the sky."},
    {"sky_rim", 1.0 / 255, 1.0 / 255,
     "Depths of another triangle differ in their last bit: a step of 8 bits."},
    {"step_edge_halo", 1.0 / 255, 1.0 / 255, "Nothing lies within the radius; one step of an 8-bit image."},
    {"thin_fence", 1.0 / 255, 1.0 / 255, "Nothing lies within the radius; one step of an 8-bit image."},
    {"thin_in_reach", 0.01, 0.01,
     "What a tap finds between bars it finds on a sheet; chosen: a hundredth is left to upsampling, which "
     "mixes other pixels."},
    {"pillar_round", 0.03, 0.03,
     "A tile of 16 pixels with 16 samples has 256 directions: a share is off by 1/32."},
    {"distant_terrain", 0.01, 0.01,
     "Chosen: nothing within a pixel can be told; this is two to three steps of an 8-bit image."},
    {"faces_alike", 0.03, 0.03,
     "A tile of 16 pixels with 16 samples has 256 directions: a share is off by 1/32."},
    {"degenerate_faces", 1.0 / 2048, 1.0 / 255,
     "In view space three corners on a line have the area of rounding; chosen: a half float's step below 1, "
     "the least that an image shows."},
    {"coincident_faces", 0, 1.0 / 255,
     "The second face covers what the first one covers; a GPU may blend in another order."},
    {"inverted_faces", 1.0 / 255, 1.0 / 255,
     "A tap may fall on the next texel where a depth's last bit differs."},
    {"tessellated_faces", 1.0 / 255, 1.0 / 255,
     "A tap may fall on the next texel where a depth's last bit differs."},
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
    /* --- directions --- */
    {"bent_on_plane", 0.12, 0.12,
     "Half floats round a component by 2^-12, which is .03 degrees, in the pass itself and in each of a "
     "filter's; nothing else "
     "is off on a plane."},
    {"bent_axial", 0.12, 0.12,
     "Half floats round a component by 2^-12, which is .03 degrees, in the pass itself and in each of a "
     "filter's; nothing else "
     "is off on a plane."},
    {"bent_in_crease", 0.5, 0.5, "Chosen: it is of use only if it is much nearer than the plain normal."},
    {"bent_keeps_visibility", 0, 1.0 / 2048,
     "The arithmetic is the same; a GPU may contract it otherwise, by one bit of a half float."},
    {"bent_is_finite", 0, 0, "They are finite and no longer than 1 or they are not."},
    /* --- instruments --- */
    {"tracer_plane_open", 0, 0,
     "Rays of a plane's hemisphere meet nothing; the tracer checks near hits again in double precision."},
    {"tracer_ball_open", 0, 0,
     "No ray above a face of a convex solid meets it; near hits are checked again in double precision."},
    {"tracer_box_closed", 0, 0,
     "Every ray meets a wall: there is no gap between triangles that share an edge."},
    {"tracer_corner", 0.01, 0.01,
     "Four standard errors of 192 pixels of 256 independent rays, 1/2 each at most, are 0.009; stratified "
     "ones have less."},
    {"tracer_wall", 0.01, 0.01,
     "Four standard errors of 192 pixels of 256 independent rays, 1/2 each at most, are 0.009; stratified "
     "ones have less."},
    {"tracer_sheet", 0.01, 0.01,
     "Four standard errors of 192 pixels of 256 independent rays, 1/2 each at most, are 0.009; stratified "
     "ones have less."},
    {"tracer_disc", 0.01, 0.01,
     "Four standard errors of 192 pixels of 256 independent rays, 1/2 each at most, are 0.009; stratified "
     "ones have less."},
    {"tracer_bent_is_normal", 0.005, 0.005,
     "Four standard errors of 1536 pixels of 256 independent rays, each 1/2 off along an axis, over a length "
     "of 2/3, are 0.0048."},
    {"tracer_radius_darkens", 0, 0,
     "The rays are the same, so that a longer one meets whatever a shorter one met."},
    {"tracer_occluder_darkens", 0, 0,
     "The rays are the same, so that each meets at least what it met before."},
    {"tracer_scaled_by_two", 0, 0,
     "Powers of two change exponents only, and the tracer brings every scene to one size."},
    {"tracer_moved", 1.0 / 255, 1.0 / 255,
     "Moving by 1e5 rounds doubles by 7e-12, which turns no more than the few rays that pass an edge: one "
     "step of 8 bits."},
    {"cache_larger_misses_less", 0, 0,
     "Misses are counted: what the smaller cache holds, the larger one holds too."},
    {"cache_cold_misses", 0, 0, "Misses are counted, and so are lines."},
    {"cache_of_one_line", 0, 0, "Misses are counted, and so are changes."},
    {"cache_plain_lru", 0, 0, "Each access is a hit or a miss in both, and there is no third."},
    {"cache_paths_agree", 0, 0, "They are one algorithm in several instruction sets."},
    {"cache_stack_agrees", 0, 0, "Both count what a fully associative cache misses."},
    {"model_clock_doubled", 1e-12, 1e-12, "Each resource is halved; a dozen roundings of 1e-16 remain."},
    {"model_more_work", 0, 0,
     "Sums, products, maxima and roots never fall as what goes in grows, rounding included."},
    {"model_each_resource", 1e-12, 1e-12,
     "It is the root of the sum of squares; a dozen roundings of 1e-16 remain."},
    {"model_band_ends", 1e-12, 1e-12,
     "They are the same sums and maxima; a dozen roundings of 1e-16 remain."},
    {"times_unit", 1e-12, 1e-12,
     "Times are divided by one another; roundings of 1e-16 pass through logarithms of 10 at most."},
    {"times_order", 1e-12, 1e-12, "Medians are the same; sums over processes are rounded in another order."},
    {"times_identical", 1e-12, 1e-12, "Nothing scatters but the rounding of the quotients."},
    {"times_level", 0, 0,
     "Quantiles rise with the level and fall with the degrees of freedom, by far more than they are "
     "rounded."},
    {"times_student", 1e-09, 1e-09,
     "The quantile is a root that is searched to the precision of a double; its slope loses some digits."},
    {"times_median_rank", 1e-12, 1e-12, "Binomial terms are exact but for their rounding."},
    {"times_interval_covers", 0.02, 0.02, "Four standard errors of 3600 draws that cover in 90 % are 0.02."},
    {0},
};
