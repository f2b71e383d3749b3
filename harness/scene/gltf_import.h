/* The reader of glTF 2.0. It reads every component type, sparse and normalised accessors, strips and fans, node
 * transforms, morph targets at their weights, skins at rest, EXT_mesh_gpu_instancing, KHR_mesh_quantization,
 * KHR_draco_mesh_compression, EXT_meshopt_compression and KHR_node_visibility. Animations do not play. An unknown entry
 * of extensionsRequired is refused by its name. An unknown extension of a node, mesh or primitive is noted. */
#ifndef AOB_SCENE_GLTF_IMPORT_H
#define AOB_SCENE_GLTF_IMPORT_H
#include "gltf_file.h"
#include "mesh.h"

/* Adds the parts of the document's scene to an empty mesh, in their places. False after one line that begins with the
 * file's path. */
bool aob_gltf_import(struct aob_mesh *mesh, const struct aob_gltf_file *file, struct aob_error *error);
#endif
