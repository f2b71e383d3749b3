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
    int divisor, levels; /* of a target; level l is divided by divisor << l. 1 of a table */
    int align; /* level 0 is allocated in multiples of 2^align, for its levels and those drawn with it */
    int width, height; /* of a table; 0: divided from the screen */
    void (*fill)(const void *values, void *texels);
    bool used; /* by a live pass */
    bool kept; /* a live pass reads what the frame before left in it, so there are two of it */
};
struct aob_graph_bind {
    char name[AOB_NAME_SIZE];
    int texture; /* index into textures */
    enum aob_filter filter;
    int level;       /* written, or of an input the finest read */
    int level_count; /* of an input: levels that it shows */
    bool previous;   /* of an input: it shows what the frame before left */
    bool one_level;  /* it shows no more than `level`, whatever is written: the composite's inputs */
};
struct aob_graph_define {
    char name[AOB_NAME_SIZE];
    int value;
};
struct aob_graph_pass {
    char name[AOB_NAME_SIZE], shader[AOB_NAME_SIZE];
    const char *text; /* of that shader; whoever has the texts keeps it */
    struct aob_graph_define defines[AOB_MAX_DEFINE];
    uint32_t reads;
    int depth;        /* texture read in place of the G-buffer's depth, or -1 */
    int depth_levels; /* levels of it that are read, from the finest */
    enum aob_border border;
    enum aob_draw draw;
    char vertex[AOB_NAME_SIZE]; /* of AOB_TRIANGLES, like the next three; else empty, NULL and 0 */
    const char *vertex_text;
    uint32_t per_triangle;
    float reach;
    struct aob_graph_bind in[AOB_MAX_IN], out[AOB_MAX_OUT];
    int define_count, in_count, out_count;
    bool live; /* something wanted depends on it */
};
struct aob_pass_graph {
    struct aob_graph interface; /* what build() sees; first member */
    const struct aob_technique *technique;
    const struct aob_shader
        *shaders;    /* that passes are laid with: the clearance's, the technique's, the composite's */
    uint32_t wanted; /* bits 1 << enum aob_output, what is required among them, and AOB_WANT_THRIFT */
    struct aob_graph_texture textures[AOB_MAX_TEXTURE];
    int texture_count;
    struct aob_graph_pass passes[AOB_MAX_PASS];
    int pass_count;
    int clear;                     /* texture of clearance.h, -1 where there is none */
    const char *unclear;           /* why there is none, if the technique says so (aob_clearance.because) */
    int outputs[AOB_OUTPUT_COUNT]; /* texture index, -1 where the technique gives none */
    struct aob_error *error;       /* during build() only */
};

enum { AOB_WANT_THRIFT = 1 << 16 }; /* a bit of `wanted`: passes may leave out what nothing can occlude */
enum { AOB_OUTPUTS_REQUIRED = 1 << AOB_OUT_VISIBILITY }; /* what every technique gives */

/* Runs check() and build() of the technique (its code: only ever in a worker) and judges the result: names
 * known and unique, every level of a texture written before it is read and by one pass only (a previous texture: by any pass), outputs of a pass of one
 * size, every required output given, every given one full size and written. What nothing wanted depends on is not
 * live. On false the line names technique and object. wanted: bits 1 << enum aob_output of what is wanted besides
 * AOB_OUTPUTS_REQUIRED; that a technique does not give all of them is no fault. Where AOB_OUT_LIT is wanted the composite's
 * pass (composite.h) follows the technique's; with AOB_WANT_THRIFT those of the clearance (clearance.h) come before. */
bool aob_graph_build(struct aob_pass_graph *graph, const struct aob_technique *technique, const void *values,
                     uint32_t wanted, struct aob_error *error);

/* Whether the technique gives an output that is wanted. */
bool aob_graph_gives(const struct aob_pass_graph *graph, enum aob_output which);

/* Whether thrift is wanted, and a live pass leaves out what nothing can occlude. */
bool aob_graph_leaves_out(const struct aob_pass_graph *graph);

/* The first component of its texture that an output has: 3 of a visibility that lies behind a bent normal, else 0. */
int aob_graph_output_component(const struct aob_pass_graph *graph, enum aob_output which);
const char *aob_output_name(enum aob_output which); /* "bent_normal" */
int aob_output_components(enum aob_output which);   /* of a pixel: 3 of a direction or colour, 1 of a share */

/* Divisors, of the depth that a pass reads, of what it writes, and of the texels of a bind. */
int aob_graph_depth_divisor(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass);
int aob_graph_target_divisor(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass);
int aob_graph_bind_divisor(const struct aob_pass_graph *graph, const struct aob_graph_bind *bind);

/* What the live passes read together: enum aob_read bits. */
uint32_t aob_graph_reads(const struct aob_pass_graph *graph);

/* Whether a live pass reads what the frame before left: frames are then drawn in turn, and the first is the frame 0. */
bool aob_graph_keeps_history(const struct aob_pass_graph *graph);

/* Whether a live pass draws the scene's triangles. */
bool aob_graph_needs_triangles(const struct aob_pass_graph *graph);

/* Pixels of the view that a divisor leaves of width x height, rounded up. */
void aob_graph_divided(int width, int height, int divisor, int *w, int *h);

/* Texels to allocate of a texture's finest level for a G-buffer of width x height; a table's own. A target of several
 * levels is made as large as its coarsest level needs, since APIs halve sizes rounding down; so are those that a pass
 * writes together with it, since the targets of a pass have one size. */
void aob_graph_texture_size(const struct aob_graph_texture *texture, int width, int height, int *w, int *h);

/* All levels of it. */
size_t aob_graph_texture_texels(const struct aob_graph_texture *texture, int width, int height);

/* The hash of the live passes, their texts, formats and the compile-time constants: what the compiled programs depend
 * on. */
void aob_graph_digest(const struct aob_pass_graph *graph, const void *values, char key[AOB_KEY_SIZE]);

/* A Graphviz picture: passes as boxes (dead ones dashed), textures as edges. */
void aob_graph_dot(const struct aob_pass_graph *graph, struct aob_text *text);

const char *aob_format_name(enum aob_format format); /* "r32f" */
#endif
