/* The prelude: what the harness writes in front of a shader body (its names are documented in technique.h),
 * and the uniform block that goes with it. */
#ifndef AOB_FRAME_PRELUDE_H
#define AOB_FRAME_PRELUDE_H
#include <stddef.h>
#include <stdint.h>
#include "base/text.h"
#include "gbuffer/encoding.h"
#include "scene/camera.h"
#include "technique/graph.h"
#include "technique/option.h"

/* Bindings: 0 the uniform block, these for the G-buffer and the pass's own depth, then its inputs in order. */
enum { AOB_BINDING_DEPTH = 1, AOB_BINDING_NORMAL, AOB_BINDING_OWN_DEPTH, AOB_BINDING_FIRST_INPUT };
enum { AOB_BINDING_TRIANGLES = AOB_BINDING_FIRST_INPUT + AOB_MAX_IN }; /* always sampled */

struct aob_prelude_desc {
    const struct aob_pass_graph *graph;
    const struct aob_graph_pass *pass;
    const void *values;                  /* the technique's own struct */
    const struct aob_encoding *encoding; /* of the screen */
    enum aob_fetch fetch;                /* of every nearest read; bilinear inputs are always sampled */
};

/* The whole program text for aob_gpu_program_create; the shader's own lines are numbered from 1. */
void aob_prelude_write(const struct aob_prelude_desc *desc, struct aob_text *text);

/* Likewise the vertex text of a pass of triangles. */
void aob_prelude_write_vertex(const struct aob_prelude_desc *desc, struct aob_text *text);

/* The std140 block: projection (of the pixels of the depth that the pass reads), sizes, frame, range of the depth
 * encoding, then the uniform parameters in table order. */
enum { AOB_UNIFORM_HEAD = 64, AOB_UNIFORM_MAX = AOB_UNIFORM_HEAD + 4 * AOB_MAX_PARAM };
size_t aob_prelude_uniforms(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass,
                            const void *values, const struct aob_projection *projection,
                            const struct aob_encoding *encoding, unsigned char block[AOB_UNIFORM_MAX]);
#endif
