#include "shot.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "run/captures.h"
#include "config/config.h"
#include "run/measurement.h"
#include "plan/plan.h"
#include "technique/param.h"

static bool read_number(const char *flag, const char *text, double low, double high, double *value,
                        struct aob_error *error)
{
    double v;
    if (!text)
        return true;
    if (!aob_parse_double(text, &v) || v < low || v > high)
        return aob_fail(error, "--%s: '%s' is not a number within %g .. %g", flag, text, low, high);
    *value = v;
    return true;
}

static bool choose_conventions(const struct aob_shot_desc *desc, struct aob_scene_choice *scene,
                               struct aob_error *error)
{
    for (int key = 0; key < AOB_CONVENTION_COUNT; key++) {
        if (!desc->convention[key])
            continue;
        if (!scene->capture)
            return aob_fail(error, "%s is stated of a capture: --scene capture:FILE.exr",
                            aob_convention_keys[key]);
        if (!aob_convention_set(&scene->convention, (enum aob_convention_key)key, desc->convention[key],
                                error))
            return false;
    }
    if (scene->capture && (desc->view || desc->size))
        return aob_fail(error, "a capture has one view and its own size: leave --view and --size out");
    return aob_convention_check(&scene->convention, error);
}

static bool choose_camera(const struct aob_shot_desc *desc, struct aob_scene_choice *scene,
                          struct aob_error *error)
{
    scene->fov_deg = scene->capture ? 0 : 60;
    scene->has_camera = desc->eye != NULL;
    scene->ortho = desc->ortho != NULL;
    if (!desc->eye != !desc->target)
        return aob_fail(error, "--eye and --target go together");
    if (desc->eye && desc->view)
        return aob_fail(error, "give --view or --eye, not both");
    if (!scene->capture && !desc->eye && (desc->fov || desc->ortho || desc->shift))
        return aob_fail(error, "--fov, --ortho and --shift need --eye and --target");
    if (scene->capture && desc->shift)
        return aob_fail(error, "a capture is read as centred: leave --shift out");
    if (desc->eye && !aob_parse_vec3(desc->eye, scene->eye))
        return aob_fail(error, "--eye: '%s' is not x,y,z", desc->eye);
    if (desc->target && !aob_parse_vec3(desc->target, scene->target))
        return aob_fail(error, "--target: '%s' is not x,y,z", desc->target);
    if (desc->shift && !aob_parse_vec2(desc->shift, scene->shift))
        return aob_fail(error, "--shift: '%s' is not x,y", desc->shift);
    return read_number("fov", desc->fov, 1, 170, &scene->fov_deg, error) &&
           read_number("ortho", desc->ortho, 1e-9, 1e12, &scene->ortho_height, error);
}

static bool choose_params(const struct aob_shot_desc *desc, struct aob_config *config,
                          struct aob_error *error)
{
    for (size_t i = 0; i < desc->param_count; i++) {
        const char *equals = strchr(desc->params[i], '=');
        if (!equals || equals == desc->params[i])
            return aob_fail(error, "-p: '%s' is not name=value", desc->params[i]);
        char *name = aob_strdup(desc->params[i]);
        name[equals - desc->params[i]] = '\0';
        if (aob_param_find(aob_option_params, AOB_OPTION_COUNT, name))
            aob_axis_add(&config->options, &config->option_count, &config->option_capacity, name, equals + 1);
        else
            aob_axis_add(&config->techniques->axes, &config->techniques->axis_count,
                         &config->techniques->axis_capacity, name, equals + 1);
        free(name);
    }
    return true;
}

static bool choose_reference(const struct aob_shot_desc *desc, struct aob_config *config,
                             struct aob_error *error)
{
    double spp = config->spp;
    if (!read_number("reference-spp", desc->reference_spp, 0, 65536, &spp, error))
        return false;
    if (desc->reference_radius)
        return aob_fail(error,
                        "--reference-radius is now --target-radius, with --target-weighting beside it");
    if (desc->target_weighting && !desc->target_radius)
        return aob_fail(error, "--target-weighting goes with --target-radius");
    if (desc->target_radius &&
        !aob_config_add_targets(config, desc->target_radius,
                                desc->target_weighting ? desc->target_weighting : "cosine", error))
        return aob_fail_in(error, "--target-radius");
    if (spp != floor(spp) || fmod(spp, 2) != 0)
        return aob_fail(error, "--reference-spp: %s is not an even whole number (0: no reference)",
                        desc->reference_spp);
    config->spp = (int)spp;
    config->measure_error = spp > 0;
    return true;
}

