/* The screen-space bound by a second method: small steps along a ray, each compared with the depth buffer. */
#include "bound_shot.h"
#include "reference/gather.h"

struct walk {
    const struct shot *shot;
    struct aob_frame_axes axes;
    double radius, thickness;
};

static struct aob_vec3 view_at(const struct walk *walk, double qx, double qy, double depth)
{
    const struct aob_projection *p = &walk->shot->projection;
    double s = p->perspective ? depth : 1;
    return aob_vec((qx - p->cx) * p->sx * s, -(qy - p->cy) * p->sy * s, -depth);
}

static double pixel_width(const struct walk *walk, double depth)
{
    const struct aob_projection *p = &walk->shot->projection;
    return p->sx * (p->perspective ? depth : 1);
}

struct sample {
    struct aob_vec3 point, normal; /* view space */
    double depth;                  /* 0: sky */
};

static struct sample sample_at(const struct walk *walk, int x, int y)
{
    const struct aob_hits *hits = &walk->shot->hits;
    size_t i = (size_t)y * (size_t)hits->width + (size_t)x;
    const float *n = hits->normal[i];
    return (struct sample){view_at(walk, x + 0.5, y + 0.5, hits->depth[i]), aob_vec(n[0], n[1], n[2]),
                           hits->depth[i]};
}

static bool explains(const struct walk *walk, const struct sample *a, const struct sample *b)
{
    double off = fabs(aob_vec_dot(a->normal, aob_vec_sub(b->point, a->point)));
    return a->depth > 0 && b->depth > 0 && off <= 2 * pixel_width(walk, fmin(a->depth, b->depth));
}

/* Where the view ray through (qx, qy) meets a plane. */
static double meet(const struct walk *walk, double qx, double qy, struct aob_vec3 point,
                   struct aob_vec3 normal)
{
    struct aob_vec3 near = view_at(walk, qx, qy, 1), far = view_at(walk, qx, qy, 2);
    double a = aob_vec_dot(normal, aob_vec_sub(near, point)),
           b = aob_vec_dot(normal, aob_vec_sub(far, point));
    return 1 + a / (a - b);
}

/* s: top left, top right, bottom left, bottom right. Both ways to fold the four points; the farther fold. */
static double folded_depth(const struct walk *walk, double qx, double qy, double fx, double fy,
                           const struct sample s[4])
{
    const struct aob_projection *p = &walk->shot->projection;
    double w[4];
    for (int k = 0; k < 4; k++)
        w[k] = p->perspective ? -1 / s[k].depth : s[k].depth; /* grows with depth, linear on planes */
    int third = fx > fy ? 1 : 2;
    if (w[1] + w[2] > w[0] + w[3]) {
        third = fx + fy < 1 ? 0 : 3;
        return meet(
            walk, qx, qy, s[1].point,
            aob_vec_cross(aob_vec_sub(s[2].point, s[1].point), aob_vec_sub(s[third].point, s[1].point)));
    }
    return meet(walk, qx, qy, s[0].point,
                aob_vec_cross(aob_vec_sub(s[3].point, s[0].point), aob_vec_sub(s[third].point, s[0].point)));
}

static double bounded(double depth, double low, double high)
{
    return depth > 0 ? fmin(fmax(depth, low), high) : high;
}

/* Half-way from `own` to `other`: shared if they are joined. */
static double side_depth(const struct walk *walk, double qx, double qy, const struct sample *own,
                         const struct sample *other)
{
    double z = own->depth;
    if (explains(walk, own, other) && explains(walk, other, own))
        return meet(
            walk, qx, qy, own->point,
            aob_vec_cross(aob_vec_sub(other->point, own->point), aob_vec_cross(own->point, other->point)));
    double plane = meet(walk, qx, qy, own->point, own->normal);
    return other->depth > 0 ? bounded(plane, fmin(z, other->depth), fmax(z, other->depth))
                            : bounded(plane, z / 2, 2 * z);
}

