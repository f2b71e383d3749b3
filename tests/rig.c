#include "rig.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "score/score.h"
#include "technique/definition.h"
#include "technique/param.h"
#include "technique/registry.h"

static void give_up(const char *what, const struct aob_error *error)
{
    fprintf(stderr, "%s: %s\n", what, error->text);
    exit(1);
}

void aob_rig_init(struct aob_rig *rig, const struct aob_mesh *mesh, const struct aob_camera *camera,
                  int width, int height, int guard)
{
    struct aob_error error = {{0}};
    *rig = (struct aob_rig){
        .camera = *camera, .light = aob_light_uniform, .width = width, .height = height, .guard = guard};
    struct aob_projection projection = aob_camera_projection(camera, width, height, guard);
    rig->tracer = aob_tracer_create(mesh, &error);
    if (!rig->tracer)
        give_up("tracer", &error);
    aob_tracer_cast(rig->tracer, camera, &projection, &rig->hits);
    aob_gbuffer_init(&rig->gbuffer, &rig->hits, &projection, guard);
    aob_gbuffer_paint(&rig->gbuffer, &rig->hits, mesh);
    aob_geometry_init(&rig->geometry, mesh, camera);
}

void aob_rig_scene(struct aob_rig *rig, const char *scene, const char *view, int width, int height, int guard)
{
    const struct aob_scene_info *info = aob_scene_find(scene);
    struct aob_mesh mesh = {0};
    info->build(&mesh);
    aob_rig_init(rig, &mesh, &aob_scene_view(info, view)->camera, width, height, guard);
    aob_mesh_finish(&mesh);
}

void aob_rig_plane(struct aob_rig *rig, const struct aob_rig_plane *plane)
{
    double t = plane->tilt_deg * M_PI / 180, a = plane->azimuth_deg * M_PI / 180;
    double distance = plane->distance > 0 ? plane->distance : 3, size = 150 * distance;
    struct aob_vec3 n = aob_vec(sin(t) * cos(a), sin(t) * sin(a), cos(t));
    struct aob_vec3 u =
        aob_vec_normalize(aob_vec_cross(fabs(n.y) < 0.9 ? aob_vec(0, 1, 0) : aob_vec(1, 0, 0), n));
    struct aob_vec3 v = aob_vec_cross(n, u);
    struct aob_mesh mesh = {0};
    struct aob_camera camera = {.eye = {0, 0, distance}, .fov_deg = plane->fov_deg > 0 ? plane->fov_deg : 60};
    aob_mesh_add_quad(&mesh, aob_vec_scale(aob_vec_add(u, v), -size / 2), aob_vec_scale(u, size),
                      aob_vec_scale(v, size));
    aob_rig_init(rig, &mesh, &camera, plane->width, plane->height, plane->guard);
    aob_mesh_finish(&mesh);
}

void aob_rig_finish(struct aob_rig *rig)
{
    aob_hits_finish(&rig->hits);
    aob_gbuffer_finish(&rig->gbuffer);
    aob_geometry_finish(&rig->geometry);
    aob_tracer_destroy(rig->tracer);
}

static const struct aob_technique *builtin(const char *name)
{
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        if (strcmp((*t)->name, name) == 0)
            return *t;
    fprintf(stderr, "no technique %s\n", name);
    exit(1);
}

const char *aob_rig_text(const char *technique, const char *name)
{
    for (const struct aob_shader *s = builtin(technique)->shaders; s->name; s++)
        if (strcmp(s->name, name) == 0)
            return s->text;
    fprintf(stderr, "%s has no text %s\n", technique, name);
    exit(1);
}

