#include "axes.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "technique/param.h"

void aob_plan_axes_finish(struct aob_plan_axes *axes)
{
    for (size_t i = 0; i < axes->count; i++)
        free(axes->items[i].values);
    free(axes->items);
    *axes = (struct aob_plan_axes){0};
}

static bool unknown_axis(const struct aob_axis *axis, const char *owner, const struct aob_param *params,
                         size_t count, struct aob_error *error)
{
    struct aob_text all = {0};
    for (size_t i = 0; i < count; i++)
        aob_text_add(&all, "%s%s", i ? ", " : "", params[i].name);
    aob_fail(error, "%s has no '%s'; known: %s", owner, axis->name, all.data ? all.data : "none");
    aob_text_finish(&all);
    return false;
}

static bool parse_axis(const struct aob_plan_axes_desc *desc, const struct aob_axis *from,
                       struct aob_plan_axes *axes, struct aob_error *error)
{
    const struct aob_param *param = aob_param_find(desc->params, desc->param_count, from->name);
    if (!param) {
        unknown_axis(from, desc->owner, desc->params, desc->param_count, error);
        return aob_config_fail_at(desc->config, from->line, from->column, error);
    }
    struct aob_plan_axis *axis = &axes->items[axes->count++];
    axis->row = (size_t)(param - desc->params);
    axis->count = from->count;
    axis->values = AOB_NEW_ARRAY(double, axis->count);
    for (size_t other = 0; other + 1 < axes->count; other++)
        if (axes->items[other].row == axis->row) {
            aob_fail(error, "'%s' is given twice for %s", from->name, desc->owner);
            return aob_config_fail_at(desc->config, from->line, from->column, error);
        }
    for (size_t v = 0; v < axis->count; v++)
        if (!aob_param_parse(param, from->values[v].text, &axis->values[v], error)) {
            aob_fail_in(error, "%s", desc->owner);
            return aob_config_fail_at(desc->config, from->values[v].line, from->values[v].column, error);
        }
    return true;
}

bool aob_plan_axes_init(struct aob_plan_axes *axes, const struct aob_plan_axes_desc *desc,
                        struct aob_error *error)
{
    *axes = (struct aob_plan_axes){.items = AOB_NEW_ARRAY(struct aob_plan_axis, desc->count)};
    for (size_t i = 0; i < desc->count; i++)
        if (!parse_axis(desc, &desc->from[i], axes, error)) {
            aob_plan_axes_finish(axes);
            return false;
        }
    return true;
}

bool aob_plan_axes_next(struct aob_plan_axes *axes)
{
    for (size_t i = axes->count; i-- > 0;) {
        if (++axes->items[i].at < axes->items[i].count)
            return true;
        axes->items[i].at = 0;
    }
    return false;
}

void aob_plan_axes_apply(const struct aob_plan_axes *axes, double *values)
{
    for (size_t i = 0; i < axes->count; i++)
        values[axes->items[i].row] = axes->items[i].values[axes->items[i].at];
}
