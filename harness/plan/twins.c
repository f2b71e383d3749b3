#include "twins.h"
#include <stdlib.h>
#include "base/memory.h"
#include "describe.h"
#include "gather.h"
#include "key.h"
#include "technique/param.h"

/* A value goes by its text, as choices and bounds may be others there. */
static bool take_values(const struct aob_case *from, struct aob_case *twin, struct aob_error *error)
{
    const struct aob_technique_info *own = from->technique, *other = twin->technique;
    bool ok = true;
    aob_param_defaults(other->params, other->param_count, from->scene->metre, twin->params);
    for (size_t i = 0; ok && i < other->param_count; i++) {
        const struct aob_param *param = aob_param_find(own->params, own->param_count, other->params[i].name);
        struct aob_text text = {0};
        if (!param)
            continue;
        aob_param_print(param, from->params[param - own->params], &text);
        ok = aob_param_parse(&other->params[i], text.data, &twin->params[i], error) ||
             aob_fail_in(error, "%s of %s", other->name, other->module);
        aob_text_finish(&text);
    }
    return ok;
}

static bool add_twin(struct aob_plan *plan, const struct aob_case *from, const char *module,
                     struct aob_error *error)
{
    struct aob_case twin = *from;
    twin.technique = aob_technique_list_find(plan->techniques, module, from->technique->name, error);
    if (!twin.technique)
        return false;
    twin.params = AOB_NEW_ARRAY(double, AOB_MAX_PARAM);
    bool ok = take_values(from, &twin, error);
    *AOB_PUSH(plan->cases, plan->case_count, plan->case_capacity) = twin;
    return ok;
}

static void keep(struct aob_plan *plan, const bool *kept)
{
    size_t count = 0;
    for (size_t i = 0; i < plan->case_count; i++) {
        if (kept[i])
            plan->cases[count++] = plan->cases[i];
        else
            free(plan->cases[i].params);
    }
    plan->case_count = count;
}

bool aob_plan_take_twins(struct aob_plan *plan, const bool *kept, const char *module, struct aob_error *error)
{
    keep(plan, kept);
    size_t count = plan->case_count;
    bool ok = true;
    for (size_t i = 0; ok && i < count; i++) {
        struct aob_case from = plan->cases[i]; /* the list may move */
        ok = add_twin(plan, &from, module, error);
    }
    free(plan->variation.params);
    free(plan->variation.builds);
    plan->variation = (struct aob_variation){0};
    aob_plan_make_keys(plan);
    aob_plan_gather(plan);
    aob_plan_vary(plan);
    return ok;
}
