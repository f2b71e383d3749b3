#include "clock.h"
#include <string.h>
#include <time.h>

static int64_t read_clock(clockid_t id)
{
    struct timespec t;
    clock_gettime(id, &t);
    return (int64_t)t.tv_sec * 1000000000 + t.tv_nsec;
}

int64_t aob_clock_wall_ns(void)
{
    return read_clock(CLOCK_MONOTONIC);
}

int64_t aob_clock_cpu_ns(void)
{
    return read_clock(CLOCK_PROCESS_CPUTIME_ID);
}

static const char *const names[AOB_CLOCK_COUNT] = {"cpu", "wall", "device"};

const char *aob_clock_name(enum aob_clock clock)
{
    return names[clock];
}

bool aob_clock_find(const char *name, enum aob_clock *clock)
{
    for (int i = 0; name && i < AOB_CLOCK_COUNT; i++)
        if (strcmp(name, names[i]) == 0) {
            *clock = (enum aob_clock)i;
            return true;
        }
    return false;
}
