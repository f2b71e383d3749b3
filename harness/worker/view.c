#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/clock.h"
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "gbuffer/gbuffer.h"
#include "reference/bound.h"
#include "reference/tracer.h"
#include "scene/scene.h"
#include "store/image.h"
#include "worker.h"

bool aob_worker_mesh(const json_t *job, struct aob_mesh *mesh, struct aob_error *error)
{
    const char *path = json_string_value(json_object_get(job, "mesh"));
    const char *name = json_string_value(json_object_get(job, "scene"));
    const struct aob_scene_info *scene = name ? aob_scene_find(name) : NULL;
    if (path)
        return aob_mesh_restore(mesh, path, error);
    if (!scene || !scene->build)
        return aob_fail(error, "the job has no mesh and no procedural scene");
    scene->build(mesh);
    return true;
}

static bool write_visibility(const struct aob_visibility *visibility, int width, int height, const char *path,
                             struct aob_error *error)
{
    struct aob_image image = {.width = width, .height = height};
    size_t bytes = (size_t)width * (size_t)height * sizeof(float);
    memcpy(aob_image_add(&image, "AO"), visibility->ao, bytes);
    memcpy(aob_image_add(&image, "SE"), visibility->se, bytes);
    bool ok = aob_image_write(&image, path, error);
    aob_image_finish(&image);
    return ok;
}

struct view {
    struct aob_camera camera;
    int width, height, guard, spp, captured;
    const char *gbuffer;
    json_t *terms;
    struct aob_mesh mesh;
    struct aob_tracer *tracer;
    struct aob_hits hits;
};

static bool get_view(const json_t *job, struct view *view, struct aob_error *error)
{
    if (json_unpack((json_t *)(uintptr_t)job, "{s:i, s:i, s:i, s:i, s:b, s:s, s:o}", "width", &view->width,
                    "height", &view->height, "guard", &view->guard, "spp", &view->spp, "captured",
                    &view->captured, "gbuffer", &view->gbuffer, "terms", &view->terms) != 0)
        return aob_fail(error, "a view job lacks a field");
    return aob_worker_camera(json_object_get(job, "camera"), &view->camera, error);
}

static bool cast_view(struct view *view, struct aob_error *error)
{
    struct aob_projection projection =
        aob_camera_projection(&view->camera, view->width, view->height, view->guard);
    view->tracer = aob_tracer_create(&view->mesh, error);
    if (!view->tracer)
        return false;
    aob_tracer_cast(view->tracer, &view->camera, &projection, &view->hits);
    return aob_file_exists(view->gbuffer) ||
           aob_gbuffer_store(&view->hits, &view->mesh, view->gbuffer, error);
}

/* A capture has no geometry: what is seen comes from its G-buffer. */
static bool load_view(struct view *view, struct aob_error *error)
{
    struct aob_gbuffer gbuffer;
    if (!aob_gbuffer_load(&gbuffer, view->gbuffer, &view->camera, view->width, view->height, view->guard,
                          error))
        return false;
    aob_gbuffer_hits(&gbuffer, &view->hits);
    aob_gbuffer_finish(&gbuffer);
    return true;
}

/* The terms that one trace computes. */
struct trace {
    bool uniform, of_triangle, screen;
    double thickness; /* of the screen-space bound's surfaces */
    struct aob_visibility_term *terms;
    const char **paths;
    size_t count;
};

static bool same_trace(const json_t *a, const json_t *b)
{
    return json_is_true(json_object_get(a, "uniform")) == json_is_true(json_object_get(b, "uniform")) &&
           json_is_true(json_object_get(a, "of_triangle")) ==
               json_is_true(json_object_get(b, "of_triangle")) &&
           (json_object_get(a, "screen") == json_object_get(b, "screen") ||
            json_equal(json_object_get(a, "screen"), json_object_get(b, "screen")));
}