/* The command line as a config of one case. */
static bool make_config(const struct aob_shot_desc *desc, struct aob_config *config, struct aob_error *error)
{
    aob_config_init(config);
    config->name = aob_strdup("shot");
    config->seconds = 0.5;
    struct aob_scene_choice *scene = AOB_PUSH(config->scenes, config->scene_count, config->scene_capacity);
    const char *capture = aob_capture_file(desc->scene);
    bool listed = capture || aob_scene_find(desc->scene) || !aob_file_exists(desc->scene);
    *(capture  ? &scene->capture
      : listed ? &scene->name
               : &scene->file) = aob_strdup(capture ? capture : desc->scene);
    scene->view = aob_strdup(desc->view);
    if (!listed && desc->view)
        return aob_fail(error, "a mesh file has no named views: use --eye, --target and --fov");
    struct aob_size *size = AOB_PUSH(config->sizes, config->size_count, config->size_capacity);
    const char *wanted = desc->size ? desc->size : "480x270";
    if (!aob_parse_size(wanted, &size->width, &size->height))
        return aob_fail(error, "--size: '%s' is not WIDTHxHEIGHT with 1 .. 16384 pixels each", wanted);
    struct aob_value *backend = AOB_PUSH(config->backends, config->backend_count, config->backend_capacity);
    backend->text = aob_strdup(desc->backend ? desc->backend : "vulkan");
    struct aob_technique_choice *technique =
        AOB_PUSH(config->techniques, config->technique_count, config->technique_capacity);
    technique->name.text = aob_strdup(desc->technique);
    return choose_conventions(desc, scene, error) && choose_camera(desc, scene, error) &&
           choose_params(desc, config, error) && choose_reference(desc, config, error);
}

struct shot {
    const struct aob_plan *plan;
    json_t *record;
};

static void keep_record(void *user, size_t index, json_t *record)
{
    struct shot *shot = user;
    (void)index;
    shot->record = json_incref(record);
}

static void print_record(const struct shot *shot)
{
    const json_t *time = json_object_get(shot->record, "time"),
                 *error = json_object_get(shot->record, "error");
    struct aob_text text = {0};
    aob_case_describe(shot->plan, &shot->plan->cases[0], &text);
    if (time)
        aob_text_add(&text, ": %.3f ms cpu, %.2f x fixed pass",
                     json_number_value(json_object_get(time, "cpu_ms")),
                     json_number_value(json_object_get(time, "ratio_to_ref")));
    if (error)
        aob_text_add(&text, "; rmse %.4f, in band %.4f, bias %+.4f (reference SE %.4f)",
                     aob_json_to_number(json_object_get(error, "rmse")),
                     aob_json_to_number(json_object_get(error, "band_rmse")),
                     aob_json_to_number(json_object_get(error, "bias")),
                     aob_json_to_number(json_object_get(error, "reference_se")));
    printf("%s\n", text.data);
    aob_text_finish(&text);
}

static bool measure(const struct aob_shot_desc *desc, struct aob_plan *plan, struct shot *shot,
                    struct aob_error *error)
{
    struct aob_measurement m;
    if (!aob_measurement_init(&m, &desc->dispatch, plan, error))
        return false;
    m.image = desc->out;
    m.on_record = keep_record;
    m.user = shot;
    aob_measurement_layout(&m);
    if (m.states[0].stage == AOB_REFUSED)
        shot->record = aob_record_create(&m, 0, m.states[0].status, m.states[0].reason, NULL);
    else
        aob_measurement_block(&m, (size_t[]){0}, 1);
    aob_measurement_finish(&m);
    const char *status = json_string_value(json_object_get(shot->record, "status"));
    const char *reason = json_string_value(json_object_get(shot->record, "reason"));
    return strcmp(status, "ok") == 0 ||
           aob_fail(error, "%s: %s", status, reason ? reason : "no reason given");
}

enum aob_exit aob_shot(const struct aob_shot_desc *desc, struct aob_error *error)
{
    struct aob_config config;
    struct aob_technique_list techniques = {0};
    struct aob_plan plan = {0};
    struct shot shot = {.plan = &plan};
    bool ok = make_config(desc, &config, error) &&
              aob_dispatch_describe(&desc->dispatch, &techniques, error) &&
              aob_captures_load(&config, &desc->dispatch, error) &&
              aob_plan_create(&plan, &config, &techniques, error);
    if (ok && plan.case_count != 1)
        ok = aob_fail(error, "shot takes one value a parameter");
    ok = ok && measure(desc, &plan, &shot, error);
    if (shot.record && desc->json && !aob_json_write(shot.record, desc->json, ok ? error : NULL))
        ok = false;
    if (ok && !desc->quiet && !(desc->json && strcmp(desc->json, "-") == 0))
        print_record(&shot);
    json_decref(shot.record);
    aob_plan_finish(&plan);
    aob_technique_list_finish(&techniques);
    aob_config_finish(&config);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}
