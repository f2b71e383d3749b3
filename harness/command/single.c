#include "single.h"
#include <math.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "gpu/gpu.h"
#include "run/measurement.h"
#include "run/record.h"
#include "technique/param.h"

bool aob_single_number(const char *flag, const char *text, double low, double high, double *value,
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

static bool choose_conventions(const struct aob_single_flags *o, struct aob_scene_choice *scene,
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

static bool choose_camera(const struct aob_single_flags *o, struct aob_scene_choice *scene,
                          struct aob_error *error)
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
    return aob_single_number("fov", o->fov, 1, 170, &scene->fov_deg, error) &&
           aob_single_number("ortho", o->ortho, 1e-9, 1e12, &scene->ortho_height, error) &&
           aob_single_number("metres-per-unit", o->metres_per_unit, AOB_CONFIG_MIN_UNIT, AOB_CONFIG_MAX_UNIT,
                             &scene->metres_per_unit, error);
}

static bool choose_motion(const struct aob_single_flags *o, struct aob_scene_choice *scene,
                          struct aob_error *error)
{
    double frames = 0;
    if (!o->last_eye != !o->last_target)
        return aob_fail(error, "--last-eye and --last-target go together");
    if (o->last_eye && !o->frames)
        return aob_fail(error, "--last-eye is where a sequence ends: give --frames, how many there are");
    if (!o->frames)
        return true;
    if (scene->capture)
        return aob_fail(error, "a capture is one frame: leave --frames out");
    if (scene->file && !o->eye)
        return aob_fail(error, "the sequence of a mesh file needs its camera: give --eye and --target");
    if (o->last_eye && !aob_parse_vec3(o->last_eye, scene->motion.last.eye))
        return aob_fail(error, "--last-eye: '%s' is not x,y,z", o->last_eye);
    if (o->last_target && !aob_parse_vec3(o->last_target, scene->motion.last.target))
        return aob_fail(error, "--last-target: '%s' is not x,y,z", o->last_target);
    if (!aob_single_number("frames", o->frames, AOB_CONFIG_MIN_FRAMES, AOB_CONFIG_MAX_FRAMES, &frames, error))
        return false;
    scene->motion.camera = o->last_eye;
    scene->motion.frames = (int)frames;
    return frames == floor(frames) || aob_fail(error, "--frames: %s is not a whole number", o->frames);
}

static bool choose_params(const struct aob_single_flags *o, struct aob_config *config,
                          struct aob_error *error)
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

/* The command line as a config of one case. */
bool aob_single_config(const char *name, const struct aob_single_flags *o, struct aob_config *config,
                       struct aob_error *error)
{
    aob_config_init(config);
    config->name = aob_strdup(name);
    if (!o->technique || !o->scene)
        return aob_fail(error, "%s: --technique and --scene are needed", name);
    struct aob_scene_choice *scene = AOB_PUSH(config->scenes, config->scene_count, config->scene_capacity);
    const char *capture = aob_capture_file(o->scene);
    bool path = strchr(o->scene, '/') || aob_file_exists(o->scene); /* no scene's name has a slash */
    bool listed = capture || aob_scene_find(o->scene) || !path;
    *(capture  ? &scene->capture
      : listed ? &scene->name
               : &scene->file) = aob_strdup(capture ? capture : o->scene);
    scene->view = aob_strdup(o->view);
    if (o->light)
        aob_config_take_light(scene, o->light);
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
           choose_motion(o, scene, error) && choose_params(o, config, error);
}

/* Before anything is traced for it. */
static bool has_device(const struct aob_dispatch *dispatch, const char *backend, struct aob_error *error)
{
    if (!dispatch->device || !aob_gpu_find(backend))
        return true;
    json_t *device = aob_dispatch_probe(dispatch, backend, error);
    json_decref(device);
    return device;
}

bool aob_single_expand(struct aob_sweep *sweep, const struct aob_dispatch *dispatch, struct aob_error *error)
{
    return aob_sweep_expand(sweep, dispatch, error) &&
           (sweep->plan.case_count == 1 ||
            aob_fail(error, "%s takes one value a parameter", sweep->config.name)) &&
           has_device(dispatch, sweep->config.backends.names->text, error);
}

static void keep_record(void *user, size_t index, json_t *record)
{
    json_t **kept = user;
    (void)index;
    *kept = json_incref(record);
}

bool aob_single_measure(const struct aob_single_desc *desc, struct aob_sweep *sweep, json_t **record,
                        struct aob_error *error)
{
    struct aob_measurement m;
    if (!aob_measurement_init(&m, desc->dispatch, &sweep->plan, error))
        return false;
    m.image = desc->image;
    m.map = desc->map;
    m.on_foretold = desc->on_foretold;
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
