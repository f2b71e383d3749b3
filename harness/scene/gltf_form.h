/* The form of a glTF 2.0 document: of which kind of JSON its members are. */
#ifndef AOB_SCENE_GLTF_FORM_H
#define AOB_SCENE_GLTF_FORM_H
#include "gltf_file.h"

/* Whether each member that the reader looks at is of the kind of JSON that the format gives it, and each that the format
 * demands is there, wherever it stands in the document and whether or not the scene uses it. A reader behind this check
 * takes a member that it does not find for one that is not there. Kinds of indices and sizes are not judged here but
 * where they are read (aob_gltf_whole, aob_gltf_vector). False after one line that names the place:
 * "FILE: meshes[0].weights[1] is no number: the file is damaged". */
bool aob_gltf_form_check(const struct aob_gltf_file *file, struct aob_error *error);
#endif
