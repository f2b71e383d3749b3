#include "plan.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "axes.h"
#include "base/memory.h"
#include "base/table.h"
#include "describe.h"
#include "gather.h"
#include "gpu/gpu.h"
#include "key.h"
#include "plan_profile.h"
#include "plan_scene.h"
#include "target.h"
#include "technique/param.h"

/* What cannot be is most often an option's value. */
static bool fail_at_options(const struct aob_config *config, struct aob_error *error)
{
    bool any = config->option_count > 0;
    return aob_config_fail_at(config, any ? config->options[0].line : 0, any ? config->options[0].column : 0,
                              error);
}

static bool add_cases(struct aob_plan *plan, struct aob_case *base, struct aob_plan_axes *params,
                      struct aob_plan_axes *options, struct aob_error *error)
{
    double values[AOB_MAX_PARAM];
    aob_param_defaults(base->technique->params, base->technique->param_count, base->scene->metre, values);
    base->params = values;
    do {
        aob_plan_axes_apply(params, values);
        do {
            aob_plan_axes_apply(options, base->options);
            if (!aob_case_judge(base, error))
                return fail_at_options(plan->config, error);
            struct aob_case *copy = AOB_PUSH(plan->cases, plan->case_count, plan->case_capacity);
            *copy = *base;
            copy->params = AOB_NEW_ARRAY(double, AOB_MAX_PARAM);
            memcpy(copy->params, values, base->technique->param_count * sizeof *values);
        } while (aob_plan_axes_next(options));
    } while (aob_plan_axes_next(params));
    return true;
}

/* The points of one entry on each of its backends; the rest of the case, scene and size, is chosen. */
static bool expand_technique(struct aob_plan *plan, struct aob_case base,
                             const struct aob_technique_choice *choice, struct aob_plan_axes *options,
                             struct aob_error *error)
{
    struct aob_plan_axes params = {0};
    base.technique = aob_technique_list_find(plan->techniques, choice->module.text, choice->name.text, error);
    if (!base.technique)
        return aob_config_fail_at(plan->config, choice->name.line, choice->name.column, error);
    const struct aob_plan_axes_desc desc = {.config = plan->config,
                                            .owner = choice->name.text,
                                            .params = base.technique->params,
                                            .param_count = base.technique->param_count,
                                            .from = choice->axes,
                                            .count = choice->axis_count};
    const struct aob_backend_choice *backends = aob_config_backends(plan->config, choice);
    aob_param_defaults(aob_option_params, AOB_OPTION_COUNT, base.scene->metre, base.options);
    bool ok = aob_plan_axes_init(&params, &desc, error);
    for (size_t b = 0; ok && b < backends->count; b++) {
        base.backend = aob_gpu_find(backends->names[b].text)->name;
        ok = add_cases(plan, &base, &params, options, error);
    }
    aob_plan_axes_finish(&params);
    return ok;
}

static bool expand_techniques(struct aob_plan *plan, struct aob_case base, struct aob_error *error)
{
    const struct aob_config *config = plan->config;
    struct aob_plan_axes options = {0};
    const struct aob_plan_axes_desc desc = {.config = config,
                                            .owner = "options",
                                            .params = aob_option_params,
                                            .param_count = AOB_OPTION_COUNT,
                                            .from = config->options,
                                            .count = config->option_count};
    bool ok = aob_plan_axes_init(&options, &desc, error);
    for (size_t t = 0; ok && t < config->technique_count; t++)
        ok = expand_technique(plan, base, &config->techniques[t], &options, error);
    aob_plan_axes_finish(&options);
    return ok;
}

static bool judge_backends(const struct aob_config *config, const struct aob_backend_choice *choice,
                           struct aob_error *error)
{
    for (size_t i = 0; i < choice->count; i++) {
        const struct aob_value *name = &choice->names[i];
        if (aob_gpu_find(name->text))
            continue;
        aob_fail(error, "unknown backend '%s'; see: aobudget list backends", name->text);
        return aob_config_fail_at(config, name->line, name->column, error);
    }
    return true;
}

/* Also those of the config that no entry uses: a wrong name is wrong wherever it stands. */
static bool judge_all_backends(const struct aob_config *config, struct aob_error *error)
{
    bool ok = judge_backends(config, &config->backends, error);
    for (size_t t = 0; ok && t < config->technique_count; t++)
        ok = judge_backends(config, &config->techniques[t].backends, error);
    return ok;
}

static bool expand(struct aob_plan *plan, struct aob_error *error)
{
    const struct aob_config *config = plan->config;
    for (size_t s = 0; s < plan->scene_count; s++) {
        const struct aob_size own = {.width = plan->scenes[s].width, .height = plan->scenes[s].height};
        const struct aob_size *sizes = plan->scenes[s].gbuffer ? &own : config->sizes;
        for (size_t r = 0; r < (sizes == &own ? 1 : config->size_count); r++) {
            struct aob_case base = {
                .scene = &plan->scenes[s], .width = sizes[r].width, .height = sizes[r].height};
            if (!expand_techniques(plan, base, error))
                return false;
        }
    }
    return true;
}

