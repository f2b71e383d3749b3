#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "command.h"
#include "gpu/gpu.h"
#include "run/measurement.h"
#include "run/record.h"
#include "run/sweep.h"
#include "store/metric.h"
#include "technique/param.h"

/* Texts as given on the command line; NULL: not given. */
struct options {
    struct aob_common common;
    const char *technique, *scene; /* scene: a listed one, a mesh file or capture:FILE */
    const char *view, *eye, *target, *fov, *ortho, *shift, *metres_per_unit, *size, *backend, *reference_spp;
    const char *target_radius, *target_weighting, *precision;
    const char *reference_radius;                 /* what the first of these was called */
    const char *convention[AOB_CONVENTION_COUNT]; /* of a capture, by enum aob_convention_key */
    const char *out;
    struct aob_words params; /* "name=value": parameters of the technique and run options */
};

#define TEXT(name, value, field, help)                                                                       \
    {                                                                                                        \
        name, value, help, AOB_FLAG_TEXT, offsetof(struct options, field)                                    \
    }
static const struct aob_flag flags[] = {
    TEXT("technique", "NAME", technique, "see: aobudget list techniques"),
    TEXT("scene", "NAME", scene, "a listed scene, a mesh file, or capture:FILE.exr"),
    TEXT("view", "NAME", view, "a listed view (the scene's first)"),
    TEXT("eye", "x,y,z", eye, "camera position, scene units"),
    TEXT("target", "x,y,z", target, "what the camera looks at"),
    TEXT("fov", "DEG", fov, "vertical field of view (60)"),
    TEXT("ortho", "H", ortho, "orthographic, H scene units high"),
    TEXT("shift", "x,y", shift, "image moved right, up; in its heights"),
    TEXT("metres-per-unit", "M", metres_per_unit, "of a mesh file or capture, for default lengths (1)"),
    TEXT("size", "WxH", size, "pixels (480x270)"),
    TEXT("backend", "NAME", backend, "see: aobudget list backends (vulkan)"),
    {"p", "name=value", "a parameter or run option; may be repeated", AOB_FLAG_MANY,
     offsetof(struct options, params)},
    TEXT("reference-spp", "N", reference_spp, "rays a pixel (256); 0: none"),
    TEXT("target-radius", "R[,R...]", target_radius,
         "what it is compared with: visibility of this radius (the technique's); inf allowed"),
    TEXT("target-weighting", "W", target_weighting, "of that visibility: cosine or uniform (cosine)"),
    TEXT("precision", "P%", precision,
         "timing ends where the interval is so narrow (3%), or after half a second"),
    TEXT("reference-radius", "R", reference_radius, "is now --target-radius"),
    TEXT("out", "FILE.exr", out, "the images"),
    TEXT("depth", "KIND", convention[AOB_CONVENTION_DEPTH],
         "of a capture: planar, distance, device or device_reversed (planar)"),
    TEXT("near", "D", convention[AOB_CONVENTION_NEAR], "near plane of a capture's device depth"),
    TEXT("far", "D", convention[AOB_CONVENTION_FAR],
         "its far plane, inf allowed; of other depths: sky from here on"),
    TEXT("normals", "SPACE", convention[AOB_CONVENTION_NORMALS],
         "of a capture: view, world or derived (view)"),
    TEXT("handed", "SIDE", convention[AOB_CONVENTION_HANDED],
         "of a capture's normals: right or left (right)"),
    TEXT("up", "x,y,z", convention[AOB_CONVENTION_UP], "the world's up, for normals world (0,1,0)"),
    TEXT("depth-channel", "NAME", convention[AOB_CONVENTION_DEPTH_CHANNEL],
         "of a capture, where it is not found by its name"),
    TEXT("normal-channel", "NAME", convention[AOB_CONVENTION_NORMAL_CHANNEL],
         "the same of its normals, without .X .Y .Z"),
    {0},
};

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

static bool choose_conventions(const struct options *o, struct aob_scene_choice *scene,
                               struct aob_error *error)
{
    for (int key = 0; key < AOB_CONVENTION_COUNT; key++) {
        if (!o->convention[key])
            continue;
        if (!scene->capture)
            return aob_fail(error, "%s is stated of a capture: --scene capture:FILE.exr",
                            aob_convention_keys[key]);
        if (!aob_convention_set(&scene->convention, (enum aob_convention_key)key, o->convention[key], error))
            return false;
    }
    if (scene->capture && (o->view || o->size))
        return aob_fail(error, "a capture has one view and its own size: leave --view and --size out");
    return aob_convention_check(&scene->convention, error);
}

