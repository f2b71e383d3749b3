#include "plan.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "gpu/gpu.h"
#include "scene/scene_folder.h"
#include "scene/source.h"
#include "technique/param.h"

static bool fail_at(const struct aob_config *config, int line, int column, struct aob_error *error)
{
    if (!config->path || !line)
        return false;
    return aob_fail_in(error, "%s:%d:%d", config->path, line, column);
}

static bool fail_value(const struct aob_config *config, const struct aob_value *value,
                       struct aob_error *error)
{
    return fail_at(config, value->line, value->column, error);
}

static bool choose_view(struct aob_plan_scene *scene, const struct aob_scene_choice *choice,
                        struct aob_error *error)
{
    const struct aob_view *view = aob_scene_view(scene->info, choice->view);
    if (view) {
        scene->camera = view->camera;
        scene->view = aob_strdup(view->name);
        return true;
    }
    struct aob_text all = {0};
    for (size_t i = 0; i < scene->info->view_count; i++)
        aob_text_add(&all, "%s%s", i ? ", " : "", scene->info->views[i].name);
    aob_fail(error, "scene '%s' has no view '%s'; it has %s", scene->name, choice->view, all.data);
    aob_text_finish(&all);
    return false;
}

static struct aob_vec3 from_array(const double v[3])
{
    return aob_vec(v[0], v[1], v[2]);
}

static bool choose_camera(struct aob_plan_scene *scene, const struct aob_scene_choice *choice,
                          struct aob_error *error)
{
    if (choice->has_camera) {
        scene->view = aob_strdup("camera");
        scene->camera = (struct aob_camera){.eye = from_array(choice->eye),
                                            .target = from_array(choice->target),
                                            .fov_deg = choice->fov_deg,
                                            .ortho_height = choice->ortho ? choice->ortho_height : 0,
                                            .shift = {choice->shift[0], choice->shift[1]},
                                            .moves = choice->moves,
                                            .previous_eye = from_array(choice->previous.eye),
                                            .previous_target = from_array(choice->previous.target)};
        return aob_camera_check(&scene->camera, error);
    }
    if (scene->info)
        return choose_view(scene, choice, error);
    if (choice->view)
        return aob_fail(error,
                        "scene '%s' is a mesh file and has no named views: give eye, target and fov_deg",
                        scene->name);
    scene->view = aob_strdup("framed");
    scene->framed = true;
    return true;
}

static bool fail_unknown(const char *name, const struct aob_scene_folder *folder, struct aob_error *error)
{
    struct aob_text all = {0};
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++)
        aob_text_add(&all, "%s%s", s == aob_scenes ? "" : ", ", (*s)->name);
    for (size_t i = 0; i < folder->count; i++)
        aob_text_add(&all, ", %s", folder->files[i].name);
    aob_fail(error, "unknown scene '%s'; there are %s", name, all.data);
    aob_text_finish(&all);
    return false;
}

/* A listed scene, one of the user's folder by its name, or a mesh file. */
static bool find_scene(struct aob_plan_scene *scene, const struct aob_scene_choice *choice,
                       struct aob_error *error)
{
    struct aob_scene_folder folder;
    scene->info = choice->name ? aob_scene_find(choice->name) : NULL;
    scene->name = aob_strdup(choice->name ? choice->name : choice->file);
    scene->metres_per_unit = scene->info ? scene->info->metres_per_unit : 1;
    scene->file = aob_strdup(scene->info ? scene->info->file : choice->file);
    if (scene->info || choice->file)
        return true;
    if (!aob_scene_folder_read(&folder, error))
        return aob_fail_in(error, "unknown scene '%s'", scene->name);
    scene->file = aob_strdup(aob_scene_folder_find(&folder, scene->name));
    bool ok = scene->file || fail_unknown(scene->name, &folder, error);
    aob_scene_folder_finish(&folder);
    return ok;
}

/* A frame of another renderer, of the size and seen by the camera that it was loaded with. */
static bool choose_capture(struct aob_plan_scene *scene, const struct aob_scene_choice *choice,
                           struct aob_error *error)
{
    struct aob_text name = {0};
    aob_text_add(&name, "capture:%s", choice->capture);
    scene->name = name.data;
    scene->gbuffer = choice->gbuffer;
    scene->width = choice->width;
    scene->height = choice->height;
    scene->metres_per_unit = 1;
    memcpy(scene->digest, choice->digest, sizeof scene->digest);
    bool ok = choose_camera(scene, choice, error);
    free(scene->view);
    scene->view = aob_strdup("capture");
    return ok;
}

