/* Properties of projection.c that are about how a depth buffer holds depths. */
#ifndef AOB_STRESS_DEPTHS_H
#define AOB_STRESS_DEPTHS_H
#include "trial.h"

void aob_depths_ask_reversed(struct aob_trial *trial);
void aob_depths_ask_reversed_ortho(struct aob_trial *trial);
void aob_depths_ask_infinite_far(struct aob_trial *trial);
void aob_depths_ask_half_far(struct aob_trial *trial);
void aob_depths_ask_far_plane(struct aob_trial *trial);
void aob_depths_ask_tiny_near(struct aob_trial *trial);
void aob_depths_ask_tiny_near_forward(struct aob_trial *trial);
void aob_depths_ask_24_bits(struct aob_trial *trial);
#endif
