/* Timing of a block: its cases' frames interleaved with the fixed reference pass, round by round, so that
 * drift and load fall on both sides of every ratio (docs/measuring.md says why). */
#ifndef AOB_TIMING_TIMING_H
#define AOB_TIMING_TIMING_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/error.h"
#include "frame/frame.h"
#include "plan/plan.h"
#include "base/statistics.h"

/* Where the times of a block come from, so that a test can say what each frame costs. `user` is passed to each. */
struct aob_timing_clock {
    /* As aob_frame_run. */
    bool (*run)(void *user, struct aob_frame *frame, int repeats, struct aob_frame_time *time,
                struct aob_error *error);
    int64_t (*now_ns)(void *user);      /* monotonic; it ends the rounds */
    int64_t (*preemptions)(void *user); /* as aob_clock_preemptions */
    void *user;
};

struct aob_timing_desc {
    struct aob_frame *fixed; /* the fixed reference pass; run twice a round (the second is the A/A control) */
    struct aob_frame *const *frames; /* frame_count cases, 1..AOB_BLOCK_MAX */
    size_t frame_count;
    double seconds; /* a case; timing stops there even if the interval is still wide */
    double narrow;  /* share that an interval may reach to either side for timing to end early; 0: 0.03 */
    uint32_t seed;  /* of the order within rounds */
    bool wall;      /* judge by wall time (a real GPU), else by processor time */
    const struct aob_timing_clock *clock; /* NULL: the frame's device and this process's clocks */
};
enum { AOB_ROUNDS_MAX = 230 };

struct aob_timing {                   /* of one case; milliseconds a frame */
    double cpu_ms, wall_ms;           /* medians over rounds; wall over clean rounds, NAN if there is none */
    struct aob_ratio to_fixed;        /* paired ratio to the fixed pass */
    size_t rounds, clean_rounds;      /* clean: no involuntary context switch during the case's frames */
    double pass_cpu_ms[AOB_MAX_PASS]; /* medians */
    struct aob_ratio pass_to_fixed[AOB_MAX_PASS]; /* paired ratios of processor time to the fixed pass */
    double measured_s;                            /* wall time inside measured frames, all rounds */
};
struct aob_block_timing {
    struct aob_timing cases[AOB_BLOCK_MAX];
    struct aob_ratio control; /* fixed pass against itself: what this block cannot resolve */
    double fixed_cpu_ms;
    double fixed_s; /* wall time inside the fixed pass, all rounds */
};

/* Warm-up (two rounds, then the fixed pass until it is steady; drivers compile at the first draw), then
 * rounds in a seeded cyclic order until every ratio's 95 % interval is narrow enough at a check point (20, 30,
 * 45, 67, 101, 151, 227 rounds) or time is up. */
bool aob_timing_run(const struct aob_timing_desc *desc, struct aob_block_timing *result,
                    struct aob_error *error);
#endif