bool aob_plan_create(struct aob_plan *plan, const struct aob_config *config,
                     const struct aob_technique_list *techniques, struct aob_error *error)
{
    *plan = (struct aob_plan){.config = config, .techniques = techniques};
    if (!aob_plan_choose_profiles(plan, error) || !aob_plan_choose_scenes(plan, error) ||
        !judge_all_backends(config, error) || !expand(plan, error) || !aob_plan_add_targets(plan, error))
        goto error;
    aob_plan_make_keys(plan);
    aob_plan_settle_targets(plan);
    aob_plan_gather(plan);
    aob_plan_vary(plan);
    return true;
error:
    aob_plan_finish(plan);
    return false;
}

void aob_plan_finish(struct aob_plan *plan)
{
    for (size_t i = 0; i < plan->case_count; i++)
        free(plan->cases[i].params);
    for (size_t i = 0; i < plan->scene_count; i++)
        aob_plan_scene_finish(&plan->scenes[i]);
    free(plan->cases);
    free(plan->scenes);
    aob_plan_profiles_finish(plan);
    free(plan->variation.params);
    free(plan->variation.builds);
    *plan = (struct aob_plan){0};
}

bool aob_plan_matches(const struct aob_plan *plan, const struct aob_case *c, const char *filter)
{
    struct aob_text text = {0};
    aob_case_describe(plan, c, &text);
    aob_text_add(&text, " ");
    bool matches = strstr(text.data, filter);
    aob_text_finish(&text);
    return matches;
}

void aob_plan_filter(struct aob_plan *plan, const char *filter)
{
    size_t kept = 0;
    for (size_t i = 0; i < plan->case_count; i++)
        if (aob_plan_matches(plan, &plan->cases[i], filter))
            plan->cases[kept++] = plan->cases[i];
        else
            free(plan->cases[i].params);
    plan->case_count = kept;
}

/* Whether no case before had this view of the scene with this radius. */
static bool is_new(struct aob_table *seen, const struct aob_case *c, const struct aob_plan *plan,
                   double radius)
{
    struct aob_text text = {0};
    size_t number = seen->count;
    aob_text_add(&text, "%zu %dx%d %.9g", (size_t)(c->scene - plan->scenes), c->width, c->height, radius);
    bool new = aob_table_put(seen, text.data, number) == number;
    aob_text_finish(&text);
    return new;
}

/* The frames of a sequence before its last; none of one that shows the same all the time. */
static double poses_of(const struct aob_plan_scene *scene)
{
    bool changes = aob_motion_has_camera(&scene->motion) || aob_plan_scene_frame(scene, 1);
    return scene->motion.frames && changes ? scene->motion.frames - 1 : 0;
}

/* One set of rays serves all truths of a view, and each radius adds a screen-space bound. A capture has the bounds
 * only, and a frame before a sequence's last the truths only. */
static double estimate_reference(struct aob_table *seen, const struct aob_case *c,
                                 const struct aob_plan *plan)
{
    const double view_s = 0.5, rays_per_s = 60e6;
    bool first = is_new(seen, c, plan, -1);
    double rays = (double)c->width * c->height * plan->config->spp;
    double poses = first ? poses_of(c->scene) : 0, traces = first && !c->scene->gbuffer;
    if (!isnan(aob_case_radius(c)))
        traces += is_new(seen, c, plan, aob_case_radius(c));
    traces += poses;
    return (first ? view_s * (1 + poses) : 0) +
           (plan->config->measure_error ? traces * rays / rays_per_s : 0);
}

/* The constants are fitted to the demo and to variants of it (1024 rays, 1.5 s, one target), each with an empty cache on
 * two cores of an AMD EPYC: the shares of time in run.json. Timing ends early where its interval is narrow enough: of
 * 0.3 s a case 0.26 were used, of 1.5 s 0.75. What a case costs in each of two further processes that time it was
 * measured with neighbours on the machine. */
double aob_plan_estimate_s(const struct aob_plan *plan)
{
    const double case_s = 0.3, again_s = 0.2, target_s = 0.04, target_pixel_s = 3e-7, narrow_s = 1.5;
    double limit = plan->config->seconds, timing = limit / (1 + limit / narrow_s), seconds = 0;
    struct aob_table seen = {0};
    for (size_t i = 0; i < plan->case_count; i++) {
        const struct aob_case *c = &plan->cases[i];
        double pixels = (double)c->width * c->height;
        seconds += case_s + (plan->config->measure_time ? again_s + timing : 0) +
                   estimate_reference(&seen, c, plan) +
                   (double)c->scene->target_count * (target_s + target_pixel_s * pixels) +
                   aob_plan_estimate_cache_s(plan, c);
    }
    aob_table_finish(&seen);
    return seconds;
}
