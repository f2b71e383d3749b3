/* Clocks of this process. Thread-safe. */
#ifndef AOB_BASE_CLOCK_H
#define AOB_BASE_CLOCK_H
#include <stdint.h>

int64_t aob_clock_wall_ns(void); /* monotonic */
int64_t
aob_clock_cpu_ns(void); /* processor time of all threads of this process, a software driver's included */

/* Involuntary context switches of this process so far: a wall time is clean if this did not change. */
int64_t aob_clock_preemptions(void);
#endif
