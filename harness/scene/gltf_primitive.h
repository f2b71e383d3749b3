/* A primitive of a glTF mesh: its attributes, as they are or decompressed, and its triangles. */
#ifndef AOB_SCENE_GLTF_PRIMITIVE_H
#define AOB_SCENE_GLTF_PRIMITIVE_H
#include <stdint.h>
#include "gltf_accessor.h"
#include "gltf_draco.h"

struct aob_gltf_primitive {
    struct aob_gltf *gltf;
    const json_t *element;
    struct aob_draco *draco; /* NULL: not compressed so */
    size_t vertex_count;
    uint32_t (*triangles)[3]; /* triangle_count; indices are below vertex_count. NULL once taken */
    size_t triangle_count;
};

/* Reads what POSITION, indices and mode say; points, lines, and a primitive without positions have no triangles. False
 * after one line; aob_gltf_primitive_finish frees after either. */
bool aob_gltf_primitive_init(struct aob_gltf_primitive *primitive, struct aob_gltf *gltf,
                             const json_t *element, struct aob_error *error);
void aob_gltf_primitive_finish(struct aob_gltf_primitive *primitive);

/* An attribute by its name, such as "NORMAL", of vertex_count elements. `components` 0 takes 1 to 4 of them. `values`
 * NULL, and true, where there is none. */
bool aob_gltf_attribute(const struct aob_gltf_primitive *primitive, const char *name, int components,
                        struct aob_numbers *numbers, struct aob_error *error);

/* The same of a set of attributes that is no primitive's: {"POSITION": accessor}. */
bool aob_gltf_attribute_of(struct aob_gltf *gltf, const json_t *attributes, const char *name, int components,
                           struct aob_numbers *numbers, struct aob_error *error);
#endif
