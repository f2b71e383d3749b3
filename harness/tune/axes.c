#include "axes.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "technique/param.h"

/* How far a search by the logarithm looks to either side. */
static const double reach = 16;

/* The words of what only turns a noise (docs/design.md, Parameter words). */
static bool is_seed(const char *name)
{
    static const char *const words[] = {"seed", "noise_index"};
    for (size_t i = 0; i < AOB_COUNT(words); i++)
        if (strcmp(name, words[i]) == 0)
            return true;
    return false;
}

static bool is_continuous(const struct aob_param *param)
{
    return param->type == AOB_FLOAT && !param->choices;
}

bool aob_tune_axes_wants(const struct aob_param *param)
{
    return is_continuous(param) && param->stage == AOB_UNIFORM && param->output == AOB_OUT_VISIBILITY &&
           param->unit != AOB_UNIT_PIXEL && !is_seed(param->name);
}

static bool spans_orders(const struct aob_param *param, double start)
{
    return start > 0 &&
           (param->scale == AOB_LOG2 || param->unit == AOB_UNIT_LENGTH || param->max > 8 * start);
}

static void add_axis(struct aob_tune_axes *axes, const struct aob_tune_axes_desc *desc, size_t index)
{
    const struct aob_param *param = &desc->technique->params[index];
    const double start = desc->start[index];
    struct aob_tune_axis axis = {
        .index = index, .log = spans_orders(param, start), .low = param->min, .high = param->max, .scale = 1};
    aob_tune_axis_centre(&axis, param, start);
    axes->items[axes->count++] = axis;
}

static bool fail_unknown(const struct aob_technique_info *technique, const char *name,
                         struct aob_error *error)
{
    struct aob_text all = {0};
    for (size_t i = 0; i < technique->param_count; i++)
        if (is_continuous(&technique->params[i]))
            aob_text_add(&all, "%s%s", all.size ? ", " : "", technique->params[i].name);
    aob_fail(error, "--params: %s has no parameter '%s'; what can be fitted of it: %s", technique->name, name,
             all.size ? all.data : "nothing");
    aob_text_finish(&all);
    return false;
}

static bool add_named(struct aob_tune_axes *axes, const struct aob_tune_axes_desc *desc, const char *name,
                      struct aob_error *error)
{
    const struct aob_technique_info *technique = desc->technique;
    const struct aob_param *param = aob_param_find(technique->params, technique->param_count, name);
    if (!param)
        return fail_unknown(technique, name, error);
    if (!is_continuous(param))
        return aob_fail(
            error,
            "--params: '%s' of %s is %s, and a fit moves floats: sweep it in the config, and each "
            "of its values gets a fit of its own",
            name, technique->name, param->choices ? "a choice" : "a whole number");
    size_t index = (size_t)(param - technique->params);
    for (size_t i = 0; i < axes->count; i++)
        if (axes->items[i].index == index)
            return aob_fail(error, "--params: '%s' stands there twice", name);
    add_axis(axes, desc, index);
    return true;
}

static bool add_names(struct aob_tune_axes *axes, const struct aob_tune_axes_desc *desc,
                      struct aob_error *error)
{
    char *copy = aob_strdup(desc->names), *rest = copy;
    bool ok = true;
    for (char *name; ok && (name = strsep(&rest, ","));)
        ok = add_named(axes, desc, name, error);
    free(copy);
    return ok;
}

bool aob_tune_axes_choose(struct aob_tune_axes *axes, const struct aob_tune_axes_desc *desc,
                          struct aob_error *error)
{
    const struct aob_technique_info *technique = desc->technique;
    *axes = (struct aob_tune_axes){.count = 0};
    if (desc->names)
        return add_names(axes, desc, error);
    for (size_t i = 0; i < technique->param_count; i++)
        if (aob_tune_axes_wants(&technique->params[i]) && !desc->stated[i])
            add_axis(axes, desc, i);
    return axes->count || aob_fail(error,
                                   "%s has no parameter that is fitted by itself, or the config states all "
                                   "of them: name some with --params",
                                   technique->name);
}

double aob_tune_axis_value(const struct aob_tune_axis *axis, double place)
{
    double value = axis->log ? axis->low * pow(axis->high / axis->low, place)
                             : axis->low + (axis->high - axis->low) * place;
    return (double)(float)value;
}

double aob_tune_axis_place(const struct aob_tune_axis *axis, double value)
{
    double whole = axis->log ? log(axis->high / axis->low) : axis->high - axis->low,
           part = axis->log ? log(value / axis->low) : value - axis->low;
    return whole > 0 ? fmin(fmax(part / whole, 0), 1) : 0;
}

void aob_tune_axis_centre(struct aob_tune_axis *axis, const struct aob_param *param, double value)
{
    axis->start = value;
    if (!axis->log)
        return;
    axis->low = fmin(fmax(param->min, value / reach), value);
    axis->high = fmax(fmin(param->max, value * reach), value);
}
