#include "mesh_solids.h"
#include <stdlib.h>
#include "base/memory.h"

enum { BEND_STEPS = 8 };

static struct aob_vec3 any_normal(struct aob_vec3 axis)
{
    struct aob_vec3 helper = fabs(axis.y) < 0.9 ? aob_vec(0, 1, 0) : aob_vec(1, 0, 0);
    return aob_vec_normalize(aob_vec_cross(helper, axis));
}

/* A ring of vertices about `centre`, counter-clockwise seen from where u x v points to. */
static uint32_t add_ring(struct aob_mesh *mesh, struct aob_vec3 centre, struct aob_vec3 u, struct aob_vec3 v,
                         double radius, int segments)
{
    uint32_t first = (uint32_t)mesh->vertex_count;
    for (int i = 0; i < segments; i++) {
        double phi = 2 * M_PI * i / segments;
        struct aob_vec3 out = aob_vec_add(aob_vec_scale(u, cos(phi)), aob_vec_scale(v, sin(phi)));
        aob_mesh_add_vertex(mesh, aob_vec_add(centre, aob_vec_scale(out, radius)));
    }
    return first;
}

/* Joins ring `a` to ring `b` above it. */
static void join_rings(struct aob_mesh *mesh, uint32_t a, uint32_t b, int segments)
{
    for (int i = 0; i < segments; i++) {
        uint32_t here = (uint32_t)i, next = (uint32_t)((i + 1) % segments);
        aob_mesh_add_triangle(mesh, a + here, a + next, b + next);
        aob_mesh_add_triangle(mesh, a + here, b + next, b + here);
    }
}

/* Joins a ring to the point `tip` at its upper side, or (upper false) at its lower one. */
static void join_tip(struct aob_mesh *mesh, uint32_t ring, uint32_t tip, int segments, bool upper)
{
    for (int i = 0; i < segments; i++) {
        uint32_t here = ring + (uint32_t)i, next = ring + (uint32_t)((i + 1) % segments);
        aob_mesh_add_triangle(mesh, upper ? here : next, upper ? next : here, tip);
    }
}

void aob_mesh_add_lathe(struct aob_mesh *mesh, struct aob_vec3 base, struct aob_vec3 axis,
                        const struct aob_turning *profile, size_t count, int segments)
{
    axis = aob_vec_normalize(axis);
    struct aob_vec3 u = any_normal(axis), v = aob_vec_cross(axis, u);
    bool before_on_axis = false;
    uint32_t before = 0;
    for (size_t i = 0; i < count; i++) {
        struct aob_vec3 centre = aob_vec_add(base, aob_vec_scale(axis, profile[i].height));
        bool on_axis = !(profile[i].radius > 0);
        uint32_t here = on_axis ? aob_mesh_add_vertex(mesh, centre)
                                : add_ring(mesh, centre, u, v, profile[i].radius, segments);
        if (i && on_axis)
            join_tip(mesh, before, here, segments, true);
        else if (i && before_on_axis)
            join_tip(mesh, here, before, segments, false);
        else if (i)
            join_rings(mesh, before, here, segments);
        before = here;
        before_on_axis = on_axis;
    }
}

void aob_mesh_add_cylinder(struct aob_mesh *mesh, struct aob_vec3 from, struct aob_vec3 to, double radius,
                           int segments)
{
    struct aob_vec3 axis = aob_vec_sub(to, from);
    double height = aob_vec_length(axis);
    const struct aob_turning profile[] = {{0, 0}, {radius, 0}, {radius, height}, {0, height}};
    aob_mesh_add_lathe(mesh, from, axis, profile, AOB_COUNT(profile), segments);
}

