/* Where a scene's geometry comes from, as a digest: the part of every key that says which geometry. */
#ifndef AOB_SCENE_SOURCE_H
#define AOB_SCENE_SOURCE_H
#include "base/error.h"
#include "base/hash.h"
#include "scene.h"

/* Of the geometry itself for a procedural scene (file NULL); for a mesh file of its bytes, its ending, and the files that
 * it names: buffers of a .gltf, material libraries of an .obj. The same for every build of the program that knows the
 * same geometry. False with a line if the file cannot be read. */
bool aob_source_digest(const struct aob_scene_info *info, const char *file, char key[AOB_KEY_SIZE],
                       struct aob_error *error);

/* Of that digest and, for a mesh file, the importer's version: which triangles this program makes of it. */
void aob_source_import_digest(const char *file, const char geometry[AOB_KEY_SIZE], char key[AOB_KEY_SIZE]);
#endif
