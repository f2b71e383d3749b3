#include "costs.h"
#include <math.h>
#include <string.h>
#include "base/member.h"
#include "base/statistics.h"

static const struct aob_interval unknown = {NAN, NAN, NAN};

/* A clock of a record, where its time stands, and what people call it. */
static const struct clock {
    const char *name, *member, *title;
} clocks[] = {{"device", "device_ms", "device time"},
              {"wall", "wall_ms", "wall time"},
              {"cpu", "cpu_ms", "processor time"}};

static const struct clock *clock_of(const json_t *time)
{
    const char *name = aob_member_text(time, "clock");
    const struct clock *clock = clocks;
    while (strcmp(clock->name, "cpu") != 0 && strcmp(clock->name, name) != 0)
        clock++;
    return clock;
}

const char *aob_costs_member(const json_t *time)
{
    return clock_of(time)->member;
}

double aob_costs_ms(const json_t *time)
{
    return aob_member_number(time, aob_costs_member(time));
}

const char *aob_costs_clock(const json_t *time)
{
    return clock_of(time)->title;
}

static struct aob_ratio read_ratio(const json_t *time)
{
    struct aob_ratio ratio = {aob_member_number(time, "ratio_to_ref"), aob_member_number(time, "ci_low"),
                              aob_member_number(time, "ci_high"), false};
    ratio.bounded =
        ratio.low > 0 && ratio.low <= ratio.ratio && ratio.ratio <= ratio.high && isfinite(ratio.high);
    return ratio;
}

static struct aob_interval open_at(double at)
{
    return (struct aob_interval){at, 0, INFINITY};
}

struct aob_interval aob_costs_measured(const json_t *record)
{
    const json_t *time = json_object_get(record, "time");
    struct aob_ratio ratio = read_ratio(time);
    double ms = aob_costs_ms(time);
    if (!(ms > 0) || !isfinite(ms))
        return unknown;
    if (!ratio.bounded)
        return open_at(ms);
    return (struct aob_interval){ms, ms * (ratio.low / ratio.ratio), ms * (ratio.high / ratio.ratio)};
}

struct aob_interval aob_costs_to_none(const json_t *record, const json_t *none)
{
    struct aob_ratio own = read_ratio(json_object_get(record, "time")),
                     floor = read_ratio(json_object_get(none, "time"));
    if (!(own.ratio > 0) || !(floor.ratio > 0))
        return unknown;
    struct aob_ratio quotient = aob_quotient(&own, &floor);
    return (struct aob_interval){quotient.ratio, quotient.low, quotient.high};
}

const json_t *aob_costs_model(const json_t *record, const char *profile)
{
    const json_t *modelled =
        json_object_get(json_object_get(json_object_get(record, "cache"), profile), "modelled");
    return json_is_object(modelled) ? modelled : NULL;
}

struct aob_interval aob_costs_modelled(const json_t *record, const char *profile)
{
    const json_t *frame = json_object_get(aob_costs_model(record, profile), "frame");
    struct aob_interval ms = {aob_member_number(frame, "ms"), aob_member_number(frame, "low_ms"),
                              aob_member_number(frame, "high_ms")};
    if (!(ms.at > 0) || !isfinite(ms.at))
        return unknown;
    return ms.low <= ms.at && ms.at <= ms.high ? ms : open_at(ms.at);
}

double aob_costs_error(const json_t *entry)
{
    double band = aob_member_number(entry, "band_rmse");
    return isfinite(band) ? band : aob_member_number(entry, "rmse");
}
