#include "causes.h"
#include <fcntl.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

/* The first line is enough, and a read of all of it takes milliseconds on a machine of hundreds of processors. */
int64_t aob_causes_read_steal(const char *path)
{
    char text[512];
    int64_t steal;
    int file = open(path, O_RDONLY | O_CLOEXEC);
    ssize_t size = file < 0 ? -1 : read(file, text, sizeof text - 1);
    if (file >= 0)
        close(file);
    if (size <= 0)
        return AOB_CAUSE_UNKNOWN;
    text[size] = '\0';
    bool found = strncmp(text, "cpu ", 4) == 0 &&
                 sscanf(text, "cpu %*u %*u %*u %*u %*u %*u %*u %" SCNd64, &steal) == 1 && steal >= 0;
    return found ? steal : AOB_CAUSE_UNKNOWN;
}

struct aob_causes aob_causes_now(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return (struct aob_causes){usage.ru_nivcsw, usage.ru_nvcsw, usage.ru_minflt, usage.ru_majflt,
                               aob_causes_read_steal("/proc/stat")};
}

/* A steal counter goes back on some hosts, as after a move of the machine. */
static int64_t difference(int64_t before, int64_t after)
{
    if (before == AOB_CAUSE_UNKNOWN || after == AOB_CAUSE_UNKNOWN || after < before)
        return AOB_CAUSE_UNKNOWN;
    return after - before;
}

struct aob_causes aob_causes_between(const struct aob_causes *before, const struct aob_causes *after)
{
    return (struct aob_causes){difference(before->involuntary, after->involuntary),
                               difference(before->voluntary, after->voluntary),
                               difference(before->minor_faults, after->minor_faults),
                               difference(before->major_faults, after->major_faults),
                               difference(before->steal_ticks, after->steal_ticks)};
}
