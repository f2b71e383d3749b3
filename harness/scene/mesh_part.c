#include "mesh_part.h"
#include <stdlib.h>
#include "base/memory.h"

void aob_mesh_part_finish(struct aob_mesh_part *part)
{
    free(part->positions);
    free(part->normals);
    free(part->colours);
    free(part->triangles);
    *part = (struct aob_mesh_part){0};
}

/* NAN stays. */
static float clamped(double value)
{
    return (float)(value < 0 ? 0 : value > 1 ? 1 : value);
}

static struct aob_material base_material(const struct aob_mesh_part *part)
{
    struct aob_material m = part->painted ? part->material : aob_material_default;
    for (int c = 0; c < 3; c++)
        m.base_colour[c] = part->colours && !part->painted ? 1 : clamped((double)m.base_colour[c]);
    m.roughness = clamped((double)m.roughness);
    m.metalness = clamped((double)m.metalness);
    return m;
}

/* A number that is clamped makes another material than the file means; NAN is refused later. */
static void note_clamped(const struct aob_material *stated, struct aob_mesh *mesh)
{
    const float numbers[] = {stated->base_colour[0], stated->base_colour[1], stated->base_colour[2],
                             stated->roughness, stated->metalness};
    for (size_t i = 0; i < AOB_COUNT(numbers); i++)
        if (numbers[i] < 0 || numbers[i] > 1) {
            aob_mesh_note(mesh, "a material's base colour, roughness or metalness is not within 0..1: "
                                "such numbers are clamped to that");
            return;
        }
}

static struct aob_material face_material(const struct aob_mesh_part *part, const struct aob_material *base,
                                         const uint32_t corner[3])
{
    struct aob_material m = *base;
    for (int c = 0; c < 3; c++) {
        double sum = 0;
        for (int k = 0; k < 3; k++)
            sum += (double)part->colours[corner[k]][c];
        m.base_colour[c] = clamped((double)m.base_colour[c] * sum / 3);
    }
    return m;
}

/* -0 becomes 0, so that equal places have equal bits. */
static struct aob_vec3 plain_zero(struct aob_vec3 v)
{
    return aob_vec(v.x + 0.0, v.y + 0.0, v.z + 0.0);
}

/* Zero stands for none. */
static struct aob_vec3 unit_or_zero(struct aob_vec3 n)
{
    struct aob_vec3 unit = aob_vec_normalize(n);
    return fabs(aob_vec_length(unit) - 1) < 1e-6 ? plain_zero(unit) : aob_vec(0, 0, 0);
}

/* Before it there may have been parts without normals. */
static void add_normal(struct aob_mesh *mesh, struct aob_vec3 normal)
{
    if (!mesh->normals)
        mesh->normals = AOB_NEW_ARRAY(struct aob_vec3, mesh->vertex_capacity);
    mesh->normals[mesh->vertex_count - 1] = unit_or_zero(normal);
}

static void add_vertices(const struct aob_mesh_part *part, const struct aob_affine *place,
                         struct aob_mesh *mesh)
{
    for (size_t i = 0; i < part->vertex_count; i++) {
        size_t room = mesh->vertex_capacity;
        aob_mesh_add_vertex(mesh, plain_zero(aob_affine_point(place, part->positions[i])));
        if (mesh->normals && mesh->vertex_capacity != room)
            mesh->normals = aob_realloc(mesh->normals, mesh->vertex_capacity, sizeof *mesh->normals);
        if (part->normals)
            add_normal(mesh, aob_affine_normal(place, part->normals[i]));
        else if (mesh->normals)
            mesh->normals[mesh->vertex_count - 1] = aob_vec(0, 0, 0);
    }
}

/* The mesh's last part: its vertices begin at `first`. Those that no triangle names may be anything. */
static bool check_triangle(const struct aob_mesh_part *part, const struct aob_mesh *mesh, size_t first,
                           const uint32_t corner[3], const char *name, struct aob_error *error)
{
    for (int k = 0; k < 3; k++) {
        if (corner[k] >= part->vertex_count)
            return aob_fail(error, "%s: a triangle names vertex %u of %zu: the file is damaged", name,
                            corner[k], part->vertex_count);
        struct aob_vec3 p = mesh->positions[first + corner[k]];
        if (!isfinite((float)p.x) || !isfinite((float)p.y) || !isfinite((float)p.z))
            return aob_fail(
                error,
                "%s: vertex %u is not finite or exceeds a float: the file is damaged or was exported wrongly",
                name, corner[k]);
    }
    return true;
}

bool aob_mesh_part_add(const struct aob_mesh_part *part, const struct aob_affine *place,
                       struct aob_mesh *mesh, const char *name, struct aob_error *error)
{
    uint32_t first = (uint32_t)mesh->vertex_count;
    int turned = aob_affine_determinant(place) < 0;
    const struct aob_material base = base_material(part);
    if (part->vertex_count > UINT32_MAX - mesh->vertex_count)
        return aob_fail(error, "%s: it has more than %u vertices", name, UINT32_MAX);
    if (part->painted)
        note_clamped(&part->material, mesh);
    add_vertices(part, place, mesh);
    aob_mesh_paint(mesh, base);
    for (size_t i = 0; i < part->triangle_count; i++) {
        const uint32_t *t = part->triangles[i];
        if (!check_triangle(part, mesh, first, t, name, error))
            return false;
        if (part->colours)
            aob_mesh_paint(mesh, face_material(part, &base, t));
        aob_mesh_add_triangle(mesh, first + t[0], first + t[1 + turned], first + t[2 - turned]);
    }
    return true;
}
