/* What the group `resolution` asks, by the file that asks it. */
#ifndef AOB_STRESS_RESOLUTION_H
#define AOB_STRESS_RESOLUTION_H
#include "trial.h"

/* sizes.c: images of every size. */
void aob_ask_sizes_thin(struct aob_trial *trial);
void aob_ask_sizes_half(struct aob_trial *trial);
void aob_ask_centre_line(struct aob_trial *trial);
void aob_ask_size_continuous(struct aob_trial *trial);
void aob_ask_resolution_invariant(struct aob_trial *trial);
void aob_ask_taps_follow_radius(struct aob_trial *trial);

/* divided.c: half and quarter size, sampled up. */
void aob_ask_half_size_mean(struct aob_trial *trial);
void aob_ask_quarter_size_mean(struct aob_trial *trial);
void aob_ask_half_size_drift(struct aob_trial *trial);
void aob_ask_phantom_depth(struct aob_trial *trial);
void aob_ask_upsampled_edge(struct aob_trial *trial);

/* filters.c: blurs. */
void aob_ask_impulse_centred(struct aob_trial *trial);
void aob_ask_impulse_transposed(struct aob_trial *trial);
void aob_ask_constant_kept(struct aob_trial *trial);

/* levels.c: levels of depth. */
void aob_ask_levels_in_pixels(struct aob_trial *trial);
const char *aob_excuse_one_level(const struct aob_subject *subject);

/* The camera at (0, 0, 3) that looks along -Z, whose pixels are as large at every height of the image: at depth 3 some .054
 * units. A radius of 0.5 is some 9 of them. */
struct aob_camera aob_resolution_camera(int height);
/* Before it a wall z = 0, far larger than what is seen. */
void aob_resolution_wall(struct aob_mesh *mesh);
/* A box 0.5 wide and high and 0.25 deep that stands on that wall, in the middle of the image. */
struct aob_exhibit *aob_resolution_box(struct aob_trial *trial, int width, int height);

/* The middle of the wall's darkness within a radius of that box, pixels from the middle of the image, and how much darkness
 * there is: the middle is of no use where that is not 1 or more. */
struct aob_resolution_middle {
    double x, y, dark;
};
struct aob_resolution_middle aob_resolution_middle_of(const struct aob_shot *shot, const float *image);
/* Where the first image, which nothing has blurred or divided yet, shows too little darkness, there is nothing to ask. Where
 * a later one does, it has lost it. */
void aob_resolution_hold(struct aob_trial *trial, const struct aob_shot *shot, const float *image,
                         const struct aob_resolution_middle *middle, bool first);

/* The least value of an image's surfaces; NAN of none. */
double aob_resolution_darkest(const struct aob_exhibit *exhibit, const float *image, const bool *mask);
#endif
