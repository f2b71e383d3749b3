#include "machine.h"
#include <sched.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

void aob_machine_processor(char *name, size_t size)
{
    FILE *file = fopen("/proc/cpuinfo", "r");
    char line[512];
    snprintf(name, size, "unknown");
    while (file && fgets(line, sizeof line, file)) {
        char *value = strchr(line, ':');
        if (strncmp(line, "model name", 10) != 0 || !value)
            continue;
        value[strcspn(value, "\n")] = '\0';
        snprintf(name, size, "%s", value + 2);
        break;
    }
    if (file)
        fclose(file);
}

/* A limit of the container, as the two versions of control groups have it; "max" and what is missing are none. */
static size_t read_limit(const char *path)
{
    FILE *file = fopen(path, "re");
    unsigned long long bytes = 0;
    bool found = file && fscanf(file, "%llu", &bytes) == 1;
    if (file)
        fclose(file);
    return found && bytes ? bytes : SIZE_MAX;
}

/* The kernel does not hold RLIMIT_RSS, which is what `ulimit -m` sets; we do. */
static size_t own_limit(__rlimit_resource_t resource)
{
    struct rlimit limit;
    return getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY ? limit.rlim_cur : SIZE_MAX;
}

size_t aob_machine_memory(void)
{
    const size_t limits[] = {(size_t)sysconf(_SC_PHYS_PAGES) * (size_t)sysconf(_SC_PAGESIZE),
                             read_limit("/sys/fs/cgroup/memory.max"),
                             read_limit("/sys/fs/cgroup/memory/memory.limit_in_bytes"), own_limit(RLIMIT_RSS),
                             own_limit(RLIMIT_AS)};
    size_t least = SIZE_MAX;
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++)
        least = limits[i] < least ? limits[i] : least;
    return least;
}

int aob_machine_cores(void)
{
    cpu_set_t set;
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}
