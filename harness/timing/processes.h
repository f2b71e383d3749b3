/* The timing of a block over several processes. One process says how its own rounds scatter, but not how its luck with
 * memory layout, compiled code and threads differs from another's, so there are always a few (docs/decisions). */
#ifndef AOB_TIMING_PROCESSES_H
#define AOB_TIMING_PROCESSES_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/error.h"
#include "rounds.h"

enum {
    AOB_PROCESSES_LEAST = 3,  /* fewer have no verdict */
    AOB_PROCESSES_MOST = 100, /* that are tried */
    AOB_PROCESSES_LOST = 2,   /* so many that fail end the timing */
    AOB_PROCESSES_ROUNDS = 20 /* of all together; fewer are precise by luck only */
};
#define AOB_PROCESS_SECONDS 0.25 /* of timing a case in one process, unless a hundred of them need more */
struct aob_process_desc {        /* one that is to be measured */
    int index;                   /* from 0, those that were lost counted */
    uint32_t seed;
    double seconds; /* of timing, a case */
};
struct aob_processes_desc {
    size_t case_count;
    int least;      /* good processes before it may end; 0: AOB_PROCESSES_LEAST */
    double seconds; /* a case: what is measured in all processes together, at most */
    double
        precision; /* share: no more processes are needed once every case's interval over processes is as narrow */
    uint32_t seed; /* each process has its own, made from this one and its index */
    /* Measures in a fresh process and adds its rounds. False after a line: the process is lost, and what it added is
     * dropped. */
    bool (*run)(void *user, const struct aob_process_desc *process, struct aob_round_list *rounds,
                struct aob_error *error);
    void (*on_lost)(void *user, int index, const char *reason);
    void *user;
};
struct aob_processes {
    struct aob_round_list rounds; /* of the good ones */
    int good, lost;
    double measured_s; /* wall time inside the rounds */
};

/* Runs processes until at least AOB_PROCESSES_LEAST are good and either the precision is reached or the seconds are
 * spent. A process gets a third of the seconds, but AOB_PROCESS_SECONDS at most (or a hundredth, where that is more): so
 * more seconds buy more processes, which is what intervals lack (docs/decisions/0030-short-processes.md). False after the
 * line of the last lost one if too few were good; aob_processes_finish frees in any case. */
bool aob_processes_run(const struct aob_processes_desc *desc, struct aob_processes *result,
                       struct aob_error *error);
void aob_processes_finish(struct aob_processes *processes);

/* The process of that index, for a caller that measures in it before the others are wanted. */
struct aob_process_desc aob_process_describe(const struct aob_processes_desc *desc, int index);

/* How many good ones it takes before the timing may end. */
int aob_processes_least(const struct aob_processes_desc *desc);

uint32_t aob_process_seed(uint32_t seed, int index);
#endif
