/* Clocks of this process. Thread-safe. */
#ifndef AOB_BASE_CLOCK_H
#define AOB_BASE_CLOCK_H
#include <stdbool.h>
#include <stdint.h>

int64_t aob_clock_wall_ns(void); /* monotonic */
int64_t
aob_clock_cpu_ns(void); /* processor time of all threads of this process, a software driver's included */

/* Whose time a cost is. */
enum aob_clock {
    AOB_CLOCK_CPU,    /* processor time of all threads: the work of a software device */
    AOB_CLOCK_WALL,   /* time that went by, submit and wake-up included */
    AOB_CLOCK_DEVICE, /* a device's own timestamps */
    AOB_CLOCK_COUNT
};
const char *aob_clock_name(enum aob_clock clock);             /* "cpu", "wall", "device" */
bool aob_clock_find(const char *name, enum aob_clock *clock); /* false: no clock of that name; NULL is none */
#endif
