/* How the properties of the group `numbers` are asked, by the file that holds them; the rows are in numbers.c. */
#ifndef AOB_STRESS_NUMBERS_H
#define AOB_STRESS_NUMBERS_H
#include "property.h"

/* extremes.c: lengths and parameters at their ends. */
void aob_ask_view_ray_sample(struct aob_trial *trial);
void aob_ask_radius_below_pixel(struct aob_trial *trial);
void aob_ask_radius_smallest(struct aob_trial *trial);
void aob_ask_radius_enormous(struct aob_trial *trial);
void aob_ask_falloff_ends(struct aob_trial *trial);
void aob_ask_gradation(struct aob_trial *trial);
void aob_ask_optical_axis(struct aob_trial *trial);
const char *aob_excuse_no_fade(const struct aob_subject *subject);

/* ends.c: every parameter at both of its ends. */
void aob_ask_parameter_ends(struct aob_trial *trial);

/* hostile.c: depths that no renderer should write, and some do. */
void aob_ask_filter_contains_nan(struct aob_trial *trial);
void aob_ask_nan_depth(struct aob_trial *trial);
void aob_ask_infinite_depth(struct aob_trial *trial);
void aob_ask_negative_depth(struct aob_trial *trial);
void aob_ask_zero_depth(struct aob_trial *trial);
void aob_ask_denormal_depth(struct aob_trial *trial);

/* again.c: the same image drawn another way, and whether there is one at all. */
void aob_ask_half_overflow(struct aob_trial *trial);
void aob_ask_repeats_itself(struct aob_trial *trial);
void aob_ask_after_other_sizes(struct aob_trial *trial);
void aob_ask_same_by_storage(struct aob_trial *trial);
void aob_ask_drawn_at_all(struct aob_trial *trial);
void aob_ask_finite_everywhere(struct aob_trial *trial);

/* taps.c: which texels an invocation reads. */
void aob_ask_distinct_taps(struct aob_trial *trial);
#endif
