#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "gather.h"
#include "tiles.h"
#include "tracer.h"
#include "triangle.h"

/* A term in unit space. */
struct term {
    float radius;
    bool uniform, bent;
    const float *falloff;
    size_t falloff_count;
    double scale; /* root of the distance -> place in the table */
};

struct job {
    const struct aob_tracer *tracer;
    const struct aob_hits *hits;
    const struct aob_camera *camera;
    struct aob_sampler sampler;
    struct term *terms;
    size_t term_count;
    float reach;
    bool of_triangle;
    uint32_t seed;
    struct aob_frame_axes axes; /* of view space */
    struct aob_visibility *result;
};

/* One for each thread. */
struct scratch {
    struct aob_rays rays;
    double *half; /* term_count occlusions of the first half */
};

static void scratch_init(void *at, const void *context)
{
    struct scratch *scratch = at;
    const struct job *job = context;
    aob_rays_init(&scratch->rays, &job->sampler, job->of_triangle);
    scratch->half = aob_alloc(job->term_count, sizeof *scratch->half);
}

static void scratch_finish(void *at)
{
    struct scratch *scratch = at;
    aob_rays_finish(&scratch->rays);
    free(scratch->half);
}

__attribute__((target_clones("avx2", "default"))) static size_t count_within(const float *distance,
                                                                             size_t count, float radius)
{
    int32_t within = 0;
#pragma omp simd reduction(+ : within)
    for (size_t i = 0; i < count; i++)
        within += distance[i] < radius;
    return (size_t)within;
}

static double falloff_at(const struct term *term, float distance)
{
    if (!term->falloff)
        return 1;
    double place = sqrt(distance) * term->scale;
    size_t i = (size_t)place;
    if (i + 1 >= term->falloff_count)
        return term->falloff[term->falloff_count - 1];
    double part = place - (double)i;
    return term->falloff[i] * (1 - part) + term->falloff[i + 1] * part;
}

/* The weights are for the mixture's density (c + 1/2) / (2 pi). They are divided by their own mean, so that a closed
 * point is exactly closed. */
static double weighted_occlusion(const struct job *job, const struct term *term,
                                 const struct scratch *scratch)
{
    const float *cosine = scratch->rays.directions.cosine, *distance = scratch->rays.distance;
    double hit = 0, all = 0;
    for (size_t i = 0; i < job->sampler.count; i++) {
        double weight = (term->uniform ? 1 : cosine[i]) / (cosine[i] + 0.5);
        all += weight;
        if (distance[i] < term->radius)
            hit += weight * falloff_at(term, distance[i]);
    }
    return hit / all;
}

static double plain_occlusion(const struct job *job, const struct term *term, const float *distance)
{
    size_t count = job->sampler.count;
    if (!term->falloff)
        return (double)count_within(distance, count, term->radius) / (double)count;
    double hit = 0;
    for (size_t i = 0; i < count; i++)
        if (distance[i] < term->radius)
            hit += falloff_at(term, distance[i]);
    return hit / (double)count;
}

static double occlusion(const struct job *job, const struct term *term, const struct scratch *scratch)
{
    return job->sampler.mixture ? weighted_occlusion(job, term, scratch)
                                : plain_occlusion(job, term, scratch->rays.distance);
}

/* The mean of the open directions in world space, each weighed as the visibility weighs it; a closed direction counts
 * 0. With the mixture's density the weights are divided by their own sum, as in weighted_occlusion. */
static struct aob_vec3 open_direction(const struct job *job, const struct term *term,
                                      const struct scratch *scratch)
{
    const struct aob_directions *d = &scratch->rays.directions;
    struct aob_vec3 sum = {0, 0, 0};
    double all = 0;
    for (size_t i = 0; i < job->sampler.count; i++) {
        double weight = job->sampler.mixture ? (term->uniform ? 1 : d->cosine[i]) / (d->cosine[i] + 0.5) : 1;
        double open =
            scratch->rays.distance[i] < term->radius ? 1 - falloff_at(term, scratch->rays.distance[i]) : 1;
        all += weight;
        sum = aob_vec_add(sum, aob_vec_scale(aob_vec(d->x[i], d->y[i], d->z[i]), weight * open));
    }
    return aob_vec_scale(sum, 1 / all);
}

