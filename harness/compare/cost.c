#include "cost.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/member.h"
#include "base/memory.h"
#include "quotient.h"
#include "timing/summary.h"
#include "verdict.h"

static const json_t *time_of(const struct aob_cost_side *side)
{
    return json_object_get(side->record, "time");
}

/* A member that decides what a time means; the fixed pass' revision and the cores are numbers. */
static bool same_member(const json_t *a, const json_t *b, const char *name, struct aob_error *why)
{
    const json_t *x = json_object_get(a, name), *y = json_object_get(b, name);
    if (json_equal(x, y))
        return true;
    char *p = x ? json_dumps(x, JSON_ENCODE_ANY) : NULL, *q = y ? json_dumps(y, JSON_ENCODE_ANY) : NULL;
    aob_fail(why, "their times are of different circumstances: %s is %s in A and %s in B", name,
             p ? p : "not known", q ? q : "not known");
    free(p);
    free(q);
    return false;
}

static bool same_circumstances(const struct aob_cost_side *a, const struct aob_cost_side *b,
                               struct aob_error *why)
{
    static const char *const names[] = {"cpu", "cores", "device", "driver", "class", "fixed_pass", "threads"};
    const json_t *p = json_object_get(a->record, "fingerprint"),
                 *q = json_object_get(b->record, "fingerprint");
    for (size_t i = 0; i < AOB_COUNT(names); i++)
        if (!same_member(p, q, names[i], why))
            return false;
    return same_member(time_of(a), time_of(b), "clock", why) &&
           same_member(time_of(a), time_of(b), "threads", why);
}

/* Wall time of a GPU has the way there and back in it, and what its driver does meanwhile. */
static bool has_clock(const struct aob_cost_side *side, const char *name, struct aob_error *why)
{
    const char *reason = aob_member_text(time_of(side), "clock_reason");
    return !*reason || aob_fail(why, "the clock of %s's device cannot be trusted: %s", name, reason);
}

static bool has_time(const struct aob_cost_side *side, const char *name, struct aob_error *why)
{
    const char *status = aob_member_text(side->record, "status");
    if (strcmp(status, "ok") != 0)
        return aob_fail(why, "the case of %s is %s: %s", name, status,
                        aob_member_text(side->record, "reason"));
    return json_is_object(time_of(side)) || aob_fail(why, "the case of %s was not timed", name);
}

static struct aob_ratio read_interval(const json_t *time, const char *low, const char *high)
{
    double l = aob_json_to_number(json_object_get(time, low)),
           h = aob_json_to_number(json_object_get(time, high));
    bool bounded = l > 0 && h >= l && isfinite(h);
    return (struct aob_ratio){sqrt(l * h), bounded ? l : 0, bounded ? h : INFINITY, bounded};
}

/* What a side's record, or its raw rounds, say by themselves. */
struct own {
    struct aob_ratio to_fixed, control;
    size_t rounds, processes;
};

static struct own from_record(const struct aob_cost_side *side)
{
    const json_t *time = time_of(side);
    struct own own = {.to_fixed = read_interval(time, "ci_low", "ci_high"),
                      .control = read_interval(time, "control_low", "control_high"),
                      .rounds = (size_t)json_integer_value(json_object_get(time, "rounds")),
                      .processes = (size_t)json_integer_value(json_object_get(time, "processes"))};
    own.to_fixed.ratio = aob_json_to_number(json_object_get(time, "ratio_to_ref"));
    return own;
}

static struct own from_rounds(const struct aob_round_list *rounds, size_t slot)
{
    struct aob_summary summary;
    aob_summarise(rounds, slot, &summary);
    return (struct own){summary.to_fixed, aob_rounds_ratio(rounds, AOB_SLOT_CONTROL), summary.rounds,
                        (size_t)summary.processes};
}

/* Of the case's rounds; false where none are kept. */
static bool find_slot(const struct aob_cost_side *side, size_t *slot)
{
    const char *key = aob_member_text(side->record, "key");
    const json_t *slots = json_object_get(time_of(side), "slots");
    for (*slot = AOB_SLOT_CASES; *slot < json_array_size(slots); (*slot)++) {
        const char *own = json_string_value(json_array_get(slots, *slot));
        if (own && strcmp(own, key) == 0)
            return true;
    }
    return false;
}

/* The file may be lost or damaged; the record stands for it then. */
static bool read_rounds(const struct aob_cost_side *side, struct aob_round_list *rounds, size_t *slot)
{
    const char *name = aob_member_text(time_of(side), "rounds_file");
    if (!*name || !find_slot(side, slot))
        return false;
    char *path = aob_path_join(side->folder, name);
    bool ok = aob_rounds_read(path, rounds, NULL) && *slot < rounds->items[0].slot_count;
    free(path);
    return ok;
}

static bool same_file(const struct aob_cost_side *a, const struct aob_cost_side *b)
{
    return strcmp(a->folder, b->folder) == 0 && strcmp(aob_member_text(time_of(a), "rounds_file"),
                                                       aob_member_text(time_of(b), "rounds_file")) == 0;
}

static void put_together(const struct own *a, const struct own *b, struct aob_cost *cost)
{
    cost->cost = aob_quotient(&b->to_fixed, &a->to_fixed);
    cost->control = *aob_wider_control(&a->control, &b->control);
    cost->rounds = a->rounds < b->rounds ? a->rounds : b->rounds;
    cost->processes = a->processes < b->processes ? a->processes : b->processes;
}

static double fixed_ms(const struct aob_cost_side *side)
{
    return aob_json_to_number(json_object_get(time_of(side), "ref_ms"));
}

bool aob_cost_compare(const struct aob_cost_side *a, const struct aob_cost_side *b, struct aob_cost *cost,
                      struct aob_error *why)
{
    struct aob_round_list of_a = {0}, of_b = {0};
    size_t slot_a, slot_b;
    *cost = (struct aob_cost){.fixed = NAN};
    if (!has_time(a, "A", why) || !has_time(b, "B", why) || !has_clock(a, "A", why) ||
        !has_clock(b, "B", why) || !same_circumstances(a, b, why))
        return false;
    bool raw = read_rounds(a, &of_a, &slot_a) && read_rounds(b, &of_b, &slot_b);
    struct own own_a = raw ? from_rounds(&of_a, slot_a) : from_record(a);
    struct own own_b = raw ? from_rounds(&of_b, slot_b) : from_record(b);
    put_together(&own_a, &own_b, cost);
    cost->fixed = fixed_ms(b) / fixed_ms(a);
    cost->paired = raw && same_file(a, b);
    if (cost->paired)
        cost->cost = aob_rounds_quotient(&of_a, slot_b, slot_a);
    aob_rounds_finish(&of_a);
    aob_rounds_finish(&of_b);
    return true;
}
