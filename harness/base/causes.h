/* What disturbs a measurement: counts of this process and of the machine, read before and after it. A round is judged by
 * them and never by its own value. */
#ifndef AOB_BASE_CAUSES_H
#define AOB_BASE_CAUSES_H
#include <stdint.h>

struct
    aob_causes { /* of all threads of this process, but for the last; AOB_CAUSE_UNKNOWN where it is not known */
    int64_t involuntary, voluntary;     /* context switches (getrusage) */
    int64_t minor_faults, major_faults; /* of pages */
    int64_t steal_ticks; /* that the host took from the processors of this machine while they wanted to run */
};
enum { AOB_CAUSE_UNKNOWN = -1 };

struct aob_causes aob_causes_now(void);
struct aob_causes aob_causes_between(const struct aob_causes *before, const struct aob_causes *after);

/* The eighth number of the first line of a file in the form of /proc/stat; AOB_CAUSE_UNKNOWN if there is no such file or
 * no such number, as on old kernels and in some containers. */
int64_t aob_causes_read_steal(const char *path);
#endif
