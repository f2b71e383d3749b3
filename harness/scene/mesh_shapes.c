#include "mesh.h"
#include "base/memory.h"

uint32_t aob_mesh_add_vertex(struct aob_mesh *mesh, struct aob_vec3 position)
{
    *AOB_PUSH(mesh->positions, mesh->vertex_count, mesh->vertex_capacity) = position;
    return (uint32_t)(mesh->vertex_count - 1);
}

void aob_mesh_add_triangle(struct aob_mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
    if (mesh->material_of) {
        mesh->material_of = aob_grow(mesh->material_of, mesh->triangle_count, &mesh->material_of_capacity,
                                     sizeof *mesh->material_of);
        mesh->material_of[mesh->triangle_count] = mesh->material;
    }
    uint32_t *triangle = *AOB_PUSH(mesh->triangles, mesh->triangle_count, mesh->triangle_capacity);
    triangle[0] = a;
    triangle[1] = b;
    triangle[2] = c;
}

void aob_mesh_add_quad(struct aob_mesh *mesh, struct aob_vec3 corner, struct aob_vec3 edge_u,
                       struct aob_vec3 edge_v)
{
    uint32_t first = aob_mesh_add_vertex(mesh, corner);
    aob_mesh_add_vertex(mesh, aob_vec_add(corner, edge_u));
    aob_mesh_add_vertex(mesh, aob_vec_add(aob_vec_add(corner, edge_u), edge_v));
    aob_mesh_add_vertex(mesh, aob_vec_add(corner, edge_v));
    aob_mesh_add_triangle(mesh, first, first + 1, first + 2);
    aob_mesh_add_triangle(mesh, first, first + 2, first + 3);
}

static struct aob_vec3 turned(struct aob_vec3 v, double cosine, double sine)
{
    return aob_vec(cosine * v.x + sine * v.z, v.y, cosine * v.z - sine * v.x);
}

void aob_mesh_add_box(struct aob_mesh *mesh, struct aob_vec3 low, struct aob_vec3 high, double turn_y_deg)
{
    double cosine = cos(turn_y_deg * (M_PI / 180)), sine = sin(turn_y_deg * (M_PI / 180));
    struct aob_vec3 centre = aob_vec_scale(aob_vec_add(low, high), 0.5);
    struct aob_vec3 half = aob_vec_scale(aob_vec_sub(high, low), 0.5);
    struct aob_vec3 axes[3] = {turned(aob_vec(half.x, 0, 0), cosine, sine), aob_vec(0, half.y, 0),
                               turned(aob_vec(0, 0, half.z), cosine, sine)};
    for (int face = 0; face < 6; face++) {
        struct aob_vec3 out = aob_vec_scale(axes[face / 2], face % 2 ? -1 : 1);
        struct aob_vec3 u = axes[(face / 2 + 1) % 3];
        struct aob_vec3 v = aob_vec_scale(axes[(face / 2 + 2) % 3], face % 2 ? -1 : 1);
        struct aob_vec3 corner = aob_vec_sub(aob_vec_sub(aob_vec_add(centre, out), u), v);
        aob_mesh_add_quad(mesh, corner, aob_vec_scale(u, 2), aob_vec_scale(v, 2));
    }
}

/* Returns the vertex of a ring (0 is the top pole) and segment. Each pole is one vertex. */
static uint32_t sphere_vertex(uint32_t first, int ring, int segment, int rings, int segments)
{
    if (ring == 0)
        return first;
    if (ring == rings)
        return first + 1;
    return first + 2 + (uint32_t)(ring - 1) * (uint32_t)segments + (uint32_t)(segment % segments);
}

static void sphere_face(struct aob_mesh *mesh, uint32_t first, int ring, int segment, int rings, int segments)
{
    uint32_t a = sphere_vertex(first, ring, segment, rings, segments);
    uint32_t b = sphere_vertex(first, ring + 1, segment, rings, segments);
    uint32_t c = sphere_vertex(first, ring + 1, segment + 1, rings, segments);
    uint32_t d = sphere_vertex(first, ring, segment + 1, rings, segments);
    if (b != c)
        aob_mesh_add_triangle(mesh, a, b, c);
    if (a != d)
        aob_mesh_add_triangle(mesh, a, c, d);
}

void aob_mesh_add_sphere(struct aob_mesh *mesh, struct aob_vec3 centre, double radius, int segments)
{
    int rings = segments / 2 > 2 ? segments / 2 : 2;
    uint32_t first = aob_mesh_add_vertex(mesh, aob_vec_add(centre, aob_vec(0, radius, 0)));
    aob_mesh_add_vertex(mesh, aob_vec_add(centre, aob_vec(0, -radius, 0)));
    for (int ring = 1; ring < rings; ring++)
        for (int segment = 0; segment < segments; segment++) {
            double theta = M_PI * ring / rings, phi = 2 * M_PI * segment / segments;
            struct aob_vec3 out = aob_vec(sin(theta) * sin(phi), cos(theta), sin(theta) * cos(phi));
            aob_mesh_add_vertex(mesh, aob_vec_add(centre, aob_vec_scale(out, radius)));
        }
    for (int ring = 0; ring < rings; ring++)
        for (int segment = 0; segment < segments; segment++)
            sphere_face(mesh, first, ring, segment, rings, segments);
}

void aob_mesh_add_disc(struct aob_mesh *mesh, struct aob_vec3 centre, struct aob_vec3 normal, double radius,
                       int segments)
{
    normal = aob_vec_normalize(normal);
    struct aob_vec3 helper = fabs(normal.y) < 0.9 ? aob_vec(0, 1, 0) : aob_vec(1, 0, 0);
    struct aob_vec3 u = aob_vec_normalize(aob_vec_cross(helper, normal));
    struct aob_vec3 v = aob_vec_cross(normal, u);
    uint32_t middle = aob_mesh_add_vertex(mesh, centre);
    for (int i = 0; i < segments; i++) {
        double phi = 2 * M_PI * i / segments;
        struct aob_vec3 out = aob_vec_add(aob_vec_scale(u, cos(phi)), aob_vec_scale(v, sin(phi)));
        aob_mesh_add_vertex(mesh, aob_vec_add(centre, aob_vec_scale(out, radius)));
    }
    for (int i = 0; i < segments; i++)
        aob_mesh_add_triangle(mesh, middle, middle + 1 + (uint32_t)i,
                              middle + 1 + (uint32_t)((i + 1) % segments));
}
