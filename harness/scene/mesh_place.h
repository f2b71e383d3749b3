/* Which vertices of a mesh lie at one place. */
#ifndef AOB_SCENE_MESH_PLACE_H
#define AOB_SCENE_MESH_PLACE_H
#include "mesh.h"

/* For each vertex the first one of the same position, to the bit (0 and -0 are the same); free() it. */
uint32_t *aob_mesh_places(const struct aob_mesh *mesh);

/* The same, for vertices whose normals are equal too; the mesh has normals. */
uint32_t *aob_mesh_equals(const struct aob_mesh *mesh);

/* For each of `count` records of `words` numbers the first one that holds the same; free() it. */
uint32_t *aob_first_equals(const uint64_t *records, size_t words, size_t count);
#endif
