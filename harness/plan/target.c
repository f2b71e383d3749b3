#include "target.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "base/table.h"
#include "technique/param.h"

static void add_target(struct aob_plan_scene *scene, struct aob_target target)
{
    *AOB_PUSH(scene->targets, scene->target_count, scene->target_capacity) = target;
}

/* Nine digits tell any two floats apart. */
static void add_radius(struct aob_plan *plan, struct aob_table *seen, const struct aob_case *c)
{
    struct aob_plan_scene *scene = &plan->scenes[c->scene - plan->scenes];
    double radius = aob_case_radius(c);
    struct aob_text text = {0};
    aob_text_add(&text, "%zu %.9g", (size_t)(c->scene - plan->scenes), radius);
    size_t number = seen->count;
    if (!isnan(radius) && aob_table_put(seen, text.data, number) == number)
        add_target(scene, (struct aob_target){.radius = radius});
    aob_text_finish(&text);
}

static bool judge_targets(const struct aob_plan *plan, struct aob_error *error)
{
    for (size_t i = 0; plan->config->measure_error && i < plan->scene_count; i++)
        if (plan->scenes[i].target_count > AOB_CONFIG_MAX_TARGETS) {
            aob_fail(
                error,
                "%zu radii would each be a target, %d at most: name the question with target: {radius: R}",
                plan->scenes[i].target_count, AOB_CONFIG_MAX_TARGETS);
            return aob_config_fail_at(plan->config, 0, 0, error);
        }
    return true;
}

bool aob_plan_add_targets(struct aob_plan *plan, struct aob_error *error)
{
    const struct aob_config *config = plan->config;
    struct aob_table seen = {0};
    for (size_t i = 0; !config->target_count && i < plan->case_count; i++)
        add_radius(plan, &seen, &plan->cases[i]);
    for (size_t i = 0; i < plan->scene_count; i++) {
        struct aob_plan_scene *scene = &plan->scenes[i];
        for (size_t t = 0; t < config->target_count; t++)
            add_target(scene, config->targets[t]);
        if (!scene->target_count)
            add_target(scene, (struct aob_target){.radius = (double)(float)scene->metre});
    }
    aob_table_finish(&seen);
    return judge_targets(plan, error);
}

void aob_plan_settle_targets(struct aob_plan *plan)
{
    for (size_t i = 0; i < plan->scene_count; i++) {
        struct aob_plan_scene *scene = &plan->scenes[i];
        if (!plan->config->measure_error)
            scene->target_count = 0;
    }
    for (size_t i = 0; i < plan->case_count; i++) {
        struct aob_case *c = &plan->cases[i];
        c->reference_radius = c->scene->target_count ? c->scene->targets[aob_case_own_target(c)].radius : 0;
    }
}

double aob_case_radius(const struct aob_case *c)
{
    const struct aob_param *radius =
        aob_param_find(c->technique->params, c->technique->param_count, "radius");
    return radius ? c->params[radius - c->technique->params] : NAN;
}

size_t aob_case_own_target(const struct aob_case *c)
{
    double radius = aob_case_radius(c);
    for (size_t i = 0; i < c->scene->target_count; i++)
        if (c->scene->targets[i].radius == radius)
            return i;
    return 0;
}

/* Whether its radius is what the table says, which is a length in metres. */
static bool has_default_radius(const struct aob_case *c)
{
    double values[AOB_MAX_PARAM];
    const struct aob_param *radius =
        aob_param_find(c->technique->params, c->technique->param_count, "radius");
    if (!radius || radius->unit != AOB_UNIT_LENGTH)
        return false;
    aob_param_defaults(c->technique->params, c->technique->param_count, c->scene->metre, values);
    return c->params[radius - c->technique->params] == values[radius - c->technique->params];
}

/* Within a twentieth the two units are one to whoever looks at a picture. */
static bool is_metric(const struct aob_plan_scene *scene)
{
    return fabs(scene->metre - 1) <= 0.05;
}

bool aob_case_mixes_units(const struct aob_case *c, const struct aob_config *config, struct aob_error *line)
{
    /* Infinity is as far in every unit. */
    if (!config->target_count || !config->measure_error || is_metric(c->scene) || !has_default_radius(c))
        return false;
    for (size_t i = 0; i < config->target_count; i++)
        if (config->targets[i].radius == aob_case_radius(c) || isinf(config->targets[i].radius))
            return false;
    double radius = aob_case_radius(c), target = config->targets[0].radius;
    aob_fail(
        line,
        "%s: %s looks %.3g scene units far, since its default radius is %.3g m, and is compared with the "
        "target of %.3g scene units, which is %.3g m: state both in scene units (a metre is %.3g)",
        c->scene->name, c->technique->name, radius, radius / c->scene->metre, target,
        target / c->scene->metre, c->scene->metre);
    return true;
}
