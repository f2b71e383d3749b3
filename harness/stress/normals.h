/* The askers of the group `normals`; its table is in normals.c. */
#ifndef AOB_STRESS_NORMALS_H
#define AOB_STRESS_NORMALS_H
#include "trial.h"

/* normals_encoded.c: how a G-buffer holds them. */
void aob_ask_encodings_plane(struct aob_trial *trial);
void aob_ask_encodings_image(struct aob_trial *trial);

/* normals_odd.c: what is no unit vector towards the camera. */
void aob_ask_zero_normal(struct aob_trial *trial);
void aob_ask_nan_normal(struct aob_trial *trial);
void aob_ask_flipped_normal(struct aob_trial *trial);
void aob_ask_unnormalised_normal(struct aob_trial *trial);

/* normals_leaning.c: those of a surface other than the one that the depth shows. */
void aob_ask_axial_normals(struct aob_trial *trial);
void aob_ask_leaning_normals(struct aob_trial *trial);
void aob_ask_coarse_normals(struct aob_trial *trial);
void aob_ask_mapped_plane(struct aob_trial *trial);

/* normals_derived.c: those that each reader makes from the depth. */
void aob_ask_derived_at_step(struct aob_trial *trial);
void aob_ask_derived_at_border(struct aob_trial *trial);
void aob_ask_derived_plane(struct aob_trial *trial);
#endif
