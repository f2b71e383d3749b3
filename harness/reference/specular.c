#include "specular.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "gather.h"
#include "bounces.h"
#include "tiles.h"

const char aob_specular_version[] = "1";

static const double least_alpha = 1e-3;

/* As the sampler's, so that rounding turns no direction below its own surface. */
static const double least_cosine = 1 / 4096.0;

struct job {
    struct aob_bounces bounces;
    const struct aob_camera *camera;
    const struct aob_hits *hits;
    struct aob_sampler sampler;
    double roughness; /* below 0: the materials' */
    bool fresnel;
    uint32_t seed;
    struct aob_specular *result;
};

struct scratch {
    struct aob_rays rays;
    float *u, *v, *weight;
    float *edge; /* (1 - h.v)^5 */
};

/* What the lobe of a pixel is made of. Vectors in its frame are along tangent, bitangent and normal. */
struct lobe {
    struct aob_basis basis;
    struct aob_vec3 view, stretched, across, along; /* view in the frame; the others of the stretched frame */
    double alpha, view_root;
};

/* The cosine's share in Smith's function: lambda = (root/cosine - 1) / 2. */
static double smith_root(double cosine, double alpha)
{
    return sqrt(cosine * cosine + alpha * alpha * (1 - cosine * cosine));
}

static double dot(const float axis[3], struct aob_vec3 v)
{
    return aob_vec_dot(aob_vec(axis[0], axis[1], axis[2]), v);
}

static void lobe_init(struct lobe *lobe, const struct aob_surface *surface, double roughness)
{
    const struct aob_basis *b = &surface->basis;
    double alpha = fmax(roughness * roughness, least_alpha);
    struct aob_vec3 view = {dot(b->tangent, surface->back), dot(b->bitangent, surface->back),
                            fmax(dot(b->normal, surface->back), 0)};
    struct aob_vec3 s = aob_vec_normalize(aob_vec(alpha * view.x, alpha * view.y, view.z));
    double level = hypot(s.x, s.y);
    struct aob_vec3 across = level > 1e-12 ? aob_vec(-s.y / level, s.x / level, 0) : aob_vec(1, 0, 0);
    *lobe = (struct lobe){.basis = *b,
                          .view = view,
                          .stretched = s,
                          .across = across,
                          .along = aob_vec_cross(s, across),
                          .alpha = alpha,
                          .view_root = smith_root(view.z, alpha)};
}

/* A half vector in the frame (Heitz 2018, "Sampling the GGX Distribution of Visible Normals", listing 1). */
static struct aob_vec3 half_vector(const struct lobe *lobe, double u, double v)
{
    double r = sqrt(u), a = r * cos(2 * M_PI * v), b = r * sin(2 * M_PI * v), s = (1 + lobe->stretched.z) / 2;
    b = (1 - s) * sqrt(1 - a * a) + s * b;
    double c = sqrt(fmax(1 - a * a - b * b, 0));
    struct aob_vec3 n =
        aob_vec_add(aob_vec_scale(lobe->across, a),
                    aob_vec_add(aob_vec_scale(lobe->along, b), aob_vec_scale(lobe->stretched, c)));
    return aob_vec_normalize(aob_vec(lobe->alpha * n.x, lobe->alpha * n.y, fmax(n.z, 0)));
}

/* G2/G1, in a form that is finite for a view along the surface. */
static double weight_of(const struct lobe *lobe, double cosine)
{
    double root = smith_root(cosine, lobe->alpha);
    return (lobe->view.z + lobe->view_root) * cosine / (lobe->view_root * cosine + root * lobe->view.z);
}

