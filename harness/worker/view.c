#include "job/view_job.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/machine.h"
#include "base/memory.h"
#include "gbuffer/gbuffer.h"
#include "reference/bound.h"
#include "reference/incident.h"
#include "reference/lit.h"
#include "reference/specular.h"
#include "reference/tracer.h"
#include "store/image.h"
#include "worker.h"

static bool write_visibility(const struct aob_visibility *visibility, const struct aob_job_view *view,
                             const char *path, struct aob_error *error)
{
    static const char *const bent[3] = {"B.X", "B.Y", "B.Z"};
    struct aob_image image = {.width = view->width, .height = view->height};
    size_t pixels = (size_t)view->width * (size_t)view->height;
    memcpy(aob_image_add(&image, "AO"), visibility->ao, pixels * sizeof(float));
    memcpy(aob_image_add(&image, "SE"), visibility->se, pixels * sizeof(float));
    for (int c = 0; c < 3 && visibility->bent; c++)
        aob_image_add_part(&image, bent[c], visibility->bent[0] + c, 3);
    bool ok = aob_image_write(&image, path, error);
    aob_image_finish(&image);
    return ok;
}

/* Channels R G B and SE.R SE.G SE.B, or the first of each where there is one component. */
static bool write_effect(const float *values, const float *errors, int components,
                         const struct aob_job_view *view, const char *path, struct aob_error *error)
{
    static const char *const names[2][3] = {{"R", "G", "B"}, {"SE.R", "SE.G", "SE.B"}};
    struct aob_image image = {.width = view->width, .height = view->height};
    size_t stride = (size_t)components;
    for (size_t c = 0; c < stride; c++) {
        aob_image_add_part(&image, names[0][c], values + c, stride);
        aob_image_add_part(&image, names[1][c], errors + c, stride);
    }
    bool ok = aob_image_write(&image, path, error);
    aob_image_finish(&image);
    return ok;
}

/* A view while its job is done. */
struct scene {
    const struct aob_view_job *job;
    struct aob_projection projection;
    struct aob_mesh mesh;
    struct aob_tracer *tracer; /* NULL of a capture, whose only surfaces are its pixels */
    struct aob_hits hits;
    bool *traced; /* of each term of the job */
};

/* At least: 72 bytes a pixel were measured for the hits and their file, and the terms of one trace are held together, those of
 * further outputs one by one with their file.
 * What a screen-space bound takes depends on what the view shows (reference/bound.h). */
static double bytes_of(const struct aob_view_job *job)
{
    const struct aob_job_view *view = &job->view;
    double pixels = (double)view->width * view->height, bytes = 0, effects = 0;
    for (size_t i = 0; i < job->term_count; i++) {
        const struct aob_term *term = &job->terms[i].term;
        if (term->output == AOB_OUT_LIT)
            effects =
                fmax(effects, 16 * pixels * 5); /* made of irradiance and of mirrored light with its share */
        else if (term->output != AOB_OUT_VISIBILITY)
            effects = fmax(effects, 16 * pixels * aob_output_components(term->output));
        else if (!term->bound)
            bytes += (term->bent ? 20 : 8) * pixels;
    }
    return bytes + effects + 72.0 * (view->width + 2 * view->guard) * (view->height + 2 * view->guard);
}

static bool judge_memory(const struct aob_view_job *job, struct aob_error *error)
{
    const struct aob_job_view *view = &job->view;
    double bytes = bytes_of(job), memory = (double)aob_machine_memory();
    return bytes <= memory ||
           aob_fail(
               error,
               "a view of %dx%d pixels with a guard band of %d and %zu visibilities needs %.3g GB of memory, "
               "and it may take %.3g GB: lower the resolution or the guard band, or give fewer targets",
               view->width, view->height, view->guard, job->term_count, bytes * 1e-9, memory * 1e-9);
}