void aob_rig_params(const struct aob_technique *technique, const char *params, void *values,
                    struct aob_options *options)
{
    double numbers[AOB_MAX_PARAM], chosen[AOB_OPTION_COUNT];
    char copy[512], *rest = copy;
    struct aob_error error = {{0}};
    snprintf(copy, sizeof copy, "%s", params);
    aob_param_defaults(technique->params, technique->param_count, 1, numbers);
    aob_param_defaults(aob_option_params, AOB_OPTION_COUNT, 1, chosen);
    for (char *word; (word = strsep(&rest, " "));) {
        char *value = strchr(word, '=');
        if (!value)
            continue;
        *value++ = '\0';
        const struct aob_param *param = aob_param_find(technique->params, technique->param_count, word);
        const struct aob_param *option = aob_param_find(aob_option_params, AOB_OPTION_COUNT, word);
        if (param ? !aob_param_parse(param, value, &numbers[param - technique->params], &error)
                  : !option || !aob_param_parse(option, value, &chosen[option - aob_option_params], &error))
            give_up(word, &error);
    }
    aob_param_pack(technique->params, technique->param_count, numbers, values, 4 * AOB_MAX_PARAM);
    aob_param_pack(aob_option_params, AOB_OPTION_COUNT, chosen, options, sizeof *options);
}

void aob_rig_draw(const struct aob_rig *rig, struct aob_gpu *gpu, const struct aob_technique *technique,
                  const void *values, const struct aob_options *options,
                  float *const images[AOB_OUTPUT_COUNT])
{
    struct aob_frame_desc desc = {
        .technique = technique, .values = values, .fetch = (enum aob_fetch)options->fetch};
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    struct aob_screen screen;
    struct aob_error error = {{0}};
    struct aob_geometry geometry = rig->geometry;
    struct aob_frame_axes axes = aob_camera_axes(&rig->camera);
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        desc.wanted |= images[which] && which != AOB_OUT_VISIBILITY ? 1u << which : 0;
    desc.wanted |= options->thrift ? AOB_WANT_THRIFT : 0;
    bool ok = aob_geometry_upload(&geometry, gpu, &error) &&
              aob_screen_init(&screen, gpu, &rig->gbuffer, options, &error);
    screen.geometry = &geometry;
    aob_light_turn(&rig->light, &axes, &screen.light);
    ok = ok && aob_frame_init_desc(frame, &screen, &desc, &error) && aob_frame_run(frame, 1, NULL, &error);
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        ok = ok && (!images[which] ||
                    aob_frame_read(frame, (enum aob_output)which,
                                   aob_output_components((enum aob_output)which), images[which], &error));
    if (!ok)
        give_up(technique->name, &error);
    aob_frame_finish(frame);
    aob_screen_finish(&screen);
    aob_gpu_texture_destroy(gpu, geometry.texture);
    free(frame);
}

void aob_rig_probe(const struct aob_rig *rig, struct aob_gpu *gpu, const struct aob_technique *technique,
                   const void *values, const struct aob_options *options, float *pixels)
{
    aob_rig_draw(rig, gpu, technique, values, options, (float *[AOB_OUTPUT_COUNT]){pixels});
}

void aob_rig_run(const struct aob_rig *rig, struct aob_gpu *gpu, const char *name, const char *params,
                 enum aob_fetch fetch, float *pixels)
{
    aob_rig_run_open(rig, gpu, name, params, fetch, pixels, NULL);
}

void aob_rig_run_open(const struct aob_rig *rig, struct aob_gpu *gpu, const char *name, const char *params,
                      enum aob_fetch fetch, float *pixels, float (*bent)[3])
{
    aob_rig_run_outputs(rig, gpu, name, params, fetch,
                        (float *[AOB_OUTPUT_COUNT]){pixels, bent ? bent[0] : NULL});
}

void aob_rig_run_outputs(const struct aob_rig *rig, struct aob_gpu *gpu, const char *name, const char *params,
                         enum aob_fetch fetch, float *const images[AOB_OUTPUT_COUNT])
{
    const struct aob_technique *technique = builtin(name);
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    aob_rig_params(technique, params, values, &options);
    options.fetch = (int32_t)fetch;
    aob_rig_draw(rig, gpu, technique, values, &options, images);
}

