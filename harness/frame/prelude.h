/* The prelude: what the harness writes in front of a shader body (its names are documented in technique.h),
 * and the uniform block that goes with it. */
#ifndef AOB_FRAME_PRELUDE_H
#define AOB_FRAME_PRELUDE_H
#include <stddef.h>
#include <stdint.h>
#include "base/text.h"
#include "gbuffer/encoding.h"
#include "scene/affine.h"
#include "scene/camera.h"
#include "scene/light.h"
#include "technique/graph.h"
#include "technique/option.h"

/* The bindings of a pass. What may be read as a storage image comes first: on OpenGL a binding is an image unit, of
 * which drivers have 16 or 32 (the standard asks for 8, which holds depths, normal and four inputs). A texture of the frame before
 * is an input like others. */
enum aob_binding {
    AOB_BINDING_UNIFORMS,
    AOB_BINDING_DEPTH,
    AOB_BINDING_NORMAL,
    AOB_BINDING_OWN_DEPTH,
    AOB_BINDING_FIRST_INPUT,
    AOB_BINDING_VELOCITY = AOB_BINDING_FIRST_INPUT + AOB_MAX_IN,
    AOB_BINDING_ALBEDO,
    AOB_BINDING_SHINE,       /* roughness and metalness */
    AOB_BINDING_IMAGE_COUNT, /* from here on never an image */
    AOB_BINDING_TRIANGLES = AOB_BINDING_IMAGE_COUNT,
    AOB_BINDING_COUNT,
};

struct aob_planes;
struct aob_prelude_desc {
    const struct aob_pass_graph *graph;
    const struct aob_graph_pass *pass;
    const void *values;                  /* the technique's own struct */
    const struct aob_encoding *encoding; /* of the screen */
    enum aob_fetch fetch;                /* of the reads that aob_prelude_is_storage is for */
    const struct aob_light *light;       /* view space; only of a pass that reads it */
    const struct aob_affine *then; /* as struct aob_screen has it; only of a pass that reads the velocity */
    const struct aob_planes
        *planes; /* the pass writes down what it reads (frame/trace.h); NULL: it does not */
};

/* Whether a texture is read as a storage image: not if it is bilinear or shows several levels. */
bool aob_prelude_is_storage(enum aob_fetch fetch, enum aob_filter filter, int levels);

/* The whole program text for aob_gpu_program_create; the shader's own lines are numbered from 1. */
void aob_prelude_write(const struct aob_prelude_desc *desc, struct aob_text *text);

/* The same for the vertex text of a pass of triangles. */
void aob_prelude_write_vertex(const struct aob_prelude_desc *desc, struct aob_text *text);

/* The std140 block: projection (of the pixels of the depth that the pass reads), sizes, frame, range of the depth
 * encoding, of a pass that reads them the light and the motion of the camera, then the uniform parameters in table order. */
enum {
    AOB_UNIFORM_HEAD = 64,
    AOB_UNIFORM_LIGHT = 9 * 16,
    AOB_UNIFORM_THEN = 3 * 16,
    AOB_UNIFORM_MAX = AOB_UNIFORM_HEAD + AOB_UNIFORM_LIGHT + AOB_UNIFORM_THEN + 4 * AOB_MAX_PARAM
};
size_t aob_prelude_uniforms(const struct aob_prelude_desc *desc, const struct aob_projection *projection,
                            int frame, unsigned char block[AOB_UNIFORM_MAX]);
#endif