static void add_bent(const struct job *job, size_t k, size_t out, const struct scratch *scratch)
{
    if (!job->terms[k].bent)
        return;
    struct aob_vec3 half = aob_vec_scale(open_direction(job, &job->terms[k], scratch), 0.5);
    float *bent = job->result[k].bent[out];
    bent[0] += (float)aob_vec_dot(half, job->axes.right);
    bent[1] += (float)aob_vec_dot(half, job->axes.up);
    bent[2] += (float)aob_vec_dot(half, job->axes.back);
}

/* Replaces the distances along the rays. Neighbouring rays often meet the same triangle, so its distance is kept from
 * one ray to the next. */
static void measure_triangles(const struct job *job, const struct aob_surface *surface,
                              const struct scratch *scratch)
{
    const struct aob_tracer *tracer = job->tracer;
    const float *o = surface->origin;
    struct aob_vec3 local = aob_vec_scale(aob_vec(o[0], o[1], o[2]), 1 / tracer->to_unit), corner[3];
    uint32_t last = AOB_NO_PRIMITIVE;
    float distance = INFINITY;
    for (size_t i = 0; i < job->sampler.count; i++) {
        uint32_t primitive = scratch->rays.primitive[i];
        if (primitive == AOB_NO_PRIMITIVE)
            continue;
        if (primitive != last) {
            aob_tracer_corners(tracer, tracer->triangle_of[primitive], corner);
            distance = (float)(aob_triangle_distance(local, corner) * tracer->to_unit);
        }
        last = primitive;
        scratch->rays.distance[i] = distance;
    }
}

static void trace_half(const struct job *job, const struct aob_surface *surface, size_t pixel, int half,
                       const struct scratch *scratch)
{
    uint64_t seed = aob_gather_seed(job->hits, pixel, half, job->seed);
    const struct aob_rays *rays = &scratch->rays;
    aob_sampler_directions(&job->sampler, &surface->basis, seed, &rays->directions);
    aob_gather_distances(job->tracer, surface->origin, &rays->directions, job->sampler.count, job->reach,
                         rays->distance, rays->primitive);
    if (job->of_triangle)
        measure_triangles(job, surface, scratch);
}

static void do_pixel(const void *context, size_t pixel, size_t out, void *at)
{
    const struct job *job = context;
    struct scratch *scratch = at;
    if (job->hits->primitive[pixel] == AOB_NO_PRIMITIVE) {
        for (size_t k = 0; k < job->term_count; k++)
            job->result[k].ao[out] = 1;
        return;
    }
    struct aob_surface surface;
    aob_surface_at(job->tracer, job->camera, job->hits, pixel, &surface);
    trace_half(job, &surface, pixel, 0, scratch);
    for (size_t k = 0; k < job->term_count; k++) {
        scratch->half[k] = occlusion(job, &job->terms[k], scratch);
        add_bent(job, k, out, scratch);
    }
    trace_half(job, &surface, pixel, 1, scratch);
    for (size_t k = 0; k < job->term_count; k++) {
        double a = scratch->half[k], b = occlusion(job, &job->terms[k], scratch);
        job->result[k].ao[out] = (float)(1 - (a + b) / 2);
        job->result[k].se[out] = (float)(fabs(a - b) / 2);
        add_bent(job, k, out, scratch);
    }
}

