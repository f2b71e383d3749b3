/* The time of one technique on a device: rounds of the fixed pass, the fixed pass again, and the technique, in turning order,
 * in one process. Each slot of a round holds as many frames as make it long enough for the clock. */
#ifndef AOB_GPU_CHECK_TRIAL_H
#define AOB_GPU_CHECK_TRIAL_H
#include "base/clock.h"
#include "base/statistics.h"
#include "frame/frame.h"

struct aob_trial_desc {
    struct aob_frame *fixed, *frame; /* on one device */
    enum aob_clock clock;
    bool ramps;     /* the device's frequency rises with its load: it gets a fifth of a second of it first */
    double seconds; /* it ends then, or when the ratio's interval is within 1 % after 20 rounds or more */
};
enum { AOB_TRIAL_ROUNDS = 100 }; /* at most */

struct aob_trial_time {   /* milliseconds a frame: the median of the rounds and its 95 % interval */
    double ms, low, high; /* low and high NAN for fewer than six rounds */
};
struct aob_trial {
    size_t rounds; /* at least one */
    int frames;    /* a slot of the technique */
    struct aob_trial_time whole, fixed, passes[AOB_MAX_PASS];
    double passes_share;                /* the sum of the passes over the whole: the median of the rounds */
    struct aob_ratio to_fixed, control; /* of the technique, and of the fixed pass again, to the fixed pass */
};
bool aob_trial_run(const struct aob_trial_desc *desc, struct aob_trial *trial, struct aob_error *error);
#endif