/* Those that go with `first` and whose files are missing. Their falloff tables are owned by the terms. */
static void get_terms(const json_t *list, const json_t *first, struct trace *trace)
{
    trace->uniform = json_is_true(json_object_get(first, "uniform"));
    trace->of_triangle = json_is_true(json_object_get(first, "of_triangle"));
    trace->screen = json_object_get(first, "screen");
    trace->thickness = aob_json_to_number(json_object_get(first, "screen"));
    for (size_t i = 0; i < json_array_size(list); i++) {
        const json_t *term = json_array_get(list, i), *falloff = json_object_get(term, "falloff");
        const char *path = json_string_value(json_object_get(term, "out"));
        if (!path || aob_file_exists(path) || !same_trace(term, first))
            continue;
        float *table = json_is_array(falloff) ? AOB_NEW_ARRAY(float, json_array_size(falloff)) : NULL;
        for (size_t k = 0; k < json_array_size(falloff); k++)
            table[k] = (float)json_number_value(json_array_get(falloff, k));
        trace->paths[trace->count] = path;
        trace->terms[trace->count++] =
            (struct aob_visibility_term){.radius = aob_json_to_number(json_object_get(term, "radius")),
                                         .uniform = trace->uniform,
                                         .of_triangle = trace->of_triangle,
                                         .falloff = table,
                                         .falloff_count = json_array_size(falloff)};
    }
}

static bool compute(const struct view *view, const struct trace *trace, struct aob_visibility *result,
                    struct aob_error *error)
{
    const struct aob_visibility_desc desc = {.terms = trace->terms,
                                             .term_count = trace->count,
                                             .x0 = view->guard,
                                             .y0 = view->guard,
                                             .width = view->width,
                                             .height = view->height,
                                             .spp = view->spp};
    if (!trace->screen)
        return aob_tracer_visibility(view->tracer, &view->camera, &view->hits, &desc, result, error);
    struct aob_projection projection =
        aob_camera_projection(&view->camera, view->width, view->height, view->guard);
    struct aob_bound_desc kind = {.kind = isinf(trace->thickness) ? AOB_BOUND_INFINITE
                                          : trace->thickness > 0  ? AOB_BOUND_SLAB
                                                                  : AOB_BOUND_THIN,
                                  .thickness = trace->thickness};
    struct aob_bound *bound = aob_bound_create(&view->camera, &projection, &view->hits, &kind, error);
    bool ok = bound && aob_bound_visibility(bound, &desc, result, error);
    aob_bound_destroy(bound);
    return ok;
}

static bool trace_terms(struct aob_worker *worker, const struct view *view, const struct trace *trace,
                        struct aob_error *error)
{
    int64_t start = aob_clock_wall_ns();
    struct aob_visibility *result = AOB_NEW_ARRAY(struct aob_visibility, trace->count);
    bool ok = compute(view, trace, result, error);
    if (ok)
        aob_worker_reply(worker,
                         json_pack("{s:f, s:f}", "trace_s", (double)(aob_clock_wall_ns() - start) * 1e-9,
                                   "rays", (double)view->width * view->height * view->spp));
    for (size_t i = 0; i < trace->count; i++) {
        ok = ok && write_visibility(&result[i], view->width, view->height, trace->paths[i], error);
        aob_visibility_finish(&result[i]);
    }
    free(result);
    return ok;
}

/* One trace for each weighting: a cosine term traced beside a uniform one has other noise, and a cached file
 * must not depend on what else was wanted when it was made. One for each kind of distance, whose rays differ in length.
 * And one for each surface: the scene's, each bound's. */
static bool trace_with(struct aob_worker *worker, const struct view *view, const json_t *first,
                       struct aob_error *error)
{
    size_t most = json_array_size(view->terms);
    struct trace trace = {.terms = AOB_NEW_ARRAY(struct aob_visibility_term, most),
                          .paths = AOB_NEW_ARRAY(const char *, most)};
    get_terms(view->terms, first, &trace);
    bool ok = !trace.count || trace_terms(worker, view, &trace, error);
    for (size_t i = 0; i < trace.count; i++)
        free((void *)(uintptr_t)trace.terms[i].falloff);
    free(trace.terms);
    free(trace.paths);
    return ok;
}

bool aob_worker_view(struct aob_worker *worker, struct aob_error *error)
{
    struct view view = {0};
    bool ok = get_view(worker->job, &view, error) &&
              (view.captured ? load_view(&view, error)
                             : aob_worker_mesh(worker->job, &view.mesh, error) && cast_view(&view, error));
    for (size_t i = 0; ok && i < json_array_size(view.terms); i++)
        ok = trace_with(worker, &view, json_array_get(view.terms, i), error);
    aob_hits_finish(&view.hits);
    aob_tracer_destroy(view.tracer);
    aob_mesh_finish(&view.mesh);
    return ok;
}
