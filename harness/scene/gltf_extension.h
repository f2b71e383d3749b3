/* Extensions of glTF: which are applied, which only change what this program does not read, and which are unknown. */
#ifndef AOB_SCENE_GLTF_EXTENSION_H
#define AOB_SCENE_GLTF_EXTENSION_H
#include "gltf.h"
#include "mesh.h"

/* False after a line that names it if an entry of the document's extensionsRequired is unknown. */
bool aob_gltf_check_required(const struct aob_gltf_file *file, struct aob_error *error);

/* Notes each unknown extension of the element, a node, mesh or primitive, whose shape it may change. */
void aob_gltf_note_unknown(const json_t *element, const char *what, struct aob_mesh *mesh);
#endif
