#include "describe.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "technique/param.h"

static void find_defaults(const struct aob_case *c, double *defaults)
{
    aob_param_defaults(c->technique->params, c->technique->param_count, c->scene->metre, defaults);
}

/* A default length is another number in a scene of another unit, and yet the same default. */
static void vary_params(const struct aob_case *c, const struct aob_case *first, bool *varied)
{
    double own[AOB_MAX_PARAM], other[AOB_MAX_PARAM];
    find_defaults(c, own);
    find_defaults(first, other);
    for (size_t p = 0; p < c->technique->param_count; p++) {
        bool defaults = c->params[p] == own[p] && first->params[p] == other[p];
        varied[p] = varied[p] || (c->params[p] != first->params[p] && !defaults);
    }
}

/* `used`: those of the list that have a case. */
static void find_builds(struct aob_plan *plan, const bool *used)
{
    const struct aob_technique_list *list = plan->techniques;
    plan->variation.builds = AOB_NEW_ARRAY(bool, list->count);
    for (size_t i = 0; i < list->count; i++)
        for (size_t k = 0; used[i] && k < list->count; k++)
            if (k != i && used[k] && strcmp(list->items[i].name, list->items[k].name) == 0)
                plan->variation.builds[i] = true;
}

/* Each case is compared with the first one, and in its parameters with the first one of its technique. */
void aob_plan_vary(struct aob_plan *plan)
{
    size_t techniques = plan->techniques->count;
    struct aob_variation *v = &plan->variation;
    const struct aob_case **firsts = AOB_NEW_ARRAY(const struct aob_case *, techniques);
    bool *used = AOB_NEW_ARRAY(bool, techniques);
    v->params = aob_alloc(techniques, sizeof *v->params);
    for (size_t i = 0; i < plan->case_count; i++) {
        const struct aob_case *c = &plan->cases[i], *first = &plan->cases[0];
        size_t t = (size_t)(c->technique - plan->techniques->items);
        v->scene = v->scene || c->scene != first->scene;
        v->backend = v->backend || c->backend != first->backend;
        v->size = v->size || c->width != first->width || c->height != first->height;
        for (size_t o = 0; o < AOB_OPTION_COUNT; o++)
            v->options[o] = v->options[o] || c->options[o] != first->options[o];
        first = firsts[t] = firsts[t] ? firsts[t] : c;
        used[t] = true;
        vary_params(c, first, v->params[t]);
    }
    find_builds(plan, used);
    free(firsts);
    free(used);
}

struct values {
    const struct aob_param *params;
    size_t count;
    const double *values;
    const bool *varied;
    double metre;
};

/* Those that vary, or those that do not and are not at their defaults either. */
static void add_values(const struct values *v, bool varied, struct aob_text *text)
{
    double defaults[AOB_MAX_PARAM];
    aob_param_defaults(v->params, v->count, v->metre, defaults);
    for (size_t i = 0; i < v->count; i++) {
        if (v->varied[i] != varied || (!varied && v->values[i] == defaults[i]))
            continue;
        aob_text_add(text, " %s=", v->params[i].name);
        aob_param_print(&v->params[i], v->values[i], text);
    }
}

void aob_case_describe(const struct aob_plan *plan, const struct aob_case *c, struct aob_text *text)
{
    const struct aob_variation *v = &plan->variation;
    size_t t = (size_t)(c->technique - plan->techniques->items);
    const struct values all[] = {
        {c->technique->params, c->technique->param_count, c->params, v->params[t], c->scene->metre},
        {aob_option_params, AOB_OPTION_COUNT, c->options, v->options, c->scene->metre}};
    if (v->scene)
        aob_text_add(text, "%s/%s ", c->scene->name, c->scene->view);
    aob_text_add(text, "%s", c->technique->name);
    if (v->builds[t] && c->technique->module)
        aob_text_add(text, " (%s)", c->technique->module);
    for (size_t i = 0; i < 2 * AOB_COUNT(all); i++)
        add_values(&all[i % AOB_COUNT(all)], i < AOB_COUNT(all), text);
    if (c->scene->light_stated && aob_case_is_lit(c))
        aob_text_add(text, " light=%s", c->scene->light_name);
    if (v->backend)
        aob_text_add(text, " %s", c->backend);
    if (v->size)
        aob_text_add(text, " %dx%d", c->width, c->height);
}