/* Nothing could be compared: every figure of the view would be the mean of no pixel. The guard band does not count. */
static bool judge_hits(const struct scene *scene, struct aob_error *error)
{
    const struct aob_job_view *view = &scene->job->view;
    const struct aob_camera *camera = &view->camera;
    for (int y = view->guard; y < view->guard + view->height; y++)
        for (int x = view->guard; x < view->guard + view->width; x++)
            if (scene->hits.primitive[(size_t)y * (size_t)scene->hits.width + (size_t)x] != AOB_NO_PRIMITIVE)
                return true;
    return aob_fail(error,
                    "no pixel of the view shows a surface: move or turn the camera (eye %g,%g,%g, target "
                    "%g,%g,%g)",
                    camera->eye.x, camera->eye.y, camera->eye.z, camera->target.x, camera->target.y,
                    camera->target.z);
}

static bool cast_view(struct scene *scene, struct aob_error *error)
{
    const struct aob_job_view *view = &scene->job->view;
    if (!aob_worker_load(view, &scene->mesh, error))
        return false;
    scene->tracer = aob_tracer_create(&scene->mesh, error);
    if (!scene->tracer)
        return false;
    aob_tracer_cast(scene->tracer, &view->camera, &scene->projection, &scene->hits);
    if (!judge_hits(scene, error))
        return false;
    return !scene->job->cast || aob_gbuffer_store(&scene->hits, &scene->mesh, view->gbuffer, error);
}

/* A capture has no geometry: what is seen comes from its G-buffer. */
static bool load_view(struct scene *scene, struct aob_error *error)
{
    const struct aob_job_view *view = &scene->job->view;
    struct aob_gbuffer gbuffer;
    if (!aob_gbuffer_load(&gbuffer, view->gbuffer,
                          &(struct aob_gbuffer_desc){&view->camera, view->width, view->height, view->guard,
                                                     view->frame > 0},
                          error))
        return false;
    aob_gbuffer_hits(&gbuffer, &scene->hits);
    aob_gbuffer_finish(&gbuffer);
    return true;
}

/* The terms that one trace computes. */
struct trace {
    const struct aob_term *first; /* what they have in common is its */
    struct aob_visibility_term *terms;
    const char **paths;
    size_t count;
};

/* Those that go with `first`. */
static void get_terms(const struct scene *scene, struct trace *trace)
{
    const struct aob_view_job *job = scene->job;
    for (size_t i = 0; i < job->term_count; i++) {
        const struct aob_term *term = &job->terms[i].term;
        if (!aob_term_same_trace(term, trace->first))
            continue;
        scene->traced[i] = true;
        trace->paths[trace->count] = job->terms[i].out;
        trace->terms[trace->count++] = (struct aob_visibility_term){.radius = term->radius,
                                                                    .uniform = term->uniform,
                                                                    .of_triangle = term->of_triangle,
                                                                    .bent = term->bent,
                                                                    .falloff = term->falloff,
                                                                    .falloff_count = term->falloff_count};
    }
}

static enum aob_bound_kind kind_of(double thickness)
{
    if (isinf(thickness))
        return AOB_BOUND_INFINITE;
    return thickness > 0 ? AOB_BOUND_SLAB : AOB_BOUND_THIN;
}

static bool trace_bound(const struct scene *scene, double thickness, const struct aob_visibility_desc *desc,
                        struct aob_visibility *result, struct aob_error *error)
{
    struct aob_bound_desc kind = {
        .kind = kind_of(thickness), .thickness = thickness, .memory = aob_machine_memory()};
    struct aob_bound *bound =
        aob_bound_create(&scene->job->view.camera, &scene->projection, &scene->hits, &kind, error);
    bool ok = bound && aob_bound_visibility(bound, desc, result, error);
    aob_bound_destroy(bound);
    return ok;
}

static bool compute(const struct scene *scene, const struct trace *trace, struct aob_visibility *result,
                    struct aob_error *error)
{
    const struct aob_job_view *view = &scene->job->view;
    const struct aob_visibility_desc desc = {.terms = trace->terms,
                                             .term_count = trace->count,
                                             .x0 = view->guard,
                                             .y0 = view->guard,
                                             .width = view->width,
                                             .height = view->height,
                                             .spp = scene->job->spp,
                                             .seed = view->seed};
    if (trace->first->bound)
        return trace_bound(scene, trace->first->thickness, &desc, result, error);
    return aob_tracer_visibility(scene->tracer, &view->camera, &scene->hits, &desc, result, error);
}

