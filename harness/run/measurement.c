#include "measurement.h"
#include <stdlib.h>
#include <sys/random.h>
#include "base/clock.h"
#include "base/memory.h"

/* Cases of one view and guard band together, else in the plan's order. */
static int by_view(const void *a, const void *b, void *user)
{
    const struct aob_case *cases = user;
    size_t i = *(const size_t *)a, j = *(const size_t *)b;
    const struct aob_case *p = &cases[i], *q = &cases[j];
    if (p->scene != q->scene)
        return p->scene < q->scene ? -1 : 1;
    if (p->width != q->width)
        return p->width < q->width ? -1 : 1;
    if (p->height != q->height)
        return p->height < q->height ? -1 : 1;
    int guard = aob_case_options(p).guard_band - aob_case_options(q).guard_band;
    if (guard)
        return guard;
    return (i > j) - (i < j);
}

static void sort_by_view(struct aob_measurement *m)
{
    size_t count = m->plan->case_count;
    m->by_view = AOB_NEW_ARRAY(size_t, count);
    m->place = AOB_NEW_ARRAY(size_t, count);
    for (size_t i = 0; i < count; i++)
        m->by_view[i] = i;
    qsort_r(m->by_view, count, sizeof *m->by_view, by_view, m->plan->cases);
    for (size_t i = 0; i < count; i++)
        m->place[m->by_view[i]] = i;
}

bool aob_measurement_init(struct aob_measurement *m, const struct aob_dispatch *dispatch,
                          struct aob_plan *plan, struct aob_error *error)
{
    *m = (struct aob_measurement){.dispatch = dispatch, .plan = plan, .failed_views = json_object()};
    m->states = AOB_NEW_ARRAY(struct aob_state, plan->case_count);
    sort_by_view(m);
    if (getrandom(&m->seed, sizeof m->seed, 0) != sizeof m->seed)
        m->seed = (uint32_t)aob_clock_wall_ns();
    if ((!plan->config->measure_time || aob_measure_lock_check(error)) && aob_cache_open(&m->cache, error))
        return true;
    aob_measurement_finish(m);
    return false;
}

void aob_measurement_finish(struct aob_measurement *m)
{
    for (size_t i = 0; m->states && i < m->plan->case_count; i++) {
        json_decref(m->states[i].definition);
        json_decref(m->states[i].stored);
    }
    free(m->states);
    free(m->by_view);
    free(m->place);
    json_decref(m->failed_views);
    aob_cache_close(&m->cache);
    aob_run_clocks_finish(&m->clocks);
    *m = (struct aob_measurement){0};
}
