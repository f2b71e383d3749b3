/* Whether a device's own clock tells the truth. Drivers have been found whose timestamps see a fraction of the work: those of
 * llvmpipe's GL tell the time of the last tile of a pass. So nothing is judged by a device's clock before it has timed work of
 * known ratio, in the ways that it is used later: single passes, lists of passes, repeated passes; and has agreed with the
 * host's clock, which encloses it. */
#ifndef AOB_TIMING_TIMER_H
#define AOB_TIMING_TIMER_H
#include <stdbool.h>
#include <stddef.h>
#include "base/clock.h"
#include "base/error.h"
#include "gpu/gpu.h"

struct aob_timer_check {
    const char *what;                     /* "four times the area" */
    double measured, expected, low, high; /* good from low to high; measured: NAN if no time passed */
};
enum { AOB_TIMER_CHECKS = 7, AOB_TIMER_ROUNDS = 15 };
struct aob_timer {
    bool trusted;
    char why_not[256];                               /* one sentence; empty if trusted */
    struct aob_timer_check checks[AOB_TIMER_CHECKS]; /* zeros where there is no clock to check */
    double pass_ms;                                  /* of the smallest pass, by the host's clock */
};

/* The device must run lists (struct aob_gpu): open a software device `as_gpu`. It takes about a second, of which 300 ms are a
 * load that its frequency may rise with, and four megabytes on the device. False, with a
 * line, if the device fails or the host's own clock stands still; a device's clock that lies is no failure.
 *
 * Everything is the median of the rounds. A share is what the device sees of what the host sees of the same submits: 0.8 ..
 * 1.02 of it, as the way there and back takes some of 16 ms or more, and two clocks of one machine drift by less than 2 %.
 * So half of the time, or another unit, is found. Growth from one work to another is taken in the host's: on a busy machine
 * twice the work does not take twice the time, but both clocks say so. It may be off by 1.25, as two shares may be; a clock
 * that sees one tile, or a constant, is off by 2. The two passes of a list cannot be told apart by the host, so load is in
 * their ratio, which may be off by 2.5; a clock that shows a pass the one before it turns it over. The passes of a list fill
 * 0.9 .. 1.02 of it: between them lie stamps and changes of layout. */
bool aob_timer_test(struct aob_gpu *gpu, struct aob_timer *timer, struct aob_error *error);

/* Whose time the costs on a device are: of a software device the processor's, which does the work, and never its on any
 * other, where it only waits; there the device's own, if that passes the test, else wall time. False as above. */
struct aob_timer_choice {
    enum aob_clock clock;
    char reason[256]; /* one sentence: why it is wall time; else empty */
};
bool aob_timer_choose(struct aob_gpu *gpu, struct aob_timer_choice *choice, struct aob_error *error);
#endif
