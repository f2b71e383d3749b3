/* Embree errs by an ulp of the distance to a triangle's corners, so a triangle as long as the scene may seem to lie
 * above a start on its own plane. Such a hit is no occluder, and what lies behind it is one. The triangles are narrow,
 * where this happens most: without the second look 320 of 800,000 rays from those of a quarter's width were stopped. */
#include "shot.h"
#include <string.h>
#include "random.h"
#include "reference/gather.h"

enum { TRIANGLES = 400, POINTS = 32, RAYS = 64 };

/* Two units long and turned at random; the camera looks straight at it. */
struct triangle {
    struct aob_vec3 n, u, v;
    struct aob_tracer *tracer;
    struct aob_camera camera;
    float normal[1][3]; /* view space */
    double to_unit;     /* the tracer's distances are in the longest side of the mesh's box */
};

static struct aob_vec3 any_direction(uint32_t *random)
{
    return aob_vec_normalize(
        aob_vec(random_unit(random) - 0.5, random_unit(random) - 0.5, random_unit(random) - 0.5));
}

/* With a lid above it, if its height is above 0. */
static void init(struct triangle *t, uint32_t *random, double width, double lid)
{
    struct aob_mesh mesh = {0};
    struct aob_error error = {""};
    t->n = any_direction(random);
    t->u = aob_vec_normalize(aob_vec_cross(any_direction(random), t->n));
    t->v = aob_vec_cross(t->n, t->u);
    aob_mesh_add_vertex(&mesh, aob_vec_scale(t->u, -1));
    aob_mesh_add_vertex(&mesh, t->u);
    aob_mesh_add_vertex(&mesh,
                        aob_vec_add(aob_vec_scale(t->u, random_unit(random)), aob_vec_scale(t->v, width)));
    aob_mesh_add_triangle(&mesh, 0, 1, 2);
    if (lid > 0) {
        struct aob_vec3 corner =
            aob_vec_add(aob_vec_scale(t->n, lid), aob_vec_scale(aob_vec_add(t->u, t->v), -1.5));
        aob_mesh_add_quad(&mesh, corner, aob_vec_scale(t->u, 3), aob_vec_scale(t->v, 3));
    }
    t->tracer = aob_tracer_create(&mesh, &error);
    assert_string_equal(error.text, "");
    struct aob_vec3 low, high;
    aob_mesh_bounds(&mesh, &low, &high);
    t->to_unit = 1 / fmax(high.x - low.x, fmax(high.y - low.y, high.z - low.z));
    aob_mesh_finish(&mesh);
    t->camera = (struct aob_camera){.eye = aob_vec_scale(t->n, 5), .fov_deg = 60};
    struct aob_frame_axes axes = aob_camera_axes(&t->camera);
    t->normal[0][0] = (float)aob_vec_dot(t->n, axes.right);
    t->normal[0][1] = (float)aob_vec_dot(t->n, axes.up);
    t->normal[0][2] = (float)aob_vec_dot(t->n, axes.back);
}

/* The start above a point of the triangle, as for a pixel that sees it; false if the numbers lie outside it. */
static bool start_at(struct triangle *t, uint32_t *random, float origin[3])
{
    uint32_t primitive = 0;
    float u = (float)random_unit(random), v = (float)random_unit(random);
    struct aob_hits hits = {
        .width = 1, .height = 1, .primitive = &primitive, .u = &u, .v = &v, .normal = t->normal};
    struct aob_surface surface;
    if (u + v > 1)
        return false;
    aob_surface_at(t->tracer, &t->camera, &hits, 0, &surface);
    memcpy(origin, surface.origin, sizeof surface.origin);
    return true;
}

/* Rays from one start, the flattest of which rise by `least`. */
struct rays {
    float x[RAYS], y[RAYS], z[RAYS], cosine[RAYS], distance[RAYS];
};

static void trace(const struct triangle *t, uint32_t *random, double least, const float origin[3],
                  struct rays *rays)
{
    for (int i = 0; i < RAYS; i++) {
        double turn = 2 * M_PI * random_unit(random), rise = pow(least, random_unit(random));
        struct aob_vec3 flat = aob_vec_add(aob_vec_scale(t->u, cos(turn)), aob_vec_scale(t->v, sin(turn)));
        struct aob_vec3 d = aob_vec_normalize(aob_vec_add(flat, aob_vec_scale(t->n, rise)));
        rays->x[i] = (float)d.x;
        rays->y[i] = (float)d.y;
        rays->z[i] = (float)d.z;
        rays->cosine[i] = (float)aob_vec_dot(d, t->n);
    }
    aob_gather_distances(t->tracer, origin, &(struct aob_directions){rays->x, rays->y, rays->z, rays->cosine},
                         RAYS, 1, rays->distance, NULL);
}

/* Directions rise by 2^-12 at least (sampler.h). */
static void a_triangle_does_not_stop_its_own_rays(void **state)
{
    (void)state;
    uint32_t random = 5;
    size_t starts = 0;
    for (int i = 0; i < TRIANGLES; i++) {
        struct triangle t;
        struct rays rays;
        float origin[3];
        init(&t, &random, 0.25, 0);
        for (int p = 0; p < POINTS; p++) {
            if (!start_at(&t, &random, origin))
                continue;
            starts++;
            trace(&t, &random, 0x1p-12, origin, &rays);
            for (int k = 0; k < RAYS; k++)
                if (rays.distance[k] < 1)
                    fail_msg("triangle %d stops a ray of its own at %g", i, (double)rays.distance[k]);
        }
        aob_tracer_destroy(t.tracer);
    }
    assert_true(starts > TRIANGLES * POINTS / 3);
}

/* Rays that rise by 2^-6 meet the lid before it ends. */
static void what_lies_behind_is_met(void **state)
{
    (void)state;
    const double lid = 0.004;
    uint32_t random = 7;
    for (int i = 0; i < TRIANGLES; i++) {
        struct triangle t;
        struct rays rays;
        float origin[3];
        init(&t, &random, 0.05, lid);
        for (int p = 0; p < POINTS; p++) {
            if (!start_at(&t, &random, origin))
                continue;
            trace(&t, &random, 0x1p-6, origin, &rays);
            for (int k = 0; k < RAYS; k++) {
                double unit = rays.distance[k] * (double)rays.cosine[k], expected = lid * t.to_unit;
                if (!(fabs(unit - expected) < 0.02 * expected))
                    fail_msg("triangle %d: a ray ends %g above it, not at the lid's %g", i, unit, expected);
            }
        }
        aob_tracer_destroy(t.tracer);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_triangle_does_not_stop_its_own_rays),
                                       cmocka_unit_test(what_lies_behind_is_met)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
