#include "drawing.h"
#include <stdlib.h>
#include "base/json.h"
#include "base/machine.h"
#include "technique/param.h"
#include "timing/fixed_pass.h"
#include "worker.h"

bool aob_drawing_load(struct aob_drawing *drawing, const struct aob_job_drawing *job, struct aob_error *error)
{
    const struct aob_job_view *view = &job->view;
    const struct aob_gbuffer_desc desc = {&view->camera, view->width, view->height, view->guard,
                                          view->frame > 0};
    drawing->job = job;
    aob_registry_init(&drawing->registry);
    return aob_gbuffer_load(&drawing->gbuffer, view->gbuffer, &desc, error);
}

static bool same_encoding(const struct aob_options *a, const struct aob_options *b)
{
    return a->depth_encoding == b->depth_encoding && a->normal_encoding == b->normal_encoding &&
           a->normals == b->normals && a->fetch == b->fetch && a->near == b->near && a->far == b->far;
}

/* `unfit` of a refusal is the device's. */
static struct aob_screen *use_screen(struct aob_drawing *drawing, const struct aob_options *options,
                                     bool *unfit, struct aob_error *error)
{
    for (size_t i = 0; i < drawing->screen_count; i++)
        if (same_encoding(&drawing->screen_options[i], options))
            return &drawing->screens[i];
    struct aob_screen *screen = &drawing->screens[drawing->screen_count];
    const struct aob_gbuffer *seen = drawing->drawn.depth ? &drawing->drawn : &drawing->gbuffer;
    bool ok = aob_screen_init(screen, drawing->gpu, seen, options, error);
    *unfit = screen->unfit;
    if (!ok)
        return NULL;
    const struct aob_frame_axes axes = aob_camera_axes(&drawing->job->view.camera);
    aob_light_turn(&drawing->job->view.light, &axes, &screen->light);
    screen->then = aob_camera_then(&drawing->job->view.camera);
    screen->geometry = drawing->geometry.count ? &drawing->geometry : NULL;
    drawing->screen_options[drawing->screen_count++] = *options;
    return screen;
}

bool aob_drawing_set(struct aob_drawing *drawing, const struct aob_job_frame *frame,
                     struct aob_drawing_part *part, struct aob_error *error)
{
    struct aob_options options;
    *part = (struct aob_drawing_part){0};
    part->technique = aob_registry_open(&drawing->registry, &frame->technique, error);
    if (!part->technique)
        return false;
    aob_param_pack(aob_option_params, AOB_OPTION_COUNT, frame->options, &options, sizeof options);
    if (!aob_worker_values(part->technique, frame->params, frame->param_count, part->values, error))
        return false;
    part->fetch = (enum aob_fetch)options.fetch;
    part->wanted = aob_options_wanted(&options);
    part->screen = use_screen(drawing, &options, &part->unfit, error);
    return part->screen;
}

bool aob_drawing_show(struct aob_drawing *drawing, const struct aob_gbuffer *gbuffer,
                      const struct aob_camera *camera, struct aob_error *error)
{
    const struct aob_frame_axes axes = aob_camera_axes(camera);
    struct aob_light light;
    aob_light_turn(&drawing->job->view.light, &axes, &light);
    const struct aob_screen_pose pose = {gbuffer, &light, aob_camera_then(camera)};
    for (size_t i = 0; i < drawing->screen_count; i++)
        if (!aob_screen_show(&drawing->screens[i], &pose, error))
            return false;
    return true;
}

json_t *aob_drawing_fingerprint(const struct aob_drawing *drawing)
{
    char processor[256];
    const char *threads = getenv("LP_NUM_THREADS");
    aob_machine_processor(processor, sizeof processor);
    const struct aob_gpu_info *gpu = &drawing->gpu->info;
    return json_pack("{s:s, s:o, s:i, s:s, s:o, s:o, s:s, s:i, s:o}", "program", AOBUDGET_VERSION, "cpu",
                     aob_json_text(processor), "cores", aob_machine_cores(), "backend", gpu->backend,
                     "device", aob_json_text(gpu->device), "driver", aob_json_text(gpu->driver), "class",
                     gpu->device_class, "fixed_pass", (int)aob_technique_fixed_pass.revision, "threads",
                     aob_json_text(threads ? threads : "default"));
}

/* The scene itself, where the cases need more of it than the G-buffer. */
static bool load_scene(struct aob_drawing *drawing, struct aob_error *error)
{
    if (!drawing->job->triangles && !drawing->job->raster)
        return true;
    if (!aob_worker_load(&drawing->job->view, &drawing->mesh, error))
        return false;
    if (!drawing->job->triangles)
        return true;
    aob_geometry_init(&drawing->geometry, &drawing->mesh, &drawing->job->view.camera);
    return aob_geometry_upload(&drawing->geometry, drawing->gpu, error);
}

bool aob_drawing_open(struct aob_drawing *drawing, struct aob_error *error)
{
    const struct aob_gpu_desc desc = {.validate = drawing->job->validate, .device = drawing->job->device};
    bool unfit; /* whatever stops it here is no case's fault */
    drawing->gpu = aob_gpu_open(drawing->job->backend, &desc, error);
    return drawing->gpu && load_scene(drawing, error) && aob_drawing_draw(drawing, error) &&
           use_screen(drawing, &(struct aob_options){0}, &unfit, error);
}

void aob_drawing_finish(struct aob_drawing *drawing)
{
    for (size_t i = 0; i < drawing->screen_count; i++)
        aob_screen_finish(&drawing->screens[i]);
    aob_geometry_finish(&drawing->geometry);
    aob_mesh_finish(&drawing->mesh);
    aob_gpu_close(drawing->gpu);
    aob_gbuffer_finish(&drawing->drawn);
    json_decref(drawing->difference);
    aob_gbuffer_finish(&drawing->gbuffer);
    aob_registry_finish(&drawing->registry);
    *drawing = (struct aob_drawing){0};
}