/* Of the pixels that are joined to `own`, directly or round the cell: the mean of what their planes say. */
static double middle_depth(const struct walk *walk, double qx, double qy, const struct sample s[4], int own)
{
    static const int ring[4] = {0, 1, 3, 2};
    double low = INFINITY, high = 0, sky = 1, sum = 0, count = 0;
    bool member[4] = {false};
    for (int k = 0; k < 4; k++) {
        sky = s[k].depth > 0 ? sky : 2;
        low = s[k].depth > 0 ? fmin(low, s[k].depth) : low;
        high = fmax(high, s[k].depth);
    }
    member[own] = true;
    for (int k = 0; k < 12; k++) {
        int a = ring[k % 4], b = ring[(k + 1) % 4];
        if (explains(walk, &s[a], &s[b]) && explains(walk, &s[b], &s[a]))
            member[a] = member[b] = member[a] || member[b];
    }
    for (int k = 0; k < 4; k++)
        if (member[k]) {
            sum += bounded(meet(walk, qx, qy, s[k].point, s[k].normal), low / sky, high * sky);
            count++;
        }
    return sum / count;
}

/* In a torn cell: the quarter of the nearest pixel. */
static double quarter_depth(const struct walk *walk, double qx, double qy, double fx, double fy,
                            const struct sample s[4])
{
    int right = fx > 0.5, down = fy > 0.5, own = right + 2 * down;
    if (!(s[own].depth > 0))
        return INFINITY;
    double x0 = qx - fx, y0 = qy - fy, cx = x0 + 0.5, cy = y0 + 0.5;
    bool along = fabs(fx - right) > fabs(fy - down);
    double sx = along ? cx : x0 + right, sy = along ? y0 + down : cy;
    const struct sample *other = &s[along ? own ^ 1 : own ^ 2];
    struct aob_vec3 side = view_at(walk, sx, sy, side_depth(walk, sx, sy, &s[own], other));
    struct aob_vec3 middle = view_at(walk, cx, cy, middle_depth(walk, cx, cy, s, own));
    return meet(walk, qx, qy, s[own].point,
                aob_vec_cross(aob_vec_sub(side, s[own].point), aob_vec_sub(middle, s[own].point)));
}

/* Depth of the surface at an image position, infinite where nothing is; whether it is whole there. */
static double surface_depth(const struct walk *walk, double qx, double qy, bool *whole)
{
    int x = (int)floor(qx - 0.5), y = (int)floor(qy - 0.5);
    *whole = false;
    if (x < 0 || y < 0 || x + 1 >= walk->shot->hits.width || y + 1 >= walk->shot->hits.height)
        return INFINITY;
    const struct sample s[4] = {sample_at(walk, x, y), sample_at(walk, x + 1, y), sample_at(walk, x, y + 1),
                                sample_at(walk, x + 1, y + 1)};
    static const int sides[4][2] = {{0, 1}, {1, 3}, {3, 2}, {2, 0}};
    *whole = true;
    for (int k = 0; k < 4; k++) {
        const struct sample *a = &s[sides[k][0]], *b = &s[sides[k][1]];
        *whole &= explains(walk, a, b) && explains(walk, b, a);
    }
    double fx = qx - 0.5 - x, fy = qy - 0.5 - y;
    return *whole ? folded_depth(walk, qx, qy, fx, fy, s) : quarter_depth(walk, qx, qy, fx, fy, s);
}

