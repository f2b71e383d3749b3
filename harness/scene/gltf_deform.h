/* What moves the vertices of a glTF primitive before its node places them: morph targets, and skins. */
#ifndef AOB_SCENE_GLTF_DEFORM_H
#define AOB_SCENE_GLTF_DEFORM_H
#include "gltf_node.h"
#include "gltf_primitive.h"
#include "mesh_part.h"

/* Adds each target's displacements, times the weight of the node, else of the mesh, else 0 (glTF 2.0, 3.7.2.2). False
 * after one line. */
bool aob_gltf_morph(const struct aob_gltf_primitive *primitive, const json_t *node, const json_t *mesh,
                    struct aob_mesh_part *part, struct aob_error *error);

/* Maps each vertex by the weighted mean of its joints' matrices (3.7.3) into the scene's space, at rest: animations do
 * not play. Weights are divided by their sum; a vertex whose weights are all 0 follows its first joint. Triangles whose
 * joints mirror them turn their winding. A primitive without joints is left as it is, and *done is false. */
bool aob_gltf_skin(const struct aob_gltf_primitive *primitive, size_t skin,
                   const struct aob_gltf_nodes *nodes, struct aob_mesh_part *part, bool *done,
                   struct aob_error *error);
#endif