static bool trace_terms(const struct scene *scene, const struct trace *trace, struct aob_error *error)
{
    struct aob_visibility *result = AOB_NEW_ARRAY(struct aob_visibility, trace->count);
    bool ok = compute(scene, trace, result, error);
    for (size_t i = 0; i < trace->count; i++) {
        ok = ok && write_visibility(&result[i], &scene->job->view, trace->paths[i], error);
        aob_visibility_finish(&result[i]);
    }
    free(result);
    return ok;
}

static bool trace_incident(const struct scene *scene, const struct aob_view_term *term,
                           struct aob_error *error)
{
    const struct aob_job_view *view = &scene->job->view;
    bool lit = term->term.output == AOB_OUT_LIT;
    const struct aob_incident_desc desc = {.radius = term->term.radius,
                                           .bounces = term->term.bounces,
                                           .light =
                                               aob_term_has_light(&term->term) ? &term->term.light : NULL,
                                           .x0 = view->guard,
                                           .y0 = view->guard,
                                           .width = view->width,
                                           .height = view->height,
                                           .spp = scene->job->spp};
    struct aob_incident result = {0};
    bool ok = (lit ? aob_tracer_lit : aob_tracer_incident)(scene->tracer, &view->camera, &scene->hits, &desc,
                                                           &result, error) &&
              write_effect(result.rgb[0], result.se[0], 3, view, term->out, error);
    aob_incident_finish(&result);
    return ok;
}

static bool trace_specular(const struct scene *scene, const struct aob_view_term *term,
                           struct aob_error *error)
{
    const struct aob_job_view *view = &scene->job->view;
    const struct aob_specular_desc desc = {.radius = term->term.radius,
                                           .roughness = -1,
                                           .x0 = view->guard,
                                           .y0 = view->guard,
                                           .width = view->width,
                                           .height = view->height,
                                           .spp = scene->job->spp};
    struct aob_specular result = {0};
    bool ok = aob_tracer_specular(scene->tracer, &view->camera, &scene->hits, &desc, &result, error) &&
              write_effect(result.so, result.se, 1, view, term->out, error);
    aob_specular_finish(&result);
    return ok;
}

/* The truth of one output besides visibility. */
static bool trace_effect(const struct scene *scene, const struct aob_view_term *term, struct aob_error *error)
{
    if (!scene->tracer)
        return aob_fail(error, "a capture has no surfaces to trace the truth of its %s",
                        aob_output_name(term->term.output));
    return term->term.output == AOB_OUT_SPECULAR ? trace_specular(scene, term, error)
                                                 : trace_incident(scene, term, error);
}

/* One trace for all terms that the same rays serve. */
static bool trace_with(const struct scene *scene, const struct aob_term *first, struct aob_error *error)
{
    size_t most = scene->job->term_count;
    struct trace trace = {.first = first,
                          .terms = AOB_NEW_ARRAY(struct aob_visibility_term, most),
                          .paths = AOB_NEW_ARRAY(const char *, most)};
    get_terms(scene, &trace);
    bool ok = trace_terms(scene, &trace, error);
    free(trace.terms);
    free(trace.paths);
    return ok;
}

static bool view(struct aob_worker *worker, struct aob_error *error)
{
    struct aob_view_job job;
    if (!aob_view_job_from_json(worker->job, &job, error))
        return false;
    struct scene scene = {.job = &job,
                          .projection = aob_camera_projection(&job.view.camera, job.view.width,
                                                              job.view.height, job.view.guard),
                          .traced = AOB_NEW_ARRAY(bool, job.term_count)};
    bool ok = judge_memory(&job, error) &&
              (job.view.captured ? load_view(&scene, error) : cast_view(&scene, error));
    for (size_t i = 0; ok && i < job.term_count; i++)
        if (job.terms[i].term.output != AOB_OUT_VISIBILITY)
            ok = trace_effect(&scene, &job.terms[i], error);
        else if (!scene.traced[i])
            ok = trace_with(&scene, &job.terms[i].term, error);
    aob_hits_finish(&scene.hits);
    aob_tracer_destroy(scene.tracer);
    aob_mesh_finish(&scene.mesh);
    free(scene.traced);
    aob_view_job_finish(&job);
    return ok;
}

const struct aob_worker_job aob_worker_view = {"view", view};