/* Keeps the directions above the surface, at the front of the arrays; returns how many. */
static size_t draw(const struct job *job, const struct lobe *lobe, uint64_t seed,
                   const struct scratch *scratch)
{
    const struct aob_directions *d = &scratch->rays.directions;
    const struct aob_basis *b = &lobe->basis;
    size_t kept = 0;
    aob_sampler_points(&job->sampler, seed, scratch->u, scratch->v);
    for (size_t i = 0; i < job->sampler.count; i++) {
        struct aob_vec3 h = half_vector(lobe, (double)scratch->v[i], (double)scratch->u[i]);
        struct aob_vec3 l = aob_vec_sub(aob_vec_scale(h, 2 * aob_vec_dot(h, lobe->view)), lobe->view);
        if (!(l.z > 0))
            continue;
        double up = fmax(l.z, least_cosine);
        d->x[kept] = (float)(l.x * b->tangent[0] + l.y * b->bitangent[0] + up * b->normal[0]);
        d->y[kept] = (float)(l.x * b->tangent[1] + l.y * b->bitangent[1] + up * b->normal[1]);
        d->z[kept] = (float)(l.x * b->tangent[2] + l.y * b->bitangent[2] + up * b->normal[2]);
        scratch->edge[kept] = (float)pow(fmax(1 - aob_vec_dot(h, lobe->view), 0), 5);
        scratch->weight[kept++] = (float)weight_of(lobe, l.z);
    }
    return kept;
}

struct half {
    double so; /* NAN if no direction is above the surface */
    double rgb[3];
};

/* A direction's weight, times Fresnel's factor, is what it brings of the light on it. */
static void add_radiance(const struct job *job, const struct aob_surface *surface, const double f0[3],
                         uint64_t seed, size_t count, const struct scratch *scratch, double mean[3])
{
    const struct aob_directions *d = &scratch->rays.directions;
    for (size_t i = 0; i < count; i++) {
        double weight = (double)scratch->weight[i] / (double)job->sampler.count;
        struct aob_bounce_path path = {
            {0}, {d->x[i], d->y[i], d->z[i]}, .primitive = scratch->rays.primitive[i]};
        for (int c = 0; c < 3; c++)
            path.share[c] = weight * (f0[c] + (1 - f0[c]) * (double)scratch->edge[i]);
        memcpy(path.origin, surface->origin, sizeof path.origin);
        aob_bounces_follow(&job->bounces, &path, aob_sampler_mix(seed, i), mean);
    }
}

/* What a surface mirrors along its normal. */
static void reflectance(const struct job *job, uint32_t triangle, double f0[3])
{
    const struct aob_material *m = aob_tracer_material(job->bounces.tracer, triangle);
    double metal = (double)m->metalness;
    for (int c = 0; c < 3; c++)
        f0[c] = job->fresnel ? 0.04 + metal * ((double)m->base_colour[c] - 0.04) : 1;
}

static struct half trace_half(const struct job *job, const struct aob_surface *surface,
                              const struct lobe *lobe, const double f0[3], uint64_t seed,
                              const struct scratch *scratch)
{
    size_t count = draw(job, lobe, seed, scratch);
    const float *distance = scratch->rays.distance, *weight = scratch->weight;
    double open = 0, all = 0;
    struct half half = {0, {0, 0, 0}};
    aob_gather_distances(job->bounces.tracer, surface->origin, &scratch->rays.directions, count,
                         job->bounces.reach, scratch->rays.distance, scratch->rays.primitive);
    for (size_t i = 0; i < count; i++) {
        all += (double)weight[i];
        open += distance[i] < job->bounces.reach ? 0 : (double)weight[i];
    }
    half.so = all > 0 ? open / all : (double)NAN;
    if (job->result->rgb)
        add_radiance(job, surface, f0, seed, count, scratch, half.rgb);
    return half;
}

static void store(const struct job *job, size_t out, struct half a, struct half b)
{
    struct aob_specular *result = job->result;
    if (!isnan(a.so) || !isnan(b.so)) {
        double first = isnan(a.so) ? b.so : a.so, second = isnan(b.so) ? a.so : b.so;
        result->so[out] = (float)((first + second) / 2);
        result->se[out] = (float)(fabs(first - second) / 2);
    }
    for (int c = 0; result->rgb && c < 3; c++) {
        result->rgb[out][c] = (float)((a.rgb[c] + b.rgb[c]) / 2);
        result->rgb_se[out][c] = (float)(fabs(a.rgb[c] - b.rgb[c]) / 2);
    }
}