/* Sixteen steps a pixel, so a step errs by a sixteenth of one at most. */
static void walk_ray(const struct walk *walk, struct aob_vec3 from, struct aob_vec3 direction,
                     bool hit[KINDS])
{
    const struct aob_projection *p = &walk->shot->projection;
    double width = pixel_width(walk, -from.z), before = 0, scale = p->perspective ? -from.z : 1;
    bool was_whole = true;
    from = view_at(walk, p->cx + from.x / (p->sx * scale), p->cy - from.y / (p->sy * scale),
                   -from.z - 1e-4 * width); /* towards the camera, beyond rounding */
    for (double t = 0; t < walk->radius; t += width / 16) {
        struct aob_vec3 at = aob_vec_add(from, aob_vec_scale(direction, t));
        double s = p->perspective ? -at.z : 1;
        bool whole;
        if (at.z >= 0)
            return;
        double surface = surface_depth(walk, p->cx + at.x / (p->sx * s), p->cy - at.y / (p->sy * s), &whole);
        double behind = -at.z - surface;
        hit[INFINITE] |= behind > 0;
        hit[SLAB] |= behind > 0 && behind < walk->thickness;
        hit[THIN] |= whole && was_whole && (behind > 0) != (before > 0);
        before = behind;
        was_whole = whole;
    }
}

static void walk_pixel(const struct walk *walk, size_t pixel, int spp, const struct aob_sampler *sampler,
                       const struct aob_directions *d, double open[KINDS])
{
    const struct shot *shot = walk->shot;
    int width = shot->hits.width;
    struct sample start = sample_at(walk, (int)pixel % width, (int)pixel / width);
    struct aob_surface surface;
    aob_surface_at(shot->tracer, &shot->camera, &shot->hits, pixel, &surface);
    for (int half = 0; half < 2; half++) {
        aob_sampler_directions(sampler, &surface.basis, aob_gather_seed(&shot->hits, pixel, half, 7), d);
        for (int i = 0; i < spp / 2; i++) {
            struct aob_vec3 world = aob_vec(d->x[i], d->y[i], d->z[i]);
            bool hit[KINDS] = {false};
            walk_ray(walk, start.point,
                     aob_vec(aob_vec_dot(world, walk->axes.right), aob_vec_dot(world, walk->axes.up),
                             aob_vec_dot(world, walk->axes.back)),
                     hit);
            for (int k = 0; k < KINDS; k++)
                open[k] += (double)!hit[k] / spp;
        }
    }
}

static void check_walk(const char *name, struct aob_camera camera, double radius)
{
    enum { SPP = 64 };
    struct shot shot;
    scene_shot(&shot, name, camera, 64, 36);
    struct walk walk = {&shot, aob_camera_axes(&camera), radius, radius / 4};
    struct aob_visibility bound[KINDS];
    bound_kinds(&shot, walk.thickness, &(struct aob_visibility_term){.radius = radius}, SPP, bound);
    struct aob_sampler sampler;
    aob_sampler_init(&sampler, SPP / 2, false);
    float block[4][SPP];
    struct aob_directions directions = {block[0], block[1], block[2], block[3]};
    double square[KINDS] = {0}, mean[KINDS] = {0}, n = 0;
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        double open[KINDS] = {0};
        if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        walk_pixel(&walk, i, SPP, &sampler, &directions, open);
        for (int k = 0; k < KINDS; k++) {
            square[k] += pow(open[k] - bound[k].ao[i], 2);
            mean[k] += open[k];
        }
        n++;
    }
    for (int k = 0; k < KINDS; k++)
        print_message("           %-8s %-8s mean %.4f, walk and mesh differ by %.4f RMSE\n", name,
                      kind_names[k], mean[k] / n, sqrt(square[k] / n));
    for (int k = 0; k < KINDS; k++)
        assert_true(sqrt(square[k] / n) <= 0.01 && mean[k] / n < 0.999);
    aob_sampler_finish(&sampler);
    finish_kinds(bound);
    finish_shot(&shot);
}

static void the_walk_agrees(void **state)
{
    (void)state;
    check_walk("corner", aob_scene_find("corner")->views[0].camera, 1);
    check_walk("cornell", aob_scene_view(aob_scene_find("cornell"), "blocks")->camera, 0.5);
    check_walk("spheres", aob_scene_view(aob_scene_find("spheres"), "close")->camera, 0.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_walk_agrees)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
