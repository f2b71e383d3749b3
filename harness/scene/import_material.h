/* The material of an assimp mesh, or of one of its faces where vertices have colours; mesh.h has the rules. */
#ifndef AOB_SCENE_IMPORT_MATERIAL_H
#define AOB_SCENE_IMPORT_MATERIAL_H
#include <assimp/scene.h>
#include "material.h"

/* `material` may be NULL. `face` may be NULL too; vertex colours then do not count. Numbers are clamped; one that is
 * NAN stays so. */
struct aob_material aob_import_material(const struct aiMaterial *material, const struct aiMesh *mesh,
                                        const struct aiFace *face);
#endif
