#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "mesh_part.h"
#include "mesh_place.h"

static const double least_cosine = 0.5; /* of 60 degrees */

static bool lacks_normal(const struct aob_mesh *mesh, uint32_t vertex)
{
    struct aob_vec3 n = mesh->normals[vertex];
    return n.x == 0 && n.y == 0 && n.z == 0;
}

static void drop_degenerate(struct aob_mesh *mesh, const uint32_t *place)
{
    size_t kept = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *t = mesh->triangles[i], a = place[t[0]], b = place[t[1]], c = place[t[2]];
        if (a == b || b == c || c == a)
            continue;
        memmove(mesh->triangles[kept], t, sizeof mesh->triangles[0]);
        if (mesh->material_of)
            mesh->material_of[kept] = mesh->material_of[i];
        kept++;
    }
    mesh->triangle_count = kept;
}

/* Sides are made units first, since the product of two tiny ones may be zero. */
static struct aob_vec3 face_normal(const struct aob_mesh *mesh, size_t triangle)
{
    const uint32_t *t = mesh->triangles[triangle];
    struct aob_vec3 a = mesh->positions[t[0]], b = mesh->positions[t[1]], c = mesh->positions[t[2]];
    return aob_vec_normalize(
        aob_vec_cross(aob_vec_normalize(aob_vec_sub(b, a)), aob_vec_normalize(aob_vec_sub(c, a))));
}

/* The corners that lack a normal, by place: corner[at[p]] to corner[at[p + 1] - 1] lie at place p. A corner's number is
 * three times its triangle's, plus 0, 1 or 2. */
struct corners {
    size_t *at, *corner;
    struct aob_vec3 *faces; /* unit normals of the triangles */
};

static void corners_init(struct corners *corners, const struct aob_mesh *mesh, const uint32_t *place)
{
    size_t count = 3 * mesh->triangle_count;
    corners->at = AOB_NEW_ARRAY(size_t, mesh->vertex_count + 1);
    for (size_t i = 0; i < count; i++) {
        uint32_t v = mesh->triangles[i / 3][i % 3];
        corners->at[place[v] + 1] += lacks_normal(mesh, v);
    }
    for (size_t p = 0; p < mesh->vertex_count; p++)
        corners->at[p + 1] += corners->at[p];
    size_t *next = AOB_NEW_ARRAY(size_t, mesh->vertex_count);
    memcpy(next, corners->at, mesh->vertex_count * sizeof *next);
    corners->corner = AOB_NEW_ARRAY(size_t, corners->at[mesh->vertex_count] + 1);
    for (size_t i = 0; i < count; i++) {
        uint32_t v = mesh->triangles[i / 3][i % 3];
        if (lacks_normal(mesh, v))
            corners->corner[next[place[v]]++] = i;
    }
    free(next);
    corners->faces = AOB_NEW_ARRAY(struct aob_vec3, mesh->triangle_count + 1);
    for (size_t i = 0; i < mesh->triangle_count; i++)
        corners->faces[i] = face_normal(mesh, i);
}

static void corners_finish(struct corners *corners)
{
    free(corners->at);
    free(corners->corner);
    free(corners->faces);
}

/* The sum has one order for all corners of a place, so that equal normals are equal to the bit. */
static struct aob_vec3 smooth_normal(const struct aob_mesh *mesh, const struct corners *corners, size_t place,
                                     size_t triangle)
{
    struct aob_vec3 sum = aob_vec(0, 0, 0), own = corners->faces[triangle];
    uint32_t material = aob_mesh_material_index(mesh, (uint32_t)triangle);
    for (size_t i = corners->at[place]; i < corners->at[place + 1]; i++) {
        size_t other = corners->corner[i] / 3;
        if (aob_vec_dot(corners->faces[other], own) >= least_cosine &&
            aob_mesh_material_index(mesh, (uint32_t)other) == material)
            sum = aob_vec_add(sum, corners->faces[other]);
    }
    struct aob_vec3 n = aob_vec_normalize(sum);
    return aob_vec_length(n) > 0.5 ? n : aob_vec(0, 1, 0); /* of a triangle without area any is as good */
}

/* Each corner without a normal gets a vertex of its own; those that turn out equal are joined afterwards. */
static void make_normals(struct aob_mesh *mesh, const uint32_t *place)
{
    struct corners corners;
    if (!mesh->normals)
        mesh->normals = AOB_NEW_ARRAY(struct aob_vec3, mesh->vertex_count + 1);
    corners_init(&corners, mesh, place);
    size_t old = mesh->vertex_count, made = corners.at[old];
    mesh->positions = aob_realloc(mesh->positions, old + made + 1, sizeof *mesh->positions);
    mesh->normals = aob_realloc(mesh->normals, old + made + 1, sizeof *mesh->normals);
    mesh->vertex_capacity = old + made + 1;
    for (size_t p = 0; p < old; p++)
        for (size_t i = corners.at[p]; i < corners.at[p + 1]; i++) {
            size_t corner = corners.corner[i];
            mesh->positions[old + i] = mesh->positions[p];
            mesh->normals[old + i] = smooth_normal(mesh, &corners, p, corner / 3);
        }
    for (size_t i = 0; i < made; i++)
        mesh->triangles[corners.corner[i] / 3][corners.corner[i] % 3] = (uint32_t)(old + i);
    mesh->vertex_count = old + made;
    corners_finish(&corners);
}

/* Vertices keep the order in which triangles name them first. */
static void join_equals(struct aob_mesh *mesh)
{
    uint32_t *first = aob_mesh_equals(mesh), *number = AOB_NEW_ARRAY(uint32_t, mesh->vertex_count + 1);
    struct aob_vec3 *positions = AOB_NEW_ARRAY(struct aob_vec3, mesh->vertex_count + 1);
    struct aob_vec3 *normals = AOB_NEW_ARRAY(struct aob_vec3, mesh->vertex_count + 1);
    uint32_t count = 0;
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        uint32_t *corner = &mesh->triangles[i / 3][i % 3], v = first[*corner];
        if (!number[v]) {
            positions[count] = mesh->positions[v];
            normals[count] = mesh->normals[v];
            number[v] = ++count;
        }
        *corner = number[v] - 1;
    }
    free(mesh->positions);
    free(mesh->normals);
    free(first);
    free(number);
    mesh->positions = positions;
    mesh->normals = normals;
    mesh->vertex_capacity = mesh->vertex_count + 1;
    mesh->vertex_count = count;
}

void aob_mesh_tidy(struct aob_mesh *mesh)
{
    uint32_t *place = aob_mesh_places(mesh);
    drop_degenerate(mesh, place);
    make_normals(mesh, place);
    free(place);
    join_equals(mesh);
}