static bool choose_scene(struct aob_plan_scene *scene, const struct aob_scene_choice *choice,
                         struct aob_error *error)
{
    if (choice->capture)
        return choose_capture(scene, choice, error);
    if (!find_scene(scene, choice, error))
        return false;
    if (!aob_source_digest(scene->info, scene->file, scene->digest, error))
        return scene->info && scene->info->package && !aob_file_exists(scene->file)
                   ? aob_fail(error, "scene '%s' needs %s: apt-get install %s", scene->name, scene->file,
                              scene->info->package)
                   : false;
    return choose_camera(scene, choice, error);
}

static bool choose_scenes(struct aob_plan *plan, struct aob_error *error)
{
    const struct aob_config *config = plan->config;
    plan->scene_count = config->scene_count;
    plan->scenes = AOB_NEW_ARRAY(struct aob_plan_scene, config->scene_count);
    for (size_t i = 0; i < config->scene_count; i++)
        if (!choose_scene(&plan->scenes[i], &config->scenes[i], error))
            return fail_at(config, config->scenes[i].line, config->scenes[i].column, error);
    return true;
}

/* The axes of one technique and of the options, as indices into their tables with values parsed. */
struct axis {
    int row;
    double *values;
    size_t count, at;
};
struct axes {
    struct axis *items;
    size_t count;
};

