#include "mesh_sums.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

void faces_finish(struct faces *faces)
{
    free(faces->points);
    free(faces->corners);
    free(faces->sizes);
}

void faces_add_point(struct faces *faces, double x, double y, double z)
{
    float *p = *AOB_PUSH(faces->points, faces->point_count, faces->point_capacity);
    p[0] = (float)x;
    p[1] = (float)y;
    p[2] = (float)z;
}

static int by_place(const void *a, const void *b)
{
    const float *p = a, *q = b;
    for (int c = 0; c < 3; c++)
        if (p[c] != q[c])
            return p[c] < q[c] ? -1 : 1;
    return 0;
}

static void add_places(float (*places)[3], size_t count, struct mesh_sums *sums)
{
    qsort(places, count, sizeof *places, by_place);
    for (size_t i = 0; i < count; i++) {
        if (i && by_place(places[i], places[i - 1]) == 0)
            continue;
        sums->places++;
        for (int c = 0; c < 3; c++) {
            sums->first[c] += (double)places[i][c];
            sums->second[c] += (double)places[i][c] * (double)places[i][c];
        }
    }
}

static void add_area(const float a[3], const float b[3], const float c[3], struct mesh_sums *sums)
{
    double u[3], v[3];
    for (int k = 0; k < 3; k++) {
        u[k] = (double)b[k] - (double)a[k];
        v[k] = (double)c[k] - (double)a[k];
    }
    for (int k = 0; k < 3; k++) {
        double one = u[(k + 1) % 3] * v[(k + 2) % 3], other = u[(k + 2) % 3] * v[(k + 1) % 3];
        sums->area[k] += one - other;
        sums->area_scale += fabs(one) + fabs(other);
    }
}

/* A polygon with two corners at one place could be cut in several ways, and a triangle is then none. */
static bool add_face(const struct faces *faces, const uint32_t *corner, uint32_t size, float (*places)[3],
                     size_t *used, struct mesh_sums *sums, bool *judged)
{
    bool plain = true;
    for (uint32_t i = 0; i < size; i++) {
        if (corner[i] >= faces->point_count)
            return false;
        const float *p = faces->points[corner[i]];
        if (!isfinite(p[0]) || !isfinite(p[1]) || !isfinite(p[2]))
            return false;
        for (uint32_t k = 0; k < i; k++)
            plain = plain && by_place(p, faces->points[corner[k]]) != 0;
    }
    *judged = *judged && (plain || size == 3);
    if (!plain || size < 3)
        return size >= 3;
    for (uint32_t i = 0; i < size; i++)
        memcpy(places[(*used)++], faces->points[corner[i]], sizeof *places);
    for (uint32_t i = 2; i < size; i++)
        add_area(faces->points[corner[0]], faces->points[corner[i - 1]], faces->points[corner[i]], sums);
    sums->triangles += size - 2;
    return true;
}

bool faces_sum(const struct faces *faces, struct mesh_sums *sums)
{
    float(*places)[3] = aob_alloc(faces->corner_count + 1, sizeof *places);
    size_t used = 0, at = 0;
    bool ok = true, judged = true;
    *sums = (struct mesh_sums){0};
    for (size_t i = 0; ok && i < faces->face_count; i++) {
        ok = add_face(faces, faces->corners + at, faces->sizes[i], places, &used, sums, &judged);
        at += faces->sizes[i];
    }
    add_places(places, used, sums);
    free(places);
    return ok && judged && sums->triangles;
}

void mesh_sums_of(const struct aob_mesh *mesh, struct mesh_sums *sums)
{
    struct faces faces = {0};
    for (size_t i = 0; i < mesh->vertex_count; i++)
        faces_add_point(&faces, mesh->positions[i].x, mesh->positions[i].y, mesh->positions[i].z);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        for (int k = 0; k < 3; k++)
            *AOB_PUSH(faces.corners, faces.corner_count, faces.corner_capacity) = mesh->triangles[i][k];
        *AOB_PUSH(faces.sizes, faces.face_count, faces.face_capacity) = 3;
    }
    faces_sum(&faces, sums);
    faces_finish(&faces);
}

static bool near_sum(double a, double b, double scale)
{
    return fabs(a - b) <= 1e-5 * scale;
}

bool mesh_sums_agree(const struct mesh_sums *a, const struct mesh_sums *b)
{
    double size = sqrt(a->second[0] + a->second[1] + a->second[2]);
    bool same = a->triangles == b->triangles && a->places == b->places;
    for (int c = 0; c < 3; c++)
        same = same && near_sum(a->first[c], b->first[c], size * sqrt((double)a->places)) &&
               near_sum(a->second[c], b->second[c], size * size) &&
               near_sum(a->area[c], b->area[c], a->area_scale);
    return same;
}