static bool check_term(const struct aob_visibility_term *term, size_t index, struct aob_error *error)
{
    if (!(term->radius >= 0))
        return aob_fail(error, "visibility: term %zu: radius %g: must be 0 or more", index, term->radius);
    if (!term->falloff)
        return true;
    if (isinf(term->radius))
        return aob_fail(error, "visibility: term %zu: a falloff needs a finite radius", index);
    if (!term->falloff_count)
        return aob_fail(error, "visibility: term %zu: its falloff table is empty", index);
    for (size_t i = 0; i < term->falloff_count; i++)
        if (!isfinite(term->falloff[i]))
            return aob_fail(error, "visibility: term %zu: falloff value %zu is not finite", index, i);
    return true;
}

static bool check_terms(const struct aob_visibility_desc *desc, struct aob_error *error)
{
    for (size_t i = 0; i < desc->term_count; i++)
        if (!check_term(&desc->terms[i], i, error))
            return false;
    for (size_t i = 1; i < desc->term_count; i++)
        if (desc->terms[i].of_triangle != desc->terms[0].of_triangle)
            return aob_fail(error, "visibility: terms 0 and %zu measure distances differently", i);
    return true;
}

static struct term unit_term(const struct aob_visibility_term *from, double to_unit)
{
    struct term term = {.radius = (float)(from->radius * to_unit),
                        .uniform = from->uniform,
                        .bent = from->bent,
                        .falloff = from->falloff,
                        .falloff_count = from->falloff_count};
    if (term.radius > 0 && from->falloff)
        term.scale = (double)(from->falloff_count - 1) / sqrt(term.radius);
    return term;
}

static void job_init(struct job *job, const struct aob_tracer *tracer, const struct aob_camera *camera,
                     const struct aob_tiles *tiles, const struct aob_visibility_desc *desc,
                     struct aob_visibility *result)
{
    bool uniform = false;
    *job = (struct job){.tracer = tracer,
                        .hits = tiles->hits,
                        .camera = camera,
                        .terms = aob_alloc(desc->term_count, sizeof *job->terms),
                        .term_count = desc->term_count,
                        .seed = desc->seed,
                        .axes = aob_camera_axes(camera),
                        .result = result};
    size_t pixels = (size_t)tiles->width * (size_t)tiles->height;
    for (size_t i = 0; i < desc->term_count; i++) {
        job->terms[i] = unit_term(&desc->terms[i], tracer->to_unit);
        job->of_triangle = desc->terms[i].of_triangle;
        job->reach = job->of_triangle ? INFINITY : fmaxf(job->reach, job->terms[i].radius);
        uniform |= desc->terms[i].uniform;
        result[i].ao = aob_alloc(pixels, sizeof *result[i].ao);
        result[i].se = aob_alloc(pixels, sizeof *result[i].se);
        result[i].bent = desc->terms[i].bent ? aob_alloc(pixels, sizeof *result[i].bent) : NULL;
    }
    aob_sampler_init(&job->sampler, (size_t)desc->spp / 2, uniform);
}

bool aob_tracer_visibility(const struct aob_tracer *tracer, const struct aob_camera *camera,
                           const struct aob_hits *hits, const struct aob_visibility_desc *desc,
                           struct aob_visibility *result, struct aob_error *error)
{
    const int part[] = {desc->x0, desc->y0, desc->width, desc->height};
    struct aob_tiles tiles;
    if (!aob_tiles_init(&tiles, hits, part, desc->spp, "visibility", error) || !check_terms(desc, error))
        return false;
    struct job job;
    job_init(&job, tracer, camera, &tiles, desc, result);
    const struct aob_tiles_work work = {&job, sizeof(struct scratch), scratch_init, scratch_finish, do_pixel};
    aob_tiles_run(&tiles, &work);
    free(job.terms);
    aob_sampler_finish(&job.sampler);
    return true;
}

void aob_visibility_finish(struct aob_visibility *visibility)
{
    free(visibility->ao);
    free(visibility->se);
    free(visibility->bent);
    *visibility = (struct aob_visibility){0};
}
