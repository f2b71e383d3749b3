#include <math.h>
#include <stdio.h>
#include "base/json.h"
#include "command.h"
#include "single.h"
#include "store/metric.h"

/* Texts as given on the command line; NULL: not given. */
struct options {
    struct aob_common common;
    struct aob_single_flags frame;
    const char *reference_spp, *target_radius, *target_weighting, *precision;
    const char *reference_radius; /* what the first of these was called */
    const char *out;
};

static const struct aob_flag flags[] = {
    AOB_SINGLE_FLAGS(struct options, frame),
    AOB_FLAG_OF(struct options, reference_spp, "reference-spp", "N", "rays a pixel (256); 0: none"),
    AOB_FLAG_OF(struct options, target_radius, "target-radius", "R[,R...]",
                "what it is compared with: visibility of this radius (the technique's); inf allowed"),
    AOB_FLAG_OF(struct options, target_weighting, "target-weighting", "W",
                "of that visibility: cosine or uniform (cosine)"),
    AOB_FLAG_OF(struct options, precision, "precision", "P%",
                "timing ends where the interval is so narrow (3%), or after half a second"),
    AOB_FLAG_OF(struct options, reference_radius, "reference-radius", "R", "is now --target-radius"),
    AOB_FLAG_OF(struct options, out, "out", "FILE.exr", "the images"),
    {0},
};

static bool choose_precision(const struct options *o, struct aob_config *config, struct aob_error *error)
{
    return !o->precision || aob_config_parse_precision(o->precision, &config->precision, error) ||
           aob_fail_in(error, "--precision");
}

static bool choose_reference(const struct options *o, struct aob_config *config, struct aob_error *error)
{
    double spp = config->spp;
    if (!aob_single_number("reference-spp", o->reference_spp, 0, 65536, &spp, error))
        return false;
    if (o->reference_radius)
        return aob_fail(error,
                        "--reference-radius is now --target-radius, with --target-weighting beside it");
    if (o->target_weighting && !o->target_radius)
        return aob_fail(error, "--target-weighting goes with --target-radius");
    const char *weighting = o->target_weighting ? o->target_weighting : "cosine";
    if (o->target_radius && !aob_config_add_targets(config, o->target_radius, weighting, error))
        return aob_fail_in(error, "--target-radius");
    if (spp != floor(spp) || fmod(spp, 2) != 0)
        return aob_fail(error, "--reference-spp: %s is not an even whole number (0: no reference)",
                        o->reference_spp);
    config->spp = (int)spp;
    config->measure_error = spp > 0;
    return true;
}

/* By its clock, with what its interval reaches to either side. */
static void print_time(const json_t *time, struct aob_text *text)
{
    const char *clock = json_string_value(json_object_get(time, "clock"));
    char member[16];
    snprintf(member, sizeof member, "%s_ms", clock);
    aob_text_add(text, ": %.3f ms %s, %.2f x fixed pass", json_number_value(json_object_get(time, member)),
                 clock, json_number_value(json_object_get(time, "ratio_to_ref")));
    const json_t *precision = json_object_get(time, "precision");
    if (json_is_number(precision))
        aob_text_add(text, " (+-%.2g %%)", 100 * json_number_value(precision));
}

static void print_record(const struct aob_sweep *sweep, const json_t *record, struct aob_text *out)
{
    const json_t *time = json_object_get(record, "time"), *error = json_object_get(record, "error");
    struct aob_text text = {0};
    aob_case_describe(&sweep->plan, &sweep->plan.cases[0], &text);
    if (time)
        print_time(time, &text);
    struct aob_metrics metrics;
    aob_metrics_from_json(&metrics, error);
    aob_metrics_print_brief(&metrics, ~0u, ", ", &text);
    if (isfinite(metrics.reference_se))
        aob_text_add(&text, " (reference SE %.4f)", metrics.reference_se);
    aob_text_add_line(out, "%s", text.data);
    aob_text_finish(&text);
}

static bool make_sweep(const struct options *o, struct aob_sweep *sweep, struct aob_error *error)
{
    if (!aob_single_config("shot", &o->frame, &sweep->config, error))
        return false;
    sweep->config.seconds = 0.5;
    return choose_reference(o, &sweep->config, error) && choose_precision(o, &sweep->config, error) &&
           aob_single_expand(sweep, &o->common.dispatch, error);
}

static enum aob_exit shot(void *from, struct aob_error *error)
{
    struct options *o = from;
    struct aob_sweep sweep = {0};
    json_t *record = NULL;
    const struct aob_single_desc desc = {.dispatch = &o->common.dispatch, .image = o->out};
    bool ok = make_sweep(o, &sweep, error) && aob_single_measure(&desc, &sweep, &record, error);
    if (record && o->common.json && !aob_json_write(record, o->common.json, ok ? error : NULL))
        ok = false;
    if (ok && aob_common_speaks(&o->common))
        print_record(&sweep, record, &o->common.out);
    json_decref(record);
    aob_sweep_finish(&sweep);
    aob_words_finish(&o->frame.params);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

const struct aob_command aob_command_shot = {
    .name = "shot",
    .help = "one frame, timed and scored",
    .usage = "--technique T --scene S [flags]",
    .summary = "One frame, timed and scored.",
    .flags = flags,
    .modules = true,
    .devices = true,
    .size = sizeof(struct options),
    .run = shot,
};
