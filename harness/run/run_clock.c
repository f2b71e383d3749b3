#include "run_clock.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/error.h"
#include "base/member.h"
#include "base/memory.h"

const struct aob_run_clock *aob_run_clocks_find(const struct aob_run_clocks *clocks, const char *backend)
{
    for (size_t i = 0; i < clocks->count; i++)
        if (strcmp(clocks->items[i].backend, backend) == 0)
            return &clocks->items[i];
    return NULL;
}

void aob_run_clocks_keep(struct aob_run_clocks *clocks, const char *backend, enum aob_clock clock,
                         const char *reason)
{
    if (aob_run_clocks_find(clocks, backend))
        return;
    struct aob_run_clock *kept = AOB_PUSH(clocks->items, clocks->count, clocks->capacity);
    *kept = (struct aob_run_clock){.backend = backend, .clock = clock};
    snprintf(kept->reason, sizeof kept->reason, "%s", reason);
    if (*reason)
        aob_warn(
            "%s: costs are wall time, the way to the device and back included, as the device's own clock "
            "cannot be trusted: %s",
            backend, reason);
}

void aob_run_clocks_take(struct aob_run_clocks *clocks, const char *backend, const json_t *record)
{
    const json_t *time = json_object_get(record, "time");
    enum aob_clock clock;
    if (aob_clock_find(aob_member_text(time, "clock"), &clock))
        aob_run_clocks_keep(clocks, backend, clock, aob_member_text(time, "clock_reason"));
}

void aob_run_clocks_finish(struct aob_run_clocks *clocks)
{
    free(clocks->items);
    *clocks = (struct aob_run_clocks){0};
}