static bool choose_camera(const struct options *o, struct aob_scene_choice *scene, struct aob_error *error)
{
    scene->fov_deg = scene->capture ? 0 : 60;
    scene->has_camera = o->eye != NULL;
    scene->ortho = o->ortho != NULL;
    if (!o->eye != !o->target)
        return aob_fail(error, "--eye and --target go together");
    if (o->eye && o->view)
        return aob_fail(error, "give --view or --eye, not both");
    if (!scene->capture && !o->eye && (o->fov || o->ortho || o->shift))
        return aob_fail(error, "--fov, --ortho and --shift need --eye and --target");
    if (scene->capture && o->shift)
        return aob_fail(error, "a capture is read as centred: leave --shift out");
    if (o->eye && !aob_parse_vec3(o->eye, scene->eye))
        return aob_fail(error, "--eye: '%s' is not x,y,z", o->eye);
    if (o->target && !aob_parse_vec3(o->target, scene->target))
        return aob_fail(error, "--target: '%s' is not x,y,z", o->target);
    if (o->shift && !aob_parse_vec2(o->shift, scene->shift))
        return aob_fail(error, "--shift: '%s' is not x,y", o->shift);
    return read_number("fov", o->fov, 1, 170, &scene->fov_deg, error) &&
           read_number("ortho", o->ortho, 1e-9, 1e12, &scene->ortho_height, error) &&
           read_number("metres-per-unit", o->metres_per_unit, AOB_CONFIG_MIN_UNIT, AOB_CONFIG_MAX_UNIT,
                       &scene->metres_per_unit, error);
}

static bool choose_params(const struct options *o, struct aob_config *config, struct aob_error *error)
{
    for (size_t i = 0; i < o->params.count; i++) {
        const char *equals = strchr(o->params.items[i], '=');
        if (!equals || equals == o->params.items[i])
            return aob_fail(error, "-p: '%s' is not name=value", o->params.items[i]);
        char *name = aob_strdup(o->params.items[i]);
        name[equals - o->params.items[i]] = '\0';
        if (aob_param_find(aob_option_params, AOB_OPTION_COUNT, name))
            aob_axis_add(&config->options, &config->option_count, &config->option_capacity, name, equals + 1);
        else
            aob_axis_add(&config->techniques->axes, &config->techniques->axis_count,
                         &config->techniques->axis_capacity, name, equals + 1);
        free(name);
    }
    return true;
}

static bool choose_precision(const struct options *o, struct aob_config *config, struct aob_error *error)
{
    return !o->precision || aob_config_parse_precision(o->precision, &config->precision, error) ||
           aob_fail_in(error, "--precision");
}

static bool choose_reference(const struct options *o, struct aob_config *config, struct aob_error *error)
{
    double spp = config->spp;
    if (!read_number("reference-spp", o->reference_spp, 0, 65536, &spp, error))
        return false;
    if (o->reference_radius)
        return aob_fail(error,
                        "--reference-radius is now --target-radius, with --target-weighting beside it");
    if (o->target_weighting && !o->target_radius)
        return aob_fail(error, "--target-weighting goes with --target-radius");
    const char *weighting = o->target_weighting ? o->target_weighting : "cosine";
    if (o->target_radius && !aob_config_add_targets(config, o->target_radius, weighting, error))
        return aob_fail_in(error, "--target-radius");
    if (spp != floor(spp) || fmod(spp, 2) != 0)
        return aob_fail(error, "--reference-spp: %s is not an even whole number (0: no reference)",
                        o->reference_spp);
    config->spp = (int)spp;
    config->measure_error = spp > 0;
    return true;
}

/* The command line as a config of one case. */
static bool make_config(const struct options *o, struct aob_config *config, struct aob_error *error)
{
    aob_config_init(config);
    config->name = aob_strdup("shot");
    config->seconds = 0.5;
    struct aob_scene_choice *scene = AOB_PUSH(config->scenes, config->scene_count, config->scene_capacity);
    const char *capture = aob_capture_file(o->scene);
    bool path = strchr(o->scene, '/') || aob_file_exists(o->scene); /* no scene's name has a slash */
    bool listed = capture || aob_scene_find(o->scene) || !path;
    *(capture  ? &scene->capture
      : listed ? &scene->name
               : &scene->file) = aob_strdup(capture ? capture : o->scene);
    scene->view = aob_strdup(o->view);
    if (!listed && o->view)
        return aob_fail(error, "a mesh file has no named views: use --eye, --target and --fov");
    struct aob_size *size = AOB_PUSH(config->sizes, config->size_count, config->size_capacity);
    const char *wanted = o->size ? o->size : "480x270";
    if (!aob_parse_size(wanted, &size->width, &size->height))
        return aob_fail(error, "--size: '%s' is not WIDTHxHEIGHT with 1 .. 16384 pixels each", wanted);
    struct aob_backend_choice *backends = &config->backends;
    struct aob_value *backend = AOB_PUSH(backends->names, backends->count, backends->capacity);
    backend->text = aob_strdup(o->backend ? o->backend : "vulkan");
    struct aob_technique_choice *technique =
        AOB_PUSH(config->techniques, config->technique_count, config->technique_capacity);
    technique->name.text = aob_strdup(o->technique);
    return choose_conventions(o, scene, error) && choose_camera(o, scene, error) &&
           choose_params(o, config, error) && choose_reference(o, config, error) &&
           choose_precision(o, config, error);
}

