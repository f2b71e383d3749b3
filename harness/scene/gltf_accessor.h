/* The numbers of a glTF accessor. */
#ifndef AOB_SCENE_GLTF_ACCESSOR_H
#define AOB_SCENE_GLTF_ACCESSOR_H
#include "gltf.h"

struct aob_numbers {
    double *values; /* count elements of `components` numbers each; free() it */
    size_t count;
    int components;
};

/* Reads an accessor of any component type, sparse ones too (glTF 2.0, 3.6.2). Normalised integers become c / max, at
 * least -1 (3.11, and KHR_mesh_quantization); others keep their value. `components`: 1 SCALAR, 2, 3, 4 VEC2 to VEC4,
 * 16 MAT4 in columns; 0 takes any of them. False after one line. */
bool aob_gltf_numbers(struct aob_gltf *gltf, size_t accessor, int components, struct aob_numbers *numbers,
                      struct aob_error *error);
#endif