static void free_axes(struct axes *axes)
{
    for (size_t i = 0; i < axes->count; i++)
        free(axes->items[i].values);
    free(axes->items);
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

static bool parse_axes(const struct aob_config *config, const char *owner, const struct aob_param *params,
                       size_t param_count, const struct aob_axis *from, size_t count, struct axes *axes,
                       struct aob_error *error)
{
    axes->items = AOB_NEW_ARRAY(struct axis, count);
    for (size_t i = 0; i < count; i++) {
        const struct aob_param *param = aob_param_find(params, param_count, from[i].name);
        if (!param) {
            unknown_axis(&from[i], owner, params, param_count, error);
            return fail_at(config, from[i].line, from[i].column, error);
        }
        struct axis *axis = &axes->items[axes->count++];
        axis->row = (int)(param - params);
        axis->count = from[i].count;
        axis->values = AOB_NEW_ARRAY(double, axis->count);
        for (size_t other = 0; other + 1 < axes->count; other++)
            if (axes->items[other].row == axis->row) {
                aob_fail(error, "'%s' is given twice for %s", from[i].name, owner);
                return fail_at(config, from[i].line, from[i].column, error);
            }
        for (size_t v = 0; v < axis->count; v++)
            if (!aob_param_parse(param, from[i].values[v].text, &axis->values[v], error)) {
                aob_fail_in(error, "%s", owner);
                return fail_value(config, &from[i].values[v], error);
            }
    }
    return true;
}

static bool next_combination(struct axes *axes)
{
    for (size_t i = axes->count; i-- > 0;) {
        if (++axes->items[i].at < axes->items[i].count)
            return true;
        axes->items[i].at = 0;
    }
    return false;
}

static void set_row(const struct axes *axes, double *values)
{
    for (size_t i = 0; i < axes->count; i++)
        values[axes->items[i].row] = axes->items[i].values[axes->items[i].at];
}

static double reference_radius(const struct aob_plan *plan, const struct aob_case *c)
{
    const struct aob_param *radius =
        aob_param_find(c->technique->params, c->technique->param_count, "radius");
    if (plan->config->reference_radius > 0)
        return plan->config->reference_radius;
    return radius ? c->params[radius - c->technique->params] : 1 / c->scene->metres_per_unit;
}

/* What decides the figures, and no more: the scene by its geometry and camera, whatever they are called. */
static void make_key(const struct aob_plan *plan, struct aob_case *c)
{
    struct aob_text text = {0};
    const struct aob_config *config = plan->config;
    aob_case_settings(c, &text);
    aob_text_add(&text, "\n%s %s %u\n%d ", c->scene->digest, c->technique->digest, c->technique->revision,
                 c->scene->framed);
    aob_camera_print(&c->scene->camera, true, &text);
    aob_text_add(&text, "\n%.9g %d %.9g %d%d%d %.9g", c->reference_radius, config->spp, config->thickness,
                 config->measure_time, config->measure_error, config->images, config->seconds);
    aob_hash_text(text.data, c->key);
    aob_text_finish(&text);
}

static bool key_is_new(const struct aob_plan *plan, const char *key)
{
    for (size_t i = plan->case_count; i-- > 0;)
        if (strcmp(plan->cases[i].key, key) == 0)
            return false;
    return true;
}

static bool add_cases(struct aob_plan *plan, struct aob_case *base, struct axes *params, struct axes *options,
                      struct aob_error *error)
{
    double values[AOB_MAX_PARAM];
    aob_param_defaults(base->technique->params, base->technique->param_count, values);
    base->params = values;
    do {
        set_row(params, values);
        do {
            set_row(options, base->options);
            if (!aob_case_judge(base, error))
                return false;
            base->reference_radius = reference_radius(plan, base);
            make_key(plan, base);
            if (!key_is_new(plan, base->key))
                continue;
            if (plan->case_count == AOB_PLAN_MAX_CASES)
                return aob_fail(error, "the sweep has more than %d cases", AOB_PLAN_MAX_CASES);
            struct aob_case *copy = AOB_PUSH(plan->cases, plan->case_count, plan->case_capacity);
            *copy = *base;
            copy->params = AOB_NEW_ARRAY(double, AOB_MAX_PARAM);
            memcpy(copy->params, values, sizeof values);
        } while (next_combination(options));
    } while (next_combination(params));
    return true;
}

/* A case without its technique: scene, size and backend chosen. */
static bool expand_techniques(struct aob_plan *plan, struct aob_case base,
                              const struct aob_technique_list *techniques, struct aob_error *error)
{
    const struct aob_config *config = plan->config;
    struct axes params = {0}, options = {0};
    bool ok = parse_axes(config, "options", aob_option_params, AOB_OPTION_COUNT, config->options,
                         config->option_count, &options, error);
    for (size_t t = 0; ok && t < config->technique_count; t++) {
        const struct aob_technique_choice *choice = &config->techniques[t];
        base.technique = aob_technique_list_find(techniques, choice->name.text);
        if (!base.technique) {
            aob_fail(error, "unknown technique '%s'; see: aobudget list techniques", choice->name.text);
            ok = fail_value(config, &choice->name, error);
            break;
        }
        aob_param_defaults(aob_option_params, AOB_OPTION_COUNT, base.options);
        params = (struct axes){0};
        ok = parse_axes(config, choice->name.text, base.technique->params, base.technique->param_count,
                        choice->axes, choice->axis_count, &params, error) &&
             add_cases(plan, &base, &params, &options, error);
        free_axes(&params);
    }
    free_axes(&options);
    return ok;
}

static bool expand(struct aob_plan *plan, const struct aob_technique_list *techniques,
                   struct aob_error *error)
{
    const struct aob_config *config = plan->config;
    for (size_t s = 0; s < plan->scene_count; s++) {
        const struct aob_size own = {plan->scenes[s].width, plan->scenes[s].height};
        const struct aob_size *sizes = plan->scenes[s].gbuffer ? &own : config->sizes;
        for (size_t r = 0; r < (sizes == &own ? 1 : config->size_count); r++)
            for (size_t b = 0; b < config->backend_count; b++) {
                const struct aob_gpu_fns *backend = aob_gpu_find(config->backends[b].text);
                if (!backend) {
                    aob_fail(error, "unknown backend '%s'; see: aobudget list backends",
                             config->backends[b].text);
                    return fail_value(config, &config->backends[b], error);
                }
                struct aob_case base = {.scene = &plan->scenes[s],
                                        .width = sizes[r].width,
                                        .height = sizes[r].height,
                                        .backend = backend->name};
                if (!expand_techniques(plan, base, techniques, error))
                    return false;
            }
    }
    return true;
}

/* Stable: cases of one block move up to its first case. */
static void gather_blocks(struct aob_plan *plan)
{
    for (size_t i = 0; i < plan->case_count; i++) {
        size_t end = i + 1;
        for (size_t j = i + 1; j < plan->case_count; j++) {
            if (!aob_case_same_block(&plan->cases[i], &plan->cases[j]))
                continue;
            struct aob_case moved = plan->cases[j];
            memmove(&plan->cases[end + 1], &plan->cases[end], (j - end) * sizeof moved);
            plan->cases[end++] = moved;
        }
        i = end - 1;
    }
}

bool aob_plan_create(struct aob_plan *plan, const struct aob_config *config,
                     const struct aob_technique_list *techniques, struct aob_error *error)
{
    *plan = (struct aob_plan){.config = config, .techniques = techniques};
    if (!choose_scenes(plan, error) || !expand(plan, techniques, error)) {
        aob_plan_finish(plan);
        return false;
    }
    gather_blocks(plan);
    return true;
}

void aob_plan_finish(struct aob_plan *plan)
{
    for (size_t i = 0; i < plan->case_count; i++)
        free(plan->cases[i].params);
    for (size_t i = 0; i < plan->scene_count; i++) {
        free(plan->scenes[i].name);
        free(plan->scenes[i].file);
        free(plan->scenes[i].view);
    }
    free(plan->cases);
    free(plan->scenes);
    *plan = (struct aob_plan){0};
}
