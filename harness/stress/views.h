/* Properties of projection.c that look at one scene through two cameras. */
#ifndef AOB_STRESS_VIEWS_H
#define AOB_STRESS_VIEWS_H
#include "trial.h"

void aob_views_ask_moved_far(struct aob_trial *trial);
void aob_views_ask_ortho_like_far(struct aob_trial *trial);
void aob_views_ask_ortho_slides(struct aob_trial *trial);
void aob_views_ask_off_centre(struct aob_trial *trial);
void aob_views_ask_rotated_to_corner(struct aob_trial *trial);
void aob_views_ask_crease_to_corner(struct aob_trial *trial);
#endif
