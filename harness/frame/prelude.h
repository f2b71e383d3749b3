/* The prelude: what the harness writes in front of a shader body (its names are documented in technique.h),
 * and the uniform block that goes with it. */
#ifndef AOB_FRAME_PRELUDE_H
#define AOB_FRAME_PRELUDE_H
#include <stddef.h>
#include <stdint.h>
#include "base/text.h"
#include "scene/camera.h"
#include "technique/graph.h"
#include "technique/option.h"

/* Bindings: 0 the uniform block, these two for the G-buffer, then the pass's inputs in order. */
enum { AOB_BINDING_DEPTH = 1, AOB_BINDING_NORMAL = 2, AOB_BINDING_FIRST_INPUT = 3 };

struct aob_prelude_desc {
    const struct aob_pass_graph *graph;
    const struct aob_graph_pass *pass;
    const void *values; /* the technique's own struct */
    bool perspective;
    enum aob_fetch fetch; /* of every nearest read; bilinear inputs are always sampled */
};

/* The whole program text for aob_gpu_program_create; the shader's own lines are numbered from 1. */
void aob_prelude_write(const struct aob_prelude_desc *desc, struct aob_text *text);

/* The std140 block: projection, sizes, then the uniform parameters in table order. */
enum { AOB_UNIFORM_HEAD = 48, AOB_UNIFORM_MAX = AOB_UNIFORM_HEAD + 4 * AOB_MAX_PARAM };
size_t aob_prelude_uniforms(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass,
                            const void *values, const struct aob_projection *projection,
                            unsigned char block[AOB_UNIFORM_MAX]);
#endif
