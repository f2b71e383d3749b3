/* What a mesh holds in numbers that do not depend on the order of triangles, or on how polygons are cut. */
#ifndef AOB_TESTS_SCENE_MESH_SUMS_H
#define AOB_TESTS_SCENE_MESH_SUMS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "scene/mesh.h"

struct mesh_sums {
    size_t triangles, places;   /* places: different positions that faces name */
    double first[3], second[3]; /* sums of the coordinates of places, and of their squares */
    double area[3];             /* the sum of the faces' area vectors */
    double area_scale;          /* the sum of the sizes of its terms: what rounding is measured by */
};

void mesh_sums_of(const struct aob_mesh *mesh, struct mesh_sums *sums);

/* Whether two readers have read the same. */
bool mesh_sums_agree(const struct mesh_sums *a, const struct mesh_sums *b);

/* Faces while they are read: positions are floats, as all these formats have them. */
struct faces {
    float (*points)[3];
    size_t point_count, point_capacity;
    uint32_t *corners; /* of all faces, one after the other */
    size_t corner_count, corner_capacity;
    uint32_t *sizes;
    size_t face_count, face_capacity;
};

void faces_finish(struct faces *faces);
void faces_add_point(struct faces *faces, double x, double y, double z);

/* False where a face is broken, could be cut in several ways, or there is none. */
bool faces_sum(const struct faces *faces, struct mesh_sums *sums);
#endif
