#include "incident.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "gather.h"
#include "bounces.h"
#include "tiles.h"

const char aob_incident_version[] = "1";

struct job {
    struct aob_bounces bounces;
    const struct aob_camera *camera;
    const struct aob_hits *hits;
    struct aob_sampler sampler;
    uint32_t seed;
    struct aob_incident *result;
};

static void add_open(struct aob_light_moments *open, double x, double y, double z)
{
    open->one++;
    open->x += x;
    open->y += y;
    open->z += z;
    open->xy += x * y;
    open->yz += y * z;
    open->xz += x * z;
    open->xx += x * x;
    open->yy += y * y;
    open->zz += z * z;
}

/* Radiance is a polynomial of the direction, so the moments of many directions give its sum. One call for each
 * direction took as long as tracing it. */
static void add_moments(const struct job *job, const struct aob_light_moments *open, double sum[3])
{
    double basis[9];
    aob_light_of_moments(open, basis);
    for (int c = 0; c < 3; c++) {
        if (!job->bounces.light)
            sum[c] += open->one;
        for (int i = 0; job->bounces.light && i < 9; i++)
            sum[c] += basis[i] * job->bounces.light->sh[i][c];
    }
}

static void trace_half(const struct job *job, const struct aob_surface *surface, size_t pixel, int half,
                       const struct aob_rays *rays, double mean[3])
{
    const struct aob_directions *d = &rays->directions;
    uint64_t seed = aob_gather_seed(job->hits, pixel, half, job->seed);
    struct aob_light_moments open = {0};
    double sum[3] = {0, 0, 0};
    aob_sampler_directions(&job->sampler, &surface->basis, seed, d);
    aob_gather_distances(job->bounces.tracer, surface->origin, d, job->sampler.count, job->bounces.reach,
                         rays->distance, rays->primitive);
    for (size_t i = 0; i < job->sampler.count; i++) {
        struct aob_bounce_path path = {
            {0}, {d->x[i], d->y[i], d->z[i]}, .primitive = rays->primitive[i], .share = {1, 1, 1}};
        memcpy(path.origin, surface->origin, sizeof path.origin);
        if (path.primitive == AOB_NO_PRIMITIVE)
            add_open(&open, d->x[i], d->y[i], d->z[i]);
        else
            aob_bounces_follow(&job->bounces, &path, aob_sampler_mix(seed, i), sum);
    }
    add_moments(job, &open, sum);
    for (int c = 0; c < 3; c++)
        mean[c] = sum[c] / (double)job->sampler.count;
}

static void do_pixel(const void *context, size_t pixel, size_t out, void *scratch)
{
    const struct job *job = context;
    if (job->hits->primitive[pixel] == AOB_NO_PRIMITIVE)
        return;
    struct aob_surface surface;
    double half[2][3];
    aob_surface_at(job->bounces.tracer, job->camera, job->hits, pixel, &surface);
    for (int h = 0; h < 2; h++)
        trace_half(job, &surface, pixel, h, scratch, half[h]);
    for (int c = 0; c < 3; c++) {
        job->result->rgb[out][c] = (float)((half[0][c] + half[1][c]) / 2);
        job->result->se[out][c] = (float)(fabs(half[0][c] - half[1][c]) / 2);
    }
}

static void scratch_init(void *scratch, const void *job)
{
    aob_rays_init(scratch, &((const struct job *)job)->sampler, true);
}

static void scratch_finish(void *scratch)
{
    aob_rays_finish(scratch);
}

bool aob_tracer_incident(const struct aob_tracer *tracer, const struct aob_camera *camera,
                         const struct aob_hits *hits, const struct aob_incident_desc *desc,
                         struct aob_incident *result, struct aob_error *error)
{
    const int part[] = {desc->x0, desc->y0, desc->width, desc->height};
    struct aob_tiles tiles;
    if (!(desc->radius > 0))
        return aob_fail(error, "incident light: radius %g: must be above 0", desc->radius);
    if (!aob_bounces_check(desc->bounces, desc->light, "incident light", error) ||
        !aob_tiles_init(&tiles, hits, part, desc->spp, "incident light", error))
        return false;
    size_t pixels = (size_t)tiles.width * (size_t)tiles.height;
    result->rgb = aob_alloc(pixels, sizeof *result->rgb);
    result->se = aob_alloc(pixels, sizeof *result->se);
    struct job job = {
        .bounces = {tracer, desc->light, (float)(desc->radius * tracer->to_unit), desc->bounces},
        .camera = camera,
        .hits = hits,
        .seed = desc->seed,
        .result = result};
    aob_sampler_init(&job.sampler, (size_t)desc->spp / 2, false);
    const struct aob_tiles_work work = {&job, sizeof(struct aob_rays), scratch_init, scratch_finish,
                                        do_pixel};
    aob_tiles_run(&tiles, &work);
    aob_sampler_finish(&job.sampler);
    return true;
}

void aob_incident_finish(struct aob_incident *incident)
{
    free(incident->rgb);
    free(incident->se);
    *incident = (struct aob_incident){0};
}
