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
    /* --- resolution --- */
    /* --- edges --- */
    /* --- relations --- */
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
