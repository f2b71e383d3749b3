/* A block on a scripted clock: nothing is drawn, the script says what each frame of each round costs, and keeps the
 * order in which the frames came. */
#ifndef AOB_TESTS_TIMING_SCRIPT_H
#define AOB_TESTS_TIMING_SCRIPT_H
#include <stdbool.h>
#include <stdint.h>
#include "timing/timing.h"

enum { SCRIPT_CASES = 3, SCRIPT_SLOTS = SCRIPT_CASES + 2, SCRIPT_RUNS_MAX = 20000, SCRIPT_WARM_UP = 2 };

struct script {
    struct aob_frame *fixed, *frames[SCRIPT_CASES];
    /* Milliseconds of case `index` in round `round` (negative: of the warm-up). NULL: 4. */
    double (*cpu_ms)(int index, int round);
    double (*wall_ms)(int index, int round); /* NULL: twice the processor time */
    bool (*preempted)(int index, int round); /* NULL: never */
    double fixed_ms[SCRIPT_RUNS_MAX];        /* of each frame of the fixed pass, in order; 0: 2 */
    int fixed_runs, runs[SCRIPT_CASES], order[SCRIPT_RUNS_MAX],
        count; /* order: -1 the fixed pass, else the case */
    int64_t now, preemptions;
};

struct script *script_create(void); /* of frames with 1, 2, 3 passes; the fixed pass has one */
void script_destroy(struct script *script);
struct aob_timing_clock script_clock(struct script *script);
#endif
