/* Where a scene's geometry comes from, as a digest: the part of every key that says which geometry. */
#ifndef AOB_SCENE_SOURCE_H
#define AOB_SCENE_SOURCE_H
#include "base/error.h"
#include "base/hash.h"
#include "scene.h"

/* Of the geometry itself for a procedural scene (file NULL); for a mesh file of its bytes, its ending, the importer's
 * version, and the files that it names: buffers of a .gltf, material libraries of an .obj. False with a line if the file cannot be read. */
bool aob_source_digest(const struct aob_scene_info *info, const char *file, char key[AOB_KEY_SIZE],
                       struct aob_error *error);
#endif
