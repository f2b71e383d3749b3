/* Timing of a block in one process: its cases' frames interleaved with the fixed reference pass, round by round, so that
 * drift and load fall on both sides of every ratio (docs/measuring.md says why). What several processes measure is put
 * together by processes.h. */
#ifndef AOB_TIMING_TIMING_H
#define AOB_TIMING_TIMING_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/error.h"
#include "frame/frame.h"
#include "rounds.h"

/* Where the figures of a block come from, so that a test can say what each frame costs. `user` is passed to each. */
struct aob_timing_source {
    /* As aob_frame_run. */
    bool (*run)(void *user, struct aob_frame *frame, int repeats, struct aob_frame_time *time,
                struct aob_error *error);
    struct aob_causes (*causes)(void *user); /* as aob_causes_now */
    void *user;
};

struct aob_timing_desc {
    struct aob_frame *fixed; /* the fixed reference pass; run twice a round (the second is the A/A control) */
    struct aob_frame *const *frames; /* frame_count cases, 1..AOB_BLOCK_MAX */
    size_t frame_count;
    double
        seconds; /* a case, of wall time inside the rounds: timing ends there even if an interval is still wide */
    double
        precision; /* share: timing ends early where each case's own interval is as narrow; 0: it does not */
    int process;   /* written into the rounds */
    uint32_t seed; /* of the order within rounds */
    enum aob_clock
        clock; /* that costs are judged by. Other than AOB_CLOCK_CPU: a device whose clocks rise under load */
    const struct aob_timing_source *source; /* NULL: the frame's device and this process */
};
enum { AOB_ROUNDS_LEAST = 2 }; /* a process */

/* Whether the process whose rounds begin at `first` and took `measured_s` has measured enough (4. below). For who has rounds
 * from elsewhere; aob_timing_run asks it itself. */
bool aob_timing_is_over(const struct aob_timing_desc *desc, const struct aob_round_list *rounds, size_t first,
                        double measured_s);

/* The first check point at so many rounds or more. */
size_t aob_timing_check_point(size_t rounds);

/* 1. Every slot runs one frame, twice: drivers compile at the first draw. 2. The fixed pass alone, until it is steady.
 * 3. Each slot is given its number of frames: a slot takes as long as the dearest frame, at least AOB_SLOT_LEAST_MS and
 * at most AOB_SLOT_MOST_MS, whatever its case costs. 4. Rounds, in seeded cyclic Latin squares, until every case's
 * interval is narrow enough at a check point (20, 30, 45, 67, 101, ... rounds) or time is up. Adds the rounds of 4 to
 * the list. */
#define AOB_SLOT_LEAST_MS 2.0
#define AOB_SLOT_MOST_MS  100.0
bool aob_timing_run(const struct aob_timing_desc *desc, struct aob_round_list *rounds,
                    struct aob_error *error);
#endif