void aob_mesh_add_band(struct aob_mesh *mesh, const struct aob_vec3 *outer, const struct aob_vec3 *inner,
                       size_t count, struct aob_vec3 along, bool closed)
{
    for (size_t i = 0; i + !closed < count; i++) {
        size_t next = (i + 1) % count;
        const struct aob_vec3 low[4] = {outer[i], outer[next], inner[next], inner[i]};
        uint32_t v[8];
        for (int k = 0; k < 4; k++) {
            v[k] = aob_mesh_add_vertex(mesh, low[k]);
            v[4 + k] = aob_mesh_add_vertex(mesh, aob_vec_add(low[k], along));
        }
        static const int faces[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                        {2, 3, 7, 6}, {3, 0, 4, 7}, {1, 2, 6, 5}};
        for (int f = 0; f < 6; f++) {
            if ((f == 4 && (closed || i)) || (f == 5 && (closed || next + 1 < count)))
                continue;
            aob_mesh_add_triangle(mesh, v[faces[f][0]], v[faces[f][1]], v[faces[f][2]]);
            aob_mesh_add_triangle(mesh, v[faces[f][0]], v[faces[f][2]], v[faces[f][3]]);
        }
    }
}

struct sweep {
    struct aob_mesh *mesh;
    struct aob_vec3 u; /* carried along, so that the rings do not twist */
    double radius;
    int segments;
    uint32_t ring;
};

static void sweep_to(struct sweep *sweep, struct aob_vec3 centre, struct aob_vec3 along, bool first)
{
    sweep->u = aob_vec_normalize(aob_vec_sub(sweep->u, aob_vec_scale(along, aob_vec_dot(sweep->u, along))));
    struct aob_vec3 v = aob_vec_cross(along, sweep->u);
    uint32_t ring = add_ring(sweep->mesh, centre, sweep->u, v, sweep->radius, sweep->segments);
    if (!first)
        join_rings(sweep->mesh, sweep->ring, ring, sweep->segments);
    sweep->ring = ring;
}

/* The corner at `point` between directions `in` and `out`, as an arc about the centre that both sides touch. */
static void sweep_bend(struct sweep *sweep, struct aob_vec3 point, struct aob_vec3 in, struct aob_vec3 out,
                       double bend)
{
    struct aob_vec3 side = aob_vec_sub(out, aob_vec_scale(in, aob_vec_dot(in, out)));
    double turn = atan2(aob_vec_length(side), aob_vec_dot(in, out));
    side = aob_vec_normalize(side);
    struct aob_vec3 start = aob_vec_sub(point, aob_vec_scale(in, bend * tan(turn / 2)));
    struct aob_vec3 centre = aob_vec_add(start, aob_vec_scale(side, bend));
    for (int i = 0; i <= BEND_STEPS; i++) {
        double c = cos(turn * i / BEND_STEPS), s = sin(turn * i / BEND_STEPS);
        struct aob_vec3 along = aob_vec_add(aob_vec_scale(in, c), aob_vec_scale(side, s));
        struct aob_vec3 away = aob_vec_sub(aob_vec_scale(in, s), aob_vec_scale(side, c));
        sweep_to(sweep, aob_vec_add(centre, aob_vec_scale(away, bend)), along, false);
    }
}

void aob_mesh_add_pipe(struct aob_mesh *mesh, const struct aob_vec3 *points, size_t count, double radius,
                       double bend, int segments)
{
    struct aob_vec3 along = aob_vec_normalize(aob_vec_sub(points[1], points[0]));
    struct sweep sweep = {.mesh = mesh, .u = any_normal(along), .radius = radius, .segments = segments};
    sweep_to(&sweep, points[0], along, true);
    join_tip(mesh, sweep.ring, aob_mesh_add_vertex(mesh, points[0]), segments, false);
    for (size_t i = 1; i + 1 < count; i++) {
        struct aob_vec3 next = aob_vec_normalize(aob_vec_sub(points[i + 1], points[i]));
        sweep_bend(&sweep, points[i], along, next, bend);
        along = next;
    }
    sweep_to(&sweep, points[count - 1], along, false);
    join_tip(mesh, sweep.ring, aob_mesh_add_vertex(mesh, points[count - 1]), segments, true);
}