void aob_rig_definition(const struct aob_rig *rig, const char *name, const char *params, int spp,
                        float *pixels)
{
    const struct aob_technique *technique = builtin(name);
    const struct aob_definition *definition = &technique->definition;
    struct aob_definition_table table;
    struct aob_error error = {{0}};
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    aob_rig_params(technique, params, values, &options);
    if (!aob_definition_tabulate(technique, values, &table, &error) || !table.claims)
        give_up(name, &error);
    struct aob_visibility_term term = {.radius = (double)table.radius,
                                       .uniform = table.uniform,
                                       .of_triangle = table.of_triangle,
                                       .falloff = table.fades ? table.falloff : NULL,
                                       .falloff_count = AOB_FALLOFF_ROWS};
    struct aob_visibility_desc desc = {.terms = &term,
                                       .term_count = 1,
                                       .x0 = rig->guard,
                                       .y0 = rig->guard,
                                       .width = rig->width,
                                       .height = rig->height,
                                       .spp = spp};
    struct aob_visibility traced;
    if (!aob_tracer_visibility(rig->tracer, &rig->camera, &rig->hits, &desc, &traced, &error))
        give_up(name, &error);
    for (int i = 0; i < rig->width * rig->height; i++)
        pixels[i] = definition->map ? definition->map(values, traced.ao[i]) : traced.ao[i];
    aob_visibility_finish(&traced);
}

struct aob_gpu *aob_rig_gpu(const char *backend)
{
    struct aob_error error = {{0}};
    struct aob_gpu *gpu =
        aob_gpu_open(backend, &(struct aob_gpu_desc){.validate = strcmp(backend, "vulkan") == 0}, &error);
    if (!gpu) {
        printf("no device: %s\n", error.text);
        exit(strstr(error.text, "install ") ? 77 : 1);
    }
    return gpu;
}

static const char *chosen; /* by aob_rig_device_tests, for open_device */

static int open_device(void **state)
{
    *state = aob_rig_gpu(chosen);
    return 0;
}

static int close_device(void **state)
{
    aob_gpu_close(*state);
    return 0;
}

int aob_rig_device_tests(int argc, char **argv, const struct CMUnitTest *tests, size_t count)
{
    const struct aob_gpu_fns *fns = argc == 2 ? aob_gpu_find(argv[1]) : NULL;
    if (!fns) {
        fprintf(stderr, "usage: %s vulkan|gl-egl|gl-osmesa|null\n", argv[0]);
        return 2;
    }
    for (const char *const *variable = fns->environment; *variable; variable++)
        putenv((char *)*variable);
    chosen = fns->name;
    /* What cmocka's macro calls: the macro takes arrays only. */
    return _cmocka_run_group_tests("tests", tests, count, open_device, close_device);
}

bool aob_rig_position(const struct aob_rig *rig, int x, int y, struct aob_vec3 *position)
{
    struct aob_vec3 origin, direction;
    size_t i = (size_t)(y + rig->guard) * (size_t)rig->hits.width + (size_t)(x + rig->guard);
    if (rig->hits.primitive[i] == AOB_NO_PRIMITIVE)
        return false;
    aob_camera_ray(&rig->camera, &rig->gbuffer.projection, x + rig->guard + 0.5, y + rig->guard + 0.5,
                   &origin, &direction);
    *position = aob_vec_add(origin, aob_vec_scale(direction, rig->hits.depth[i]));
    return true;
}

double aob_rig_corner_rmse(const struct aob_rig *rig, struct aob_gpu *gpu, const char *technique,
                           const char *params, double (*truth)(double d, double r), double radius)
{
    float *ao = AOB_NEW_ARRAY(float, (size_t)rig->width *(size_t)rig->height);
    double sum = 0;
    size_t count = 0;
    aob_rig_run(rig, gpu, technique, params, AOB_FETCH_STORAGE, ao);
    for (int y = 0; y < rig->height; y++)
        for (int x = 0; x < rig->width; x++) {
            struct aob_vec3 p;
            if (!aob_rig_position(rig, x, y, &p))
                continue;
            double v = truth(fmax(p.y, p.z), radius), e = ao[y * rig->width + x] - v;
            sum += v < AOB_BAND_LIMIT ? e * e : 0;
            count += v < AOB_BAND_LIMIT;
        }
    free(ao);
    return count > 500 ? sqrt(sum / (double)count) : INFINITY; /* a view that shows no band proves nothing */
}
