/* The time of one technique on a device, in one process: a block of one case (timing/timing.h), and what gpu-check says of
 * its rounds. */
#ifndef AOB_GPU_CHECK_TRIAL_H
#define AOB_GPU_CHECK_TRIAL_H
#include "base/clock.h"
#include "base/statistics.h"
#include "frame/frame.h"

struct aob_trial_desc {
    struct aob_frame *fixed, *frame; /* on one device */
    enum aob_clock clock;
    double seconds;   /* inside the rounds; */
    double precision; /* they end earlier where the ratio's interval is within this share at a check point */
};

struct aob_trial_time { /* milliseconds a frame: the median of the rounds and its 95 % interval */
    double ms, low,
        high; /* low and high NAN for fewer than six rounds; all NAN where the clock saw nothing */
};
struct aob_trial {
    size_t rounds;                                            /* at least two */
    int frames;                                               /* a slot of the technique */
    struct aob_trial_time whole, fixed, passes[AOB_MAX_PASS]; /* passes: those that are not pruned */
    double
        passes_share; /* the sum of the passes over the whole: the median of the rounds; NAN where a pass has no time */
    struct aob_ratio to_fixed, control; /* of the technique, and of the fixed pass again, to the fixed pass */
};
bool aob_trial_run(const struct aob_trial_desc *desc, struct aob_trial *trial, struct aob_error *error);
#endif
