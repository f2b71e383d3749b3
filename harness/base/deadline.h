/* The time limit of another process. It counts what the process does and not how busy the machine is: a limit that is
 * right on an idle machine is right on a busy one (docs/decisions/0017-time-limits-count-work.md). Linux only: it reads
 * /proc/PID/task. */
#ifndef AOB_BASE_DEADLINE_H
#define AOB_BASE_DEADLINE_H
#include <stdbool.h>
#include <stdint.h>
#include <sys/types.h>

struct aob_deadline {
    pid_t pid;
    double limit_s; /* 0: it never passes */
    int64_t start_ns, looked_ns, moved_ns;
    double worked_s;     /* processor time of all threads when it was last seen to do something */
    int64_t since_ns;    /* the begin of a stretch of three limits, and what is known of it */
    double since_work_s; /* processor time of all threads at its begin */
    int looks, awake_looks;
    bool passed;
    char text[64]; /* once it passed, which limit was met: "took longer than 10 s of work" */
};
void aob_deadline_init(struct aob_deadline *deadline, pid_t pid, double limit_s);

/* Not before `limit_s` of wall time. After that, when
 * - one of its threads has had `limit_s` of processor time, which on an idle machine takes `limit_s`; or
 * - nothing has happened in it for another `limit_s`, at most 10 s: all its threads sleep; or
 * - next to nothing has happened in it for three times `limit_s`: it had less than a twentieth of a processor, and slept at
 *   more than half of the looks, so it did not wait for one; or
 * - 20 times `limit_s` of wall time have gone by, whatever it does.
 * Cheap enough to be asked all the time: before `limit_s` it reads a clock, and after that it looks 20 times a second. */
bool aob_deadline_passed(struct aob_deadline *deadline);
#endif
