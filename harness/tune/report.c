#include "report.h"
#include <math.h>
#include <string.h>
#include "base/json.h"
#include "technique/param.h"

static const char *const sides[AOB_TUNE_SIDES] = {"default", "fitted"};

static double mean(const struct aob_tune *tune, const struct aob_tune_setting *setting, bool held_out,
                   enum aob_tune_side side)
{
    return aob_tune_setting_mean(setting, tune->views, tune->view_count, held_out, side);
}

static double share(const struct aob_tune *tune, const struct aob_tune_setting *setting, bool held_out)
{
    return mean(tune, setting, held_out, AOB_TUNE_FITTED) / mean(tune, setting, held_out, AOB_TUNE_DEFAULT);
}

static json_t *figures_to_json(const struct aob_tune_figures *f)
{
    return json_pack("{s:o, s:o, s:o, s:o, s:o, s:o}", "band_rmse", aob_json_number(f->error), "ratio_to_ref",
                     aob_json_number(f->ratio), "ms", aob_json_number(f->ms), "low", aob_json_number(f->low),
                     "high", aob_json_number(f->high), "reason",
                     *f->reason ? aob_json_text(f->reason) : json_null());
}

static json_t *views_to_json(const struct aob_tune *tune, const struct aob_tune_setting *setting)
{
    json_t *views = json_array();
    for (size_t v = 0; v < tune->view_count; v++) {
        json_t *view = json_pack("{s:o, s:b}", "name", aob_json_text(tune->views[v].name), "held_out",
                                 tune->views[v].held_out);
        for (int side = 0; side < AOB_TUNE_SIDES; side++)
            json_object_set_new(view, sides[side], figures_to_json(&setting->figures[v][side]));
        json_array_append_new(views, view);
    }
    return views;
}

static json_t *axes_to_json(const struct aob_tune *tune, const struct aob_tune_setting *setting)
{
    json_t *axes = json_array();
    for (size_t i = 0; i < setting->axes.count; i++) {
        const struct aob_tune_axis *axis = &setting->axes.items[i];
        json_array_append_new(axes,
                              json_pack("{s:s, s:o, s:o, s:o, s:o, s:b}", "name",
                                        tune->technique->params[axis->index].name, "default",
                                        aob_json_number(axis->start), "fitted",
                                        aob_json_number(setting->idle[i] ? axis->start : setting->fitted[i]),
                                        "low", aob_json_number(axis->low), "high",
                                        aob_json_number(axis->high), "idle", setting->idle[i]));
    }
    return axes;
}

static json_t *means_to_json(const struct aob_tune *tune, const struct aob_tune_setting *setting,
                             bool held_out)
{
    return json_pack("{s:o, s:o, s:o}", "default",
                     aob_json_number(mean(tune, setting, held_out, AOB_TUNE_DEFAULT)), "fitted",
                     aob_json_number(mean(tune, setting, held_out, AOB_TUNE_FITTED)), "share",
                     aob_json_number(share(tune, setting, held_out)));
}

static json_t *setting_to_json(const struct aob_tune *tune, const struct aob_tune_setting *setting)
{
    json_t *values = json_object();
    for (size_t i = 0; i < setting->value_count; i++)
        json_object_set_new(values, setting->values[i].name, aob_json_text(setting->values[i].text));
    return json_pack("{s:o, s:b, s:o, s:o, s:o, s:o, s:i}", "values", values, "too_dear", setting->dear,
                     "parameters", axes_to_json(tune, setting), "views", views_to_json(tune, setting),
                     "training", means_to_json(tune, setting, false), "held_out",
                     means_to_json(tune, setting, true), "evaluations", setting->evaluations);
}

json_t *aob_tune_to_json(const struct aob_tune_desc *desc, const struct aob_tune *tune, const char *out)
{
    json_t *settings = json_array();
    for (size_t s = 0; s < tune->setting_count; s++)
        json_array_append_new(settings, setting_to_json(tune, &tune->settings[s]));
    return json_pack("{s:s, s:o, s:s, s:i, s:i, s:i, s:{s:o, s:s}, s:o, s:o, s:o, s:o}", "technique",
                     tune->technique->name, "config", aob_json_text(desc->config), "backend", tune->backend,
                     "width", tune->width, "height", tune->height, "spp", tune->spp, "target", "radius",
                     aob_json_number(tune->target.radius), "weighting",
                     tune->target.uniform ? "uniform" : "cosine", "budget_ms",
                     isfinite(desc->budget_ms) ? json_real(desc->budget_ms) : json_null(), "settings",
                     settings, "chosen",
                     tune->chosen == AOB_NO_CANDIDATE ? json_null() : json_integer((json_int_t)tune->chosen),
                     "out", out ? aob_json_path(out) : json_null());
}

/* "samples=16 blur=0" */
static void print_values(const struct aob_tune_setting *setting, struct aob_text *text)
{
    for (size_t i = 0; i < setting->value_count; i++)
        aob_text_add(text, "%s%s=%s", i ? " " : "", setting->values[i].name, setting->values[i].text);
    if (!setting->value_count)
        aob_text_add(text, "its defaults");
}

