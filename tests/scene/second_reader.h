/* Readers of mesh files that owe nothing to the program's: small strict ones of OBJ, PLY and STL, and assimp for glTF.
 * They say what a file holds in numbers that do not depend on the order of triangles, or on how polygons are cut. */
#ifndef AOB_TESTS_SCENE_SECOND_READER_H
#define AOB_TESTS_SCENE_SECOND_READER_H
#include <stdbool.h>
#include "scene/mesh.h"

struct mesh_sums {
    size_t triangles, places;   /* places: different positions that faces name */
    double first[3], second[3]; /* sums of the coordinates of places, and of their squares */
    double area[3];             /* the sum of the faces' area vectors */
    double area_scale;          /* the sum of the sizes of its terms: what rounding is measured by */
};

void mesh_sums_of(const struct aob_mesh *mesh, struct mesh_sums *sums);

/* False where the reader does not understand the file, or finds anything in it that is not plainly right. */
bool second_reader(const char *file, struct mesh_sums *sums);

/* Whether two readers have read the same. */
bool mesh_sums_agree(const struct mesh_sums *a, const struct mesh_sums *b);
#endif
