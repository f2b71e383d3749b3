/* The material of an assimp mesh; mesh.h has the rules. */
#ifndef AOB_SCENE_IMPORT_MATERIAL_H
#define AOB_SCENE_IMPORT_MATERIAL_H
#include <assimp/scene.h>
#include <stdbool.h>
#include "material.h"

/* False where the file says none: assimp then makes one up, which does not count. Numbers are as the file has them. */
bool aob_import_material(const struct aiMaterial *material, struct aob_material *into);
#endif
