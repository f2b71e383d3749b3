/* A block on a scripted clock: nothing is drawn, the script says what each frame costs, and keeps the order in which slots
 * came. A script is one process; struct script_processes runs one for each that is asked for. */
#ifndef AOB_TESTS_TIMING_SCRIPT_H
#define AOB_TESTS_TIMING_SCRIPT_H
#include <stdbool.h>
#include <stdint.h>
#include "timing/processes.h"
#include "timing/timing.h"

enum {
    SCRIPT_CASES = 3,
    SCRIPT_SLOTS = SCRIPT_CASES + 2,
    SCRIPT_RUNS_MAX = 20000,
    SCRIPT_WARM_UP = 3 /* slots of a case before its rounds: two of one frame, one to count frames by */
};

struct script {
    int process; /* for the functions below */
    struct aob_frame *fixed, *frames[SCRIPT_CASES];
    /* Milliseconds of a frame of case `index` in round `round` (negative: before the rounds). NULL: 4. */
    double (*cpu_ms)(const struct script *script, int index, int round);
    double (*wall_ms)(const struct script *script, int index, int round); /* NULL: twice the processor time */
    /* What happens during a slot of the case; NULL: nothing. */
    struct aob_causes (*cause)(const struct script *script, int index, int round);
    bool device;     /* it has a clock of its own, by which all takes three times the processor time */
    double fixed_ms; /* of a frame of the fixed pass; 0: 2 */
    double settling_ms[SCRIPT_RUNS_MAX]; /* in place of that for each of its slots, in order; 0: that */
    int fixed_runs, runs[SCRIPT_CASES];  /* slots so far */
    int order[SCRIPT_RUNS_MAX], repeats[SCRIPT_RUNS_MAX],
        count;                /* of each slot: -1 the fixed pass, else the case; */
    struct aob_causes causes; /* its frames; counts so far */
};

struct script *script_create(void); /* of frames with 1, 2, 3 passes; the fixed pass has one */
void script_destroy(struct script *script);
struct aob_timing_source script_source(struct script *script);

/* Times the script's cases (all, if the desc names no number) to 3 % (if it names none); aob_rounds_finish frees. The
 * second only counts the rounds. */
struct aob_round_list script_measure(struct script *script, struct aob_timing_desc desc);
size_t script_count_rounds(struct script *script, struct aob_timing_desc desc);
#define SCRIPT_ENDLESS 1e9 /* seconds */

/* The block's first `case_count` cases (0: all), in every process that `run` of struct aob_processes_desc asks for. */
struct script_processes {
    double (*cpu_ms)(const struct script *script, int index, int round);
    struct aob_causes (*cause)(const struct script *script, int index, int round);
    size_t case_count;
    double precision; /* of a process by itself */
    const char *
        fate; /* of each process by its index: 'x' fails, '0' gives no rounds, '?' those of another block; NULL or behind
                         its end: good */
    struct aob_process_desc asked[AOB_PROCESSES_MOST];
    int count;
    char told[200]; /* "INDEX: REASON; " of each that was lost */
};
bool script_process(void *processes, const struct aob_process_desc *process, struct aob_round_list *rounds,
                    struct aob_error *error);
void script_lost(void *processes, int index, const char *reason);
#endif
