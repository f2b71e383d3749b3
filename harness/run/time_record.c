#include "time_record.h"
#include <math.h>
#include "base/json.h"
#include "timing/estimate.h"
#include "timing/forecast.h"
#include "timing/summary.h"

/* The interval is null where there are too few rounds for one. */
static json_t *bound_to_json(const struct aob_ratio *ratio, double bound)
{
    return ratio->bounded ? json_real(bound) : json_null();
}

static void add_ratio(json_t *object, const struct aob_ratio *ratio)
{
    json_object_set_new(object, "ratio_to_ref", aob_json_number(ratio->ratio));
    json_object_set_new(object, "ci_low", bound_to_json(ratio, ratio->low));
    json_object_set_new(object, "ci_high", bound_to_json(ratio, ratio->high));
}

static void add_times(json_t *object, const struct aob_times *times)
{
    json_object_set_new(object, "cpu_ms", aob_json_number(times->ms[AOB_CLOCK_CPU]));
    json_object_set_new(object, "wall_ms", aob_json_number(times->ms[AOB_CLOCK_WALL]));
    json_object_set_new(object, "device_ms", aob_json_number(times->ms[AOB_CLOCK_DEVICE]));
}

static json_t *passes_to_json(const struct aob_block_timed_case *c, const struct aob_summary *summary)
{
    json_t *passes = json_array();
    for (size_t p = 0; p < summary->pass_count; p++) {
        json_t *pass = json_object(), *name = json_array_get(c->passes, p);
        json_object_set(pass, "name", name ? name : json_null());
        add_times(pass, &summary->passes[p]);
        add_ratio(pass, &summary->pass_to_fixed[p]);
        json_array_append_new(passes, pass);
    }
    return passes;
}

/* What was reached, what was wanted, and what it would take. */
static void add_precision(json_t *time, const struct aob_time_record_desc *desc,
                          const struct aob_ratio *ratio)
{
    const struct aob_round_list *rounds = &desc->measured->rounds;
    double seconds = desc->measured->measured_s / (double)desc->asked->case_count;
    double width = aob_estimate_half_width(ratio);
    json_object_set_new(time, "precision", aob_json_number(isinf(width) ? NAN : width));
    json_object_set_new(time, "precision_wanted", json_real(desc->asked->precision));
    json_object_set_new(time, "seconds", json_real(seconds));
    json_object_set_new(time, "seconds_needed",
                        aob_json_number(aob_seconds_needed(rounds, AOB_SLOT_CASES + desc->at, desc->asked)));
}

static void add_block(json_t *time, const struct aob_time_record_desc *desc)
{
    struct aob_summary fixed;
    aob_summarise(&desc->measured->rounds, AOB_SLOT_FIXED, &fixed);
    const struct aob_ratio control = aob_rounds_ratio(&desc->measured->rounds, AOB_SLOT_CONTROL);
    json_object_set_new(time, "ref_ms", aob_json_number(fixed.whole.ms[desc->timed->clock]));
    json_object_set_new(time, "control_low", bound_to_json(&control, control.low));
    json_object_set_new(time, "control_high", bound_to_json(&control, control.high));
    json_t *slots = json_pack("[s, s]", "fixed", "control");
    json_array_extend(slots, (json_t *)(uintptr_t)desc->slots);
    json_object_set_new(time, "slots", slots);
    if (desc->rounds_file)
        json_object_set_new(time, "rounds_file", json_string(desc->rounds_file));
}

json_t *aob_time_record_create(const struct aob_time_record_desc *desc)
{
    const struct aob_block_timed_case *c = &desc->timed->cases[desc->at];
    struct aob_summary summary;
    aob_summarise(&desc->measured->rounds, AOB_SLOT_CASES + desc->at, &summary);
    json_t *time = json_pack("{s:s, s:o}", "clock", aob_clock_name(desc->timed->clock), "clock_reason",
                             aob_json_text(desc->timed->clock_reason));
    add_times(time, &summary.whole);
    add_ratio(time, &summary.to_fixed);
    add_precision(time, desc, &summary.to_fixed);
    json_object_set_new(time, "processes", json_integer(summary.processes));
    json_object_set_new(time, "rounds", json_integer((json_int_t)summary.rounds));
    json_object_set_new(time, "clean_rounds", json_integer((json_int_t)summary.clean_rounds));
    json_object_set_new(time, "frames", json_integer(summary.frames));
    json_object_set_new(time, "seed", json_integer((json_int_t)desc->asked->seed));
    json_object_set_new(time, "threads", json_integer(desc->timed->threads));
    json_object_set_new(time, "setup_ms", json_real(c->setup_ms));
    add_block(time, desc);
    json_object_set_new(time, "passes", passes_to_json(c, &summary));
    return time;
}