static void keep_record(void *user, size_t index, json_t *record)
{
    json_t **kept = user;
    (void)index;
    *kept = json_incref(record);
}

/* By its clock, with what its interval reaches to either side. */
static void print_time(const json_t *time, struct aob_text *text)
{
    const char *clock = json_string_value(json_object_get(time, "clock"));
    char member[16];
    snprintf(member, sizeof member, "%s_ms", clock);
    aob_text_add(text, ": %.3f ms %s, %.2f x fixed pass", json_number_value(json_object_get(time, member)),
                 clock, json_number_value(json_object_get(time, "ratio_to_ref")));
    const json_t *precision = json_object_get(time, "precision");
    if (json_is_number(precision))
        aob_text_add(text, " (+-%.2g %%)", 100 * json_number_value(precision));
}

static void print_record(const struct aob_sweep *sweep, const json_t *record, struct aob_text *out)
{
    const json_t *time = json_object_get(record, "time"), *error = json_object_get(record, "error");
    struct aob_text text = {0};
    aob_case_describe(&sweep->plan, &sweep->plan.cases[0], &text);
    if (time)
        print_time(time, &text);
    struct aob_metrics metrics;
    aob_metrics_from_json(&metrics, error);
    aob_metrics_print_brief(&metrics, ", ", &text);
    if (isfinite(metrics.reference_se))
        aob_text_add(&text, " (reference SE %.4f)", metrics.reference_se);
    aob_text_add_line(out, "%s", text.data);
    aob_text_finish(&text);
}

/* The record comes back whatever the case's status is; false with its reason if that is not ok. */
static bool measure(const struct options *o, struct aob_sweep *sweep, json_t **record,
                    struct aob_error *error)
{
    struct aob_measurement m;
    if (!aob_measurement_init(&m, &o->common.dispatch, &sweep->plan, error))
        return false;
    m.image = o->out;
    m.on_record = keep_record;
    m.user = record;
    aob_measurement_layout(&m);
    const struct aob_state *state = &m.states[0];
    if (state->stage == AOB_REFUSED)
        *record = aob_record_create(&(struct aob_record_desc){.config = &sweep->config,
                                                              .c = &sweep->plan.cases[0],
                                                              .state = state,
                                                              .status = state->status,
                                                              .reason = state->reason});
    else
        aob_measurement_block(&m, (size_t[]){0}, 1);
    aob_measurement_finish(&m);
    const char *status = json_string_value(json_object_get(*record, "status"));
    const char *reason = json_string_value(json_object_get(*record, "reason"));
    return strcmp(status, "ok") == 0 ||
           aob_fail(error, "%s: %s", status, reason ? reason : "no reason given");
}

/* Before anything is traced for it. */
static bool has_device(const struct options *o, struct aob_error *error)
{
    const struct aob_dispatch *dispatch = &o->common.dispatch;
    const char *backend = o->backend ? o->backend : "vulkan";
    if (!dispatch->device || !aob_gpu_find(backend))
        return true;
    json_t *device = aob_dispatch_probe(dispatch, backend, error);
    json_decref(device);
    return device;
}

static bool make_sweep(const struct options *o, struct aob_sweep *sweep, struct aob_error *error)
{
    if (!o->technique || !o->scene)
        return aob_fail(error, "shot: --technique and --scene are needed");
    if (!make_config(o, &sweep->config, error) || !aob_sweep_expand(sweep, &o->common.dispatch, error))
        return false;
    return sweep->plan.case_count == 1 ? has_device(o, error)
                                       : aob_fail(error, "shot takes one value a parameter");
}

static enum aob_exit shot(void *from, struct aob_error *error)
{
    struct options *o = from;
    struct aob_sweep sweep = {0};
    json_t *record = NULL;
    bool ok = make_sweep(o, &sweep, error) && measure(o, &sweep, &record, error);
    if (record && o->common.json && !aob_json_write(record, o->common.json, ok ? error : NULL))
        ok = false;
    if (ok && aob_common_speaks(&o->common))
        print_record(&sweep, record, &o->common.out);
    json_decref(record);
    aob_sweep_finish(&sweep);
    aob_words_finish(&o->params);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

const struct aob_command aob_command_shot = {
    .name = "shot",
    .help = "one frame, timed and scored",
    .usage = "--technique T --scene S [flags]",
    .summary = "One frame, timed and scored.",
    .flags = flags,
    .modules = true,
    .devices = true,
    .size = sizeof(struct options),
    .run = shot,
};