static void do_pixel(const void *context, size_t pixel, size_t out, void *scratch)
{
    const struct job *job = context;
    const struct aob_tracer *tracer = job->bounces.tracer;
    uint32_t triangle = job->hits->primitive[pixel];
    job->result->so[out] = 1;
    if (triangle == AOB_NO_PRIMITIVE)
        return;
    struct aob_surface surface;
    struct lobe lobe;
    struct half half[2];
    double f0[3];
    aob_surface_at(tracer, job->camera, job->hits, pixel, &surface);
    lobe_init(&lobe, &surface,
              job->roughness < 0 ? (double)aob_tracer_material(tracer, triangle)->roughness : job->roughness);
    reflectance(job, triangle, f0);
    for (int h = 0; h < 2; h++)
        half[h] =
            trace_half(job, &surface, &lobe, f0, aob_gather_seed(job->hits, pixel, h, job->seed), scratch);
    store(job, out, half[0], half[1]);
}

static void scratch_init(void *at, const void *context)
{
    struct scratch *scratch = at;
    const struct job *job = context;
    const struct aob_sampler *sampler = &job->sampler;
    aob_rays_init(&scratch->rays, sampler, job->result->rgb);
    scratch->u = aob_alloc(4 * sampler->padded, sizeof *scratch->u);
    scratch->v = scratch->u + sampler->padded;
    scratch->weight = scratch->v + sampler->padded;
    scratch->edge = scratch->weight + sampler->padded;
}

static void scratch_finish(void *at)
{
    struct scratch *scratch = at;
    aob_rays_finish(&scratch->rays);
    free(scratch->u);
}

static bool check_desc(const struct aob_specular_desc *desc, struct aob_error *error)
{
    if (!(desc->radius > 0))
        return aob_fail(error, "specular occlusion: radius %g: must be above 0", desc->radius);
    if (!(desc->roughness <= 1))
        return aob_fail(error, "specular occlusion: roughness %g: must be at most 1", desc->roughness);
    return !desc->radiance || aob_bounces_check(desc->bounces, desc->light, "specular occlusion", error);
}

static void result_init(struct aob_specular *result, const struct aob_tiles *tiles, bool radiance)
{
    size_t pixels = (size_t)tiles->width * (size_t)tiles->height;
    result->so = aob_alloc(pixels, sizeof *result->so);
    result->se = aob_alloc(pixels, sizeof *result->se);
    result->rgb = radiance ? aob_alloc(pixels, sizeof *result->rgb) : NULL;
    result->rgb_se = radiance ? aob_alloc(pixels, sizeof *result->rgb_se) : NULL;
}

bool aob_tracer_specular(const struct aob_tracer *tracer, const struct aob_camera *camera,
                         const struct aob_hits *hits, const struct aob_specular_desc *desc,
                         struct aob_specular *result, struct aob_error *error)
{
    const int part[] = {desc->x0, desc->y0, desc->width, desc->height};
    struct aob_tiles tiles;
    if (!check_desc(desc, error) ||
        !aob_tiles_init(&tiles, hits, part, desc->spp, "specular occlusion", error))
        return false;
    result_init(result, &tiles, desc->radiance);
    struct job job = {
        .bounces = {tracer, desc->light, (float)(desc->radius * tracer->to_unit), desc->bounces},
        .camera = camera,
        .hits = hits,
        .roughness = desc->roughness,
        .fresnel = desc->fresnel,
        .seed = desc->seed,
        .result = result};
    aob_sampler_init(&job.sampler, (size_t)desc->spp / 2, false);
    const struct aob_tiles_work work = {&job, sizeof(struct scratch), scratch_init, scratch_finish, do_pixel};
    aob_tiles_run(&tiles, &work);
    aob_sampler_finish(&job.sampler);
    return true;
}

void aob_specular_finish(struct aob_specular *specular)
{
    free(specular->so);
    free(specular->se);
    free(specular->rgb);
    free(specular->rgb_se);
    *specular = (struct aob_specular){0};
}
