/* A digest of where a scene's geometry comes from. It is the part of every key that says which geometry. */
#ifndef AOB_SCENE_SOURCE_H
#define AOB_SCENE_SOURCE_H
#include "base/error.h"
#include "base/hash.h"
#include "scene.h"

/* Digests the geometry itself of a procedural scene (file NULL). For a mesh file it digests its bytes, its ending,
 * and the files that it names: buffers of glTF, material libraries of an .obj. The digest is the same for every
 * build of the program that knows the same geometry. False with a line if the file cannot be read. */
bool aob_source_digest(const struct aob_scene_info *info, const char *file, char key[AOB_KEY_SIZE],
                       struct aob_error *error);

/* Digests that digest and, for a mesh file, the importer's version: so it says which triangles this program makes of
 * the file. */
void aob_source_import_digest(const char *file, const char geometry[AOB_KEY_SIZE], char key[AOB_KEY_SIZE]);
#endif
