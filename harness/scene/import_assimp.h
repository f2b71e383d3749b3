/* Mesh files of every format that assimp reads and the program has no reader of its own for. */
#ifndef AOB_SCENE_IMPORT_ASSIMP_H
#define AOB_SCENE_IMPORT_ASSIMP_H
#include "mesh.h"

/* Adds the parts of the file to an empty mesh, in their places. What the file has and the mesh has not (bones,
 * morph targets, subdivision) is noted. False after one line that begins with the path. */
bool aob_assimp_import(struct aob_mesh *mesh, const char *path, struct aob_error *error);
#endif
