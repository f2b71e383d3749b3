#include "blank.h"
#include <stdlib.h>
#include "base/memory.h"
#include "base/statistics.h"
#include "technique/param.h"

static double median_depth(const struct aob_score_desc *desc)
{
    double *depths = AOB_NEW_ARRAY(double, (size_t)desc->width *(size_t)desc->height);
    size_t count = 0;
    for (size_t i = 0; i < (size_t)desc->width * (size_t)desc->height; i++)
        if (!aob_score_is_sky(desc, i))
            depths[count++] = (double)desc->depth[i];
    double median = aob_quantile(depths, count, 0.5);
    free(depths);
    return median;
}

static void add_radius(const struct aob_technique *technique, const struct aob_block_case *c,
                       const struct aob_score_desc *desc, struct aob_text *text)
{
    const struct aob_param *radius = aob_param_find(technique->params, technique->param_count, "radius");
    double unit = desc->pixel_scale * (desc->perspective ? median_depth(desc) : 1);
    if (radius)
        aob_text_add(text, "; radius %g covers %.2g pixels at the median depth",
                     c->frame.params[radius - technique->params],
                     c->frame.params[radius - technique->params] / unit);
}

/* A default length depends on the scene, and the radius tells enough of it. */
static void add_settings(const struct aob_technique *technique, const struct aob_block_case *c,
                         struct aob_text *text)
{
    const char *before = "; not at its default: ";
    for (size_t i = 0; i < technique->param_count; i++) {
        const struct aob_param *param = &technique->params[i];
        if (param->unit == AOB_UNIT_LENGTH || (float)c->frame.params[i] == (float)param->initial)
            continue;
        aob_text_add(text, "%s%s=", before, param->name);
        aob_param_print(param, c->frame.params[i], text);
        before = ", ";
    }
}

bool aob_blank_explain(const struct aob_technique *technique, const struct aob_block_case *c,
                       const struct aob_score_desc *desc, struct aob_error *error)
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s", error->text);
    add_radius(technique, c, desc, &text);
    add_settings(technique, c, &text);
    aob_fail(error, "%s", text.data);
    aob_text_finish(&text);
    return false;
}
