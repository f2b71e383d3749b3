#include "flicker.h"
#include <math.h>

static const double LEAST_WEIGHT = 1e-3, FACING = 0.906; /* of a texel; cosine of 25 degrees */

/* Where a point was in the frame before: pixels of the view, with their weights. */
struct place {
    size_t pixels[4];
    double weights[4];
    int count;
};

/* A point of the frame before in its view space. */
struct point {
    struct aob_vec3 position, normal;
    double x, y, width; /* in the image; what a pixel covers there */
};

static struct aob_vec3 unproject(const struct aob_projection *p, double x, double y, double depth)
{
    double s = p->perspective ? depth : 1;
    return aob_vec((x - p->cx) * p->sx * s, -(y - p->cy) * p->sy * s, -depth);
}

static struct aob_vec3 normal_at(const struct aob_gbuffer *gbuffer, size_t i)
{
    const float *n = &gbuffer->normal[4 * i];
    return aob_vec((double)n[0], (double)n[1], (double)n[2]);
}

static bool is_sky(const struct aob_gbuffer *gbuffer, size_t i)
{
    return !(gbuffer->depth[i] < 0.5f * AOB_GBUFFER_SKY);
}

/* False: it was behind the camera. */
static bool find_point(const struct aob_flicker_desc *desc, int x, int y, struct point *point)
{
    const struct aob_gbuffer *now = desc->now.gbuffer;
    const struct aob_projection *p = &now->projection;
    size_t i = (size_t)y * (size_t)p->width + (size_t)x;
    const float still[3] = {0, 0, now->depth[i]}, *v = now->velocity ? &now->velocity[3 * i] : still;
    struct aob_vec3 n = normal_at(now, i);
    if (!(v[2] < 0.5f * AOB_NO_VELOCITY))
        return false;
    *point = (struct point){.x = x + 0.5 - (double)v[0], .y = y + 0.5 - (double)v[1]};
    point->position = unproject(p, point->x, point->y, (double)v[2]);
    point->normal = aob_vec(aob_vec_dot(aob_affine_row(&desc->then, 0), n),
                            aob_vec_dot(aob_affine_row(&desc->then, 1), n),
                            aob_vec_dot(aob_affine_row(&desc->then, 2), n));
    point->width = p->sy * (p->perspective ? (double)v[2] : 1);
    return true;
}

static bool same_surface(const struct aob_gbuffer *before, size_t i, int x, int y, const struct point *point)
{
    if (is_sky(before, i))
        return false;
    struct aob_vec3 n = normal_at(before, i);
    struct aob_vec3 shown = unproject(&before->projection, x + 0.5, y + 0.5, (double)before->depth[i]);
    return aob_vec_dot(n, point->normal) >= FACING &&
           fabs(aob_vec_dot(n, aob_vec_sub(point->position, shown))) <= 0.5 * point->width;
}

/* The whole part, and the share of the next pixel; a share that is hardly there is none. */
static int split(double at, double *share)
{
    double whole = floor(at);
    *share = at - whole;
    if (*share > 1 - LEAST_WEIGHT)
        whole++;
    if (*share < LEAST_WEIGHT || *share > 1 - LEAST_WEIGHT)
        *share = 0;
    return (int)whole;
}

static bool find_place(const struct aob_gbuffer *before, const struct point *point, struct place *place)
{
    const struct aob_projection *p = &before->projection;
    int guard = before->guard, width = p->width - 2 * guard, height = p->height - 2 * guard;
    double across, down;
    *place = (struct place){.count = 0};
    if (!(point->x > 0 && point->y > 0 && point->x < p->width && point->y < p->height))
        return false;
    int x0 = split(point->x - 0.5, &across), y0 = split(point->y - 0.5, &down);
    for (int k = 0; k < 4; k++) {
        int x = x0 + (k & 1), y = y0 + (k >> 1);
        double weight = (k & 1 ? across : 1 - across) * (k >> 1 ? down : 1 - down);
        if (!(weight > 0))
            continue;
        if (x < guard || y < guard || x >= guard + width || y >= guard + height ||
            !same_surface(before, (size_t)y * (size_t)p->width + (size_t)x, x, y, point))
            return false;
        place->pixels[place->count] = (size_t)(y - guard) * (size_t)width + (size_t)(x - guard);
        place->weights[place->count++] = weight;
    }
    return true;
}

static void add_point(struct aob_flicker *sum, const struct aob_flicker_desc *desc, size_t pixel,
                      const struct place *place)
{
    const struct aob_flicker_frame *now = &desc->now, *before = &desc->before;
    double truth = (double)now->truth[pixel], error = (double)now->image[pixel] - truth, noise = 0;
    if (now->se)
        noise = (double)now->se[pixel] * (double)now->se[pixel];
    for (int k = 0; k < place->count; k++) {
        size_t q = place->pixels[k];
        double weight = place->weights[k], then = (double)before->truth[q];
        truth -= weight * then;
        error -= weight * ((double)before->image[q] - then);
        if (before->se)
            noise += weight * weight * (double)before->se[q] * (double)before->se[q];
    }
    sum->change += error * error;
    sum->truth_change += truth * truth;
    sum->noise += desc->same_noise ? 0 : noise;
    sum->compared++;
}

void aob_flicker_add(struct aob_flicker *sum, const struct aob_flicker_desc *desc)
{
    const struct aob_gbuffer *now = desc->now.gbuffer;
    int guard = now->guard, width = now->projection.width, height = now->projection.height;
    size_t pixel = 0;
    for (int y = guard; y < height - guard; y++)
        for (int x = guard; x < width - guard; x++, pixel++) {
            struct point point;
            struct place place;
            if (is_sky(now, (size_t)y * (size_t)width + (size_t)x))
                continue;
            sum->surfaces++;
            if (find_point(desc, x, y, &point) && find_place(desc->before.gbuffer, &point, &place))
                add_point(sum, desc, pixel, &place);
        }
}

static double less_noise(const struct aob_flicker *sum, double squares)
{
    return sum->compared ? sqrt(fmax(0, squares - sum->noise) / (double)sum->compared) : NAN;
}

double aob_flicker_value(const struct aob_flicker *sum)
{
    return less_noise(sum, sum->change);
}

double aob_flicker_truth_change(const struct aob_flicker *sum)
{
    return less_noise(sum, sum->truth_change);
}

double aob_flicker_compared(const struct aob_flicker *sum)
{
    return sum->surfaces ? (double)sum->compared / (double)sum->surfaces : NAN;
}
