/* Materials of a glTF document; mesh.h has the rules. */
#ifndef AOB_SCENE_GLTF_MATERIAL_H
#define AOB_SCENE_GLTF_MATERIAL_H
#include "gltf.h"
#include "material.h"

/* The material of a primitive with the defaults of glTF 2.0 for what it leaves out (white, all metal, rough). Where
 * it has KHR_materials_pbrSpecularGlossiness and nothing else, the base colour is the diffuse one. Numbers are as the
 * file has them. *said is false where the primitive names none. False after one line. */
bool aob_gltf_material(const struct aob_gltf *gltf, const json_t *primitive, struct aob_material *material,
                       bool *said, struct aob_error *error);
#endif
