/* The pass graph: what a technique's build() laid out, validated, pruned to the wanted outputs, and hashed.
 * Plain data; no device is needed. Threads: one at a time a graph. */
#ifndef AOB_TECHNIQUE_GRAPH_H
#define AOB_TECHNIQUE_GRAPH_H
#include <aobudget/technique.h>
#include <stddef.h>
#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"

enum { AOB_NAME_SIZE = 48 };

struct aob_graph_texture {
    char name[AOB_NAME_SIZE];
    enum aob_format format;
    int divisor;
    int width, height; /* of a table; 0: divided from the screen */
    void (*fill)(const void *values, void *texels);
    bool used; /* by a live pass */
};
struct aob_graph_bind {
    char name[AOB_NAME_SIZE];
    int texture; /* index into textures */
    enum aob_filter filter;
};
struct aob_graph_pass {
    char name[AOB_NAME_SIZE], shader[AOB_NAME_SIZE], defines[128];
    uint32_t reads;
    int depth; /* texture read in place of the G-buffer's depth, or -1 */
    enum aob_border border;
    enum aob_draw draw;
    char vertex[AOB_NAME_SIZE]; /* of AOB_TRIANGLES, like the next two; else empty and 0 */
    uint32_t per_triangle;
    float reach;
    struct aob_graph_bind in[AOB_MAX_IN], out[AOB_MAX_OUT];
    int in_count, out_count;
    bool live; /* something wanted depends on it */
};
struct aob_pass_graph {
    struct aob_graph interface; /* what build() sees; first member */
    const struct aob_technique *technique;
    uint32_t wanted; /* bits 1 << enum aob_output */
    struct aob_graph_texture textures[AOB_MAX_TEXTURE];
    int texture_count;
    struct aob_graph_pass passes[AOB_MAX_PASS];
    int pass_count;
    int outputs[AOB_OUTPUT_COUNT]; /* texture index, -1 where the technique gives none */
    struct aob_error *error;       /* during build() only */
};

/* Runs check() and build() of the technique (its code: only ever in a worker) and judges the result: names
 * known and unique, every texture written before it is read and by one pass only, none read and written by
 * one pass, outputs of one size, every wanted output full size and written. On false the line names technique
 * and object. */
bool aob_graph_build(struct aob_pass_graph *graph, const struct aob_technique *technique, const void *values,
                     uint32_t wanted, struct aob_error *error);

/* Divisor of the depth that a pass reads, and of what it writes. */
int aob_graph_depth_divisor(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass);
int aob_graph_target_divisor(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass);

/* Whether a live pass draws the scene's triangles. */
bool aob_graph_needs_triangles(const struct aob_pass_graph *graph);

/* Pixels of a texture in a G-buffer of width x height: divided, rounded up; a table's own. */
void aob_graph_texture_size(const struct aob_graph_texture *texture, int width, int height, int *w, int *h);

/* Of the live passes, their texts, formats and the compile-time constants: what the compiled programs depend
 * on. */
void aob_graph_digest(const struct aob_pass_graph *graph, const void *values, char key[AOB_KEY_SIZE]);

/* A Graphviz picture: passes as boxes (dead ones dashed), textures as edges. */
void aob_graph_dot(const struct aob_pass_graph *graph, struct aob_text *text);

const char *aob_format_name(enum aob_format format); /* "r32f" */
#endif
