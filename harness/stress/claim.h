/* What a technique claims, traced: its own weighting, radius, falloff and map, as the runs score it. Threads: as a trial. */
#ifndef AOB_STRESS_CLAIM_H
#define AOB_STRESS_CLAIM_H
#include "trial.h"

enum aob_claim_of {
    AOB_CLAIM_OF_SCENE, /* all that there is */
    AOB_CLAIM_OF_IMAGE, /* only what the image shows of it, as surfaces without thickness (reference/bound.h) */
};

/* The claim of the shot's values in every pixel, from `spp` rays (an even number). NULL, after an excuse, where the
 * technique claims nothing that can be traced. */
float *aob_claim_trace(struct aob_trial *trial, const struct aob_shot *shot, enum aob_claim_of of, int spp);

/* The same with the mean open directions, from the same rays; a map does not count for those. */
struct aob_open aob_claim_trace_open(struct aob_trial *trial, const struct aob_shot *shot,
                                     enum aob_claim_of of, int spp);

/* What it claims where nothing occludes: 1, or what its map makes of that. NAN after a line in the trial. */
double aob_claim_open(struct aob_trial *trial, const struct aob_shot *shot);
#endif
