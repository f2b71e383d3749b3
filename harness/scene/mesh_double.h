/* Faces that lie double in a mesh. */
#ifndef AOB_SCENE_MESH_DOUBLE_H
#define AOB_SCENE_MESH_DOUBLE_H
#include "mesh.h"

/* How many triangles have the corners of an earlier one, to the bit, and its front. Two that lie back to back are a
 * sheet with two sides, and do not count. */
size_t aob_mesh_double_count(const struct aob_mesh *mesh);
#endif
