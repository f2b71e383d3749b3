/* What sampling and bookkeeping cost the reference: its rays a second over those of Embree alone on the same
 * rays, computed beforehand, with the same packets and threads. Both are run in turn; the median counts.
 * Prints `name value unit` lines. */
#include <stdio.h>
#include <stdlib.h>
#include "base/clock.h"
#include "base/memory.h"
#include "reference/gather.h"
#include "reference/tracer.h"
#include "scene/scene.h"

enum { WIDTH = 160, HEIGHT = 90, SPP = 512, ROUNDS = 7 };

struct bench {
    struct aob_tracer *tracer;
    struct aob_camera camera;
    struct aob_hits hits;
    double radius;
    size_t *pixels; /* those that are not sky */
    size_t count;
    float *rays; /* of each pixel: its origin, then the directions */
};

static size_t ray_floats(void)
{
    return 3 + 3 * SPP;
}

static void prepare_rays(struct bench *bench)
{
    struct aob_sampler sampler;
    aob_sampler_init(&sampler, SPP / 2, false);
    float *cosine = AOB_NEW_ARRAY(float, sampler.padded);
    bench->pixels = AOB_NEW_ARRAY(size_t, WIDTH * HEIGHT);
    bench->rays = AOB_NEW_ARRAY(float, WIDTH *HEIGHT *ray_floats());
    for (size_t i = 0; i < WIDTH * HEIGHT; i++) {
        if (bench->hits.primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        float *at = bench->rays + bench->count * ray_floats();
        struct aob_surface surface;
        aob_surface_at(bench->tracer, &bench->camera, &bench->hits, i, &surface);
        for (int k = 0; k < 3; k++)
            at[k] = surface.origin[k];
        for (size_t half = 0; half < 2; half++) {
            float *d = at + 3 + half * 3 * (SPP / 2);
            struct aob_directions directions = {d, d + SPP / 2, d + 2 * (SPP / 2), cosine};
            aob_sampler_directions(&sampler, &surface.basis, aob_gather_seed(&bench->hits, i, (int)half, 0),
                                   &directions);
        }
        bench->pixels[bench->count++] = i;
    }
    free(cosine);
    aob_sampler_finish(&sampler);
}

/* Embree alone. Returns million rays a second. */
static double trace_prepared(const struct bench *bench, size_t *hits)
{
    float reach = (float)(bench->radius * bench->tracer->to_unit);
    size_t found = 0;
    int64_t start = aob_clock_wall_ns();
#pragma omp parallel reduction(+ : found)
    {
        unsigned mode = aob_float_mode_begin();
        float distance[SPP / 2];
#pragma omp for schedule(dynamic, 64)
        for (size_t i = 0; i < bench->count; i++) {
            float *at = bench->rays + i * ray_floats();
            for (size_t half = 0; half < 2; half++) {
                float *d = at + 3 + half * 3 * (SPP / 2);
                struct aob_directions directions = {d, d + SPP / 2, d + 2 * (SPP / 2), NULL};
                aob_gather_distances(bench->tracer, at, &directions, SPP / 2, reach, distance, NULL);
                found += distance[0] < reach;
            }
        }
        aob_float_mode_end(mode);
    }
    *hits += found;
    return (double)bench->count * SPP * 1e3 / (double)(aob_clock_wall_ns() - start);
}

static double trace_reference(const struct bench *bench, const struct aob_visibility_term *terms,
                              size_t count)
{
    struct aob_visibility_desc desc = {.terms = terms, .term_count = count, .spp = SPP};
    struct aob_visibility *result = AOB_NEW_ARRAY(struct aob_visibility, count);
    int64_t start = aob_clock_wall_ns();
    struct aob_error error = {""};
    if (!aob_tracer_visibility(bench->tracer, &bench->camera, &bench->hits, &desc, result, &error))
        aob_error_print(&error);
    double rate = (double)bench->count * SPP * 1e3 / (double)(aob_clock_wall_ns() - start);
    for (size_t i = 0; i < count; i++)
        aob_visibility_finish(&result[i]);
    free(result);
    return rate;
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values)
{
    qsort(values, ROUNDS, sizeof *values, by_value);
    return values[ROUNDS / 2];
}

static void measure(const struct bench *bench, const char *name)
{
    struct aob_visibility_term terms[8];
    for (size_t i = 0; i < AOB_COUNT(terms); i++)
        terms[i] = (struct aob_visibility_term){.radius = bench->radius * (double)(i + 1) / AOB_COUNT(terms)};
    double embree[ROUNDS], one[ROUNDS], eight[ROUNDS], ratio[ROUNDS], ratio_eight[ROUNDS];
    size_t hits = 0;
    for (int round = 0; round < ROUNDS; round++) {
        embree[round] = trace_prepared(bench, &hits);
        one[round] = trace_reference(bench, &terms[AOB_COUNT(terms) - 1], 1);
        eight[round] = trace_reference(bench, terms, AOB_COUNT(terms));
        ratio[round] = one[round] / embree[round];
        ratio_eight[round] = eight[round] / embree[round];
    }
    printf("embree_rate_%s %.2f Mray/s\n", name, median(embree));
    printf("reference_rate_%s %.2f Mray/s\n", name, median(one));
    printf("reference_speed_%s %.3f ratio\n", name, median(ratio));
    printf("reference_speed_8_terms_%s %.3f ratio\n", name, median(ratio_eight));
}

static bool load(const struct aob_scene_info *scene, struct aob_mesh *mesh, struct aob_error *error)
{
    *mesh = (struct aob_mesh){0};
    if (!scene->build)
        return aob_mesh_import(mesh, scene->file, error);
    scene->build(mesh);
    return true;
}

static bool bench_scene(const char *name, double radius)
{
    const struct aob_scene_info *scene = aob_scene_find(name);
    struct aob_error error = {""};
    struct aob_mesh mesh;
    struct bench bench = {.camera = scene->views[0].camera, .radius = radius};
    if (!load(scene, &mesh, &error) || !(bench.tracer = aob_tracer_create(&mesh, &error))) {
        aob_error_print(&error);
        return false;
    }
    aob_mesh_finish(&mesh);
    struct aob_projection projection = aob_camera_projection(&bench.camera, WIDTH, HEIGHT, 0);
    aob_tracer_cast(bench.tracer, &bench.camera, &projection, &bench.hits);
    prepare_rays(&bench);
    measure(&bench, name);
    free(bench.pixels);
    free(bench.rays);
    aob_hits_finish(&bench.hits);
    aob_tracer_destroy(bench.tracer);
    return true;
}

int main(void)
{
    bool ok = bench_scene("bunny", 1) && bench_scene("corner", 1);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}
