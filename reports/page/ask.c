#include "ask.h"
#include <math.h>
#include <string.h>
#include "base/member.h"

struct aob_ask aob_ask_of(const struct aob_budget *budget)
{
    return (struct aob_ask){.ms = NAN,
                            .budget = budget,
                            .error = budget->error,
                            .profile = budget->device,
                            .radius = NAN,
                            .width = budget->width,
                            .height = budget->height};
}

bool aob_ask_is_about(const struct aob_ask *ask, const json_t *record)
{
    bool scene = !ask->scene || strcmp(ask->scene, aob_member_text(record, "scene")) == 0;
    bool size = !ask->width || (aob_member_number(record, "width") == ask->width &&
                                aob_member_number(record, "height") == ask->height);
    return scene && size;
}

bool aob_ask_has(const struct aob_ask *ask, const json_t *record)
{
    return aob_ask_is_about(ask, record) && strcmp(aob_member_text(record, "status"), "ok") == 0;
}

static bool is_of(const json_t *record, const char *technique)
{
    return strcmp(aob_member_text(record, "technique"), technique) == 0;
}

bool aob_ask_may_choose(const json_t *record)
{
    return !is_of(record, "none") && !is_of(record, "deferred");
}

struct aob_interval aob_ask_cost(const struct aob_ask *ask, const json_t *record)
{
    return ask->profile ? aob_costs_modelled(record, ask->profile) : aob_costs_measured(record);
}

static double upper(const struct aob_interval *interval)
{
    return isfinite(interval->high) ? interval->high : interval->at;
}

void aob_ask_take_frame(const struct aob_ask *ask, const json_t *record, struct aob_interval *frame)
{
    struct aob_interval own = aob_ask_cost(ask, record);
    if (!is_of(record, "deferred") || !aob_ask_has(ask, record) || !isfinite(own.at))
        return;
    bool bounded = isfinite(frame->high) || isfinite(own.high);
    *frame = (struct aob_interval){fmax(frame->at, own.at), fmax(frame->low, own.low),
                                   bounded ? fmax(upper(frame), upper(&own)) : INFINITY};
}

double aob_ask_ms(const struct aob_ask *ask, const struct aob_interval *frame)
{
    if (!ask->budget)
        return ask->ms;
    return aob_budget_left(ask->budget, isfinite(frame->at) ? upper(frame) : 0);
}
