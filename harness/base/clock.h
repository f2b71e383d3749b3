/* Clocks of this process. Thread-safe. */
#ifndef AOB_BASE_CLOCK_H
#define AOB_BASE_CLOCK_H
#include <stdint.h>

int64_t aob_clock_wall_ns(void); /* monotonic */
int64_t
aob_clock_cpu_ns(void); /* processor time of all threads of this process, a software driver's included */

/* The number of involuntary context switches of this process so far. A wall time is clean if it did not change
 * meanwhile. */
int64_t aob_clock_preemptions(void);
#endif
