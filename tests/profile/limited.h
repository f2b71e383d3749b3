/* A machine with less memory: what `ulimit -m` sets, which no kernel enforces. */
#ifndef AOB_TESTS_PROFILE_LIMITED_H
#define AOB_TESTS_PROFILE_LIMITED_H
#include <sys/resource.h>

static inline void limit_memory(rlim_t bytes) /* RLIM_INFINITY: as it was */
{
    struct rlimit limit;
    getrlimit(RLIMIT_RSS, &limit);
    limit.rlim_cur = bytes < limit.rlim_max ? bytes : limit.rlim_max;
    setrlimit(RLIMIT_RSS, &limit);
}
#endif
