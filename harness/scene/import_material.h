/* The material of an assimp mesh, or of one of its faces where vertices have colours; mesh.h has the rules. */
#ifndef AOB_SCENE_IMPORT_MATERIAL_H
#define AOB_SCENE_IMPORT_MATERIAL_H
#include <assimp/scene.h>
#include "material.h"

/* `material` may be NULL, and `face`: then without vertex colours. Numbers are clamped; one that is none stays NAN. */
struct aob_material aob_import_material(const struct aiMaterial *material, const struct aiMesh *mesh,
                                        const struct aiFace *face);
#endif
