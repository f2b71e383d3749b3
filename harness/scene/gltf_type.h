/* Which component types the accessor of an attribute may have. */
#ifndef AOB_SCENE_GLTF_TYPE_H
#define AOB_SCENE_GLTF_TYPE_H
#include "gltf.h"

/* Judges the accessor of what `name` says: an attribute such as POSITION or JOINTS_0 (glTF 2.0, 3.7.2.1), of a morph
 * target or an instance too, "indices", or "inverseBindMatrices". Whole numbers as positions and normals are of the
 * format only where the document declares KHR_mesh_quantization. Other names are not judged. False after one line that
 * names the accessor. */
bool aob_gltf_type_check(const struct aob_gltf *gltf, size_t accessor, const char *name,
                         struct aob_error *error);
#endif