static bool is_near(double value, double end)
{
    return fabs(value - end) <= 0.01 * fabs(end);
}

static void print_axis(const struct aob_tune *tune, const struct aob_tune_setting *setting, size_t i,
                       struct aob_text *out)
{
    const struct aob_tune_axis *axis = &setting->axes.items[i];
    const struct aob_param *param = &tune->technique->params[axis->index];
    const double fitted = setting->fitted[i];
    const char *note = "";
    if (setting->idle[i]) {
        aob_text_add_line(out, "  %-22s %10.4g          -  it changes no image here", param->name,
                          axis->start);
        return;
    }
    if (is_near(fitted, param->min) || is_near(fitted, param->max))
        note = "  at the end of what it may be";
    if (strcmp(param->name, "radius") == 0 && isfinite(tune->target.radius))
        aob_text_add_line(out, "  %-22s %10.4g %10.4g  %.3g of the target's%s", param->name, axis->start,
                          fitted, fitted / tune->target.radius, note);
    else
        aob_text_add_line(out, "  %-22s %10.4g %10.4g%s", param->name, axis->start, fitted, note);
}

static void add_ratio(double ratio, struct aob_text *text)
{
    if (isnan(ratio))
        aob_text_add(text, " %9s", "-");
    else
        aob_text_add(text, " %9.3g", ratio);
}

static void print_view(const struct aob_tune *tune, const struct aob_tune_setting *setting, size_t v,
                       struct aob_text *out)
{
    const struct aob_tune_figures *f = setting->figures[v];
    struct aob_text line = {0};
    aob_text_add(&line, "  %-33s", tune->views[v].name);
    for (int side = 0; side < AOB_TUNE_SIDES; side++)
        if (isnan(f[side].error))
            aob_text_add(&line, " %9s", "-");
        else
            aob_text_add(&line, " %9.4f", f[side].error);
    add_ratio(f[AOB_TUNE_DEFAULT].ratio, &line);
    add_ratio(f[AOB_TUNE_FITTED].ratio, &line);
    const char *reason = *f[0].reason ? f[0].reason : f[1].reason;
    aob_text_add_line(out, "%s%s%s%s", line.data, tune->views[v].held_out ? "  held out" : "",
                      *reason ? "  " : "", reason);
    aob_text_finish(&line);
}

static void print_mean(const struct aob_tune *tune, const struct aob_tune_setting *setting, bool held_out,
                       struct aob_text *out)
{
    const double before = mean(tune, setting, held_out, AOB_TUNE_DEFAULT);
    if (!isnan(before))
        aob_text_add_line(out, "  mean of %-25s %9.4f %9.4f  %.3g of it is left",
                          held_out ? "what is held out" : "what is fitted", before,
                          mean(tune, setting, held_out, AOB_TUNE_FITTED), share(tune, setting, held_out));
}

/* Of the settings beside the chosen one. */
static void print_other(const struct aob_tune *tune, size_t s, struct aob_text *out)
{
    const struct aob_tune_setting *setting = &tune->settings[s];
    struct aob_text name = {0};
    print_values(setting, &name);
    if (setting->dear)
        aob_text_add_line(out, "not taken: %s: too dear without a fit", name.data);
    else
        aob_text_add_line(out, "not taken: %s: error %.4f without a fit, %.4f with it", name.data,
                          mean(tune, setting, false, AOB_TUNE_DEFAULT),
                          mean(tune, setting, false, AOB_TUNE_FITTED));
    aob_text_finish(&name);
}

static void print_setting(const struct aob_tune *tune, const struct aob_tune_setting *setting,
                          struct aob_text *out)
{
    struct aob_text name = {0};
    print_values(setting, &name);
    aob_text_add_line(out, "%s with %s, %dx%d, %s, target %.4g %s: %d images of each view were drawn",
                      tune->technique->name, name.data, tune->width, tune->height, tune->backend,
                      tune->target.radius, tune->target.uniform ? "uniform" : "cosine", setting->evaluations);
    aob_text_finish(&name);
    aob_text_add_line(out, "  %-22s %10s %10s", "parameter", "default", "fitted");
    for (size_t i = 0; i < setting->axes.count; i++)
        print_axis(tune, setting, i, out);
    aob_text_add_line(out, "  %-33s %9s %9s %9s %9s", "error in band, then cost", "default", "fitted",
                      "default", "fitted");
    for (size_t v = 0; v < tune->view_count; v++)
        print_view(tune, setting, v, out);
    print_mean(tune, setting, false, out);
    print_mean(tune, setting, true, out);
}

void aob_tune_print(const struct aob_tune *tune, struct aob_text *out)
{
    print_setting(tune, &tune->settings[tune->chosen], out);
    for (size_t s = 0; s < tune->setting_count; s++)
        if (s != tune->chosen)
            print_other(tune, s, out);
}
