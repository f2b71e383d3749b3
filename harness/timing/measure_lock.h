/* One measuring process a machine: two that measure at a time would measure each other. The lock is held while a worker
 * of a timed block runs (the first of a block scores its images too), and not while views are traced or pages drawn. It is
 * a file that is locked and never removed: /run/lock/aobudget-measure.lock, or in /tmp where that folder takes no file of
 * ours; AOBUDGET_LOCK names another. Whoever ends without giving it back, by a crash or a signal, has given it back.
 *
 * A program that measures in many processes takes the lock for each of them. Between two of them all that wait have had it:
 * who wants it queues in a second file (the first's name and .turn, see measure_turn.h), and only who is first there asks
 * for the lock. Where that file cannot be made, written or locked, only the turns are lost. If who is first is stopped, the
 * others wait for it for AOB_MEASURE_LOCK_PATIENCE_MS each time that the lock is free. Threads: one, while no other makes
 * files: the umask is 0 for the moment in which a lock's file is made. */
#ifndef AOB_TIMING_MEASURE_LOCK_H
#define AOB_TIMING_MEASURE_LOCK_H
#include <stdbool.h>
#include "base/error.h"

enum {
    AOB_MEASURE_LOCK_STEP_MS = 20, /* between two questions whether it is our turn */
    AOB_MEASURE_LOCK_PATIENCE_MS =
        2000, /* with somebody whose turn it is and who does not take what is free */
};

struct aob_measure_lock { /* zeroed: not held */
    int file;
    bool held, told; /* told: that it is waited for, once */
};

/* Whether a lock can be had at all, now or after another process, so that a run fails at its start. */
bool aob_measure_lock_check(struct aob_error *error);

/* The first of these files (NULL-ended) that can be locked, open, and its path. -1 after a line if none can; also where one
 * is there already and cannot be used, as others may hold it. Close it. */
int aob_measure_lock_open(const char *const *files, const char **path, struct aob_error *error);

/* Waits for as long as it takes. The first time that it has to, one line on standard error says for whom. False with a
 * line if the file cannot be opened or the system refuses to lock it. */
bool aob_measure_lock_take(struct aob_measure_lock *lock, struct aob_error *error);
void aob_measure_lock_release(struct aob_measure_lock *lock);
#endif
