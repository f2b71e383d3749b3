/* One device, one API: textures, programs, passes. Four backends behind one table of functions: vulkan,
 * gl-egl, gl-osmesa, null. Arguments are checked here, once, above the table; a backend trusts its input.
 * Ownership: create/destroy; destroy takes NULL. Everything a device made must be destroyed before it.
 * Threads: a device is used by the thread that opened it.
 * Environment: drivers read theirs when the process starts; a backend's `environment` says what a worker must
 * set. */
#ifndef AOB_GPU_GPU_H
#define AOB_GPU_GPU_H
#include <aobudget/technique.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/error.h"

struct aob_gpu;
struct aob_gpu_texture;
struct aob_gpu_program;
struct aob_gpu_pass;

struct aob_gpu_info {    /* for the record's fingerprint; strings live as long as the device */
    const char *backend; /* "vulkan" */
    const char *device;  /* "llvmpipe (LLVM 15.0.6, 256 bits)" */
    const char *driver;  /* "Mesa 22.3.6" and the API version */
    bool software;       /* a processor does the work: costs are its CPU time */
    bool draws_nothing;  /* the null backend: images are zero and no fault of a technique */
};

struct aob_gpu_desc {
    bool validate; /* Vulkan validation layer (core, synchronization): its first message fails the call it
                      came from */
};

struct aob_gpu_time {
    int64_t wall_ns, cpu_ns; /* of submit to completion; cpu: all threads of this process */
};

enum aob_gpu_bind_kind {
    AOB_GPU_SAMPLED, /* uniform sampler2D, clamped to the edge, at `binding` */
    AOB_GPU_STORAGE, /* uniform readonly image2D, at `binding` */
};
struct aob_gpu_bind {
    enum aob_gpu_bind_kind kind;
    uint32_t binding; /* 1..15, unique in the pass; 0 is the uniform block */
    enum aob_filter filter;
    const struct aob_gpu_texture *texture;
};
enum aob_gpu_blend {
    AOB_GPU_REPLACE,
    AOB_GPU_ADD, /* to what the target holds, in its own format */
};
struct aob_gpu_pass_desc {
    const struct aob_gpu_program *program;
    const struct aob_gpu_bind *binds;
    size_t bind_count;
    const struct aob_gpu_texture *const *targets; /* location 0, 1, ...; all of one size, 1..AOB_MAX_OUT */
    size_t target_count;
    const void *uniforms; /* std140 block at binding 0 (copied); NULL: the program declares none */
    size_t uniform_size;
    /* Of a program with a vertex text only, zero for others. Its targets are cleared to 0 first; triangles are
     * drawn in order, both sides alike. */
    uint32_t vertex_count; /* three a triangle */
    bool depth_test;       /* against a float depth of the pass's own, cleared to 0: the greater wins */
    enum aob_gpu_blend blend;
};

/* One row per backend. All slots are required. */
struct aob_gpu_fns {
    const char *name;               /* the word in configs */
    const char *title;              /* one line for `list backends` */
    const char *const *environment; /* NULL-ended "NAME=value" that a worker's process must start with */
    struct aob_gpu *(*open)(const struct aob_gpu_desc *desc, struct aob_error *error);
    void (*close)(struct aob_gpu *gpu);
    bool (*texture_create)(struct aob_gpu *gpu, enum aob_format format, int width, int height,
                           const void *texels, struct aob_gpu_texture **texture, struct aob_error *error);
    void (*texture_destroy)(struct aob_gpu *gpu, struct aob_gpu_texture *texture);
    bool (*texture_read)(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, void *texels,
                         struct aob_error *error);
    bool (*program_create)(struct aob_gpu *gpu, const char *vertex /* NULL: the screen triangle */,
                           const char *fragment, struct aob_gpu_program **program, struct aob_error *error);
    void (*program_destroy)(struct aob_gpu *gpu, struct aob_gpu_program *program);
    bool (*pass_create)(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc, struct aob_gpu_pass **pass,
                        struct aob_error *error);
    void (*pass_destroy)(struct aob_gpu *gpu, struct aob_gpu_pass *pass);
    bool (*pass_run)(struct aob_gpu *gpu, struct aob_gpu_pass *pass, struct aob_gpu_time *time,
                     struct aob_error *error);
};
struct aob_gpu { /* first member of every backend's own struct */
    const struct aob_gpu_fns *fns;
    struct aob_gpu_info info;
};
struct aob_gpu_texture { /* likewise */
    enum aob_format format;
    int width, height;
};
struct aob_gpu_program { /* likewise */
    uint32_t bindings;   /* bit n: it declares BIND(n), so a pass must bind it */
    bool geometry;       /* it has a vertex text */
};

extern const struct aob_gpu_fns *const aob_gpu_backends[]; /* NULL-ended, in the order of `list backends` */
const struct aob_gpu_fns *aob_gpu_find(const char *name);  /* NULL if unknown */

/* NULL after one line that says what is missing (driver, loader, package). */
struct aob_gpu *aob_gpu_open(const char *backend, const struct aob_gpu_desc *desc, struct aob_error *error);
void aob_gpu_close(struct aob_gpu *gpu);

/* Tightly packed texels, row 0 at the top, in the format's own bits; NULL texels: undefined content. Every
 * texture can be sampled, read as a storage image, drawn to and read back. */
struct aob_gpu_texture *aob_gpu_texture_create(struct aob_gpu *gpu, enum aob_format format, int width,
                                               int height, const void *texels, struct aob_error *error);
void aob_gpu_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture);
bool aob_gpu_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, void *texels,
                          struct aob_error *error);

/* A fragment program from whole GLSL 4.50 text (prelude included, with BIND(n) macros: see gpu/glsl.h), drawn
 * over the full target by one triangle. A compile error's first line, with its line number, is the reason. */
struct aob_gpu_program *aob_gpu_program_create(struct aob_gpu *gpu, const char *glsl,
                                               struct aob_error *error);

/* A program that draws triangles: its vertex text has no inputs but VERTEX_ID and its bindings, which both
 * texts share, and writes gl_Position (0 <= z <= w is seen; y = -w is the image's upper edge on every API).
 * Outputs of the one are inputs of the other by location. */
struct aob_gpu_program *aob_gpu_program_create_geometry(struct aob_gpu *gpu, const char *vertex,
                                                        const char *fragment, struct aob_error *error);
void aob_gpu_program_destroy(struct aob_gpu *gpu, struct aob_gpu_program *program);

/* A pass is recorded once and run many times. It reads and writes whole textures; a texture must not be both.
 * Its program and textures must outlive it; binds, targets and uniforms are copied. */
struct aob_gpu_pass *aob_gpu_pass_create(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc,
                                         struct aob_error *error);
void aob_gpu_pass_destroy(struct aob_gpu *gpu, struct aob_gpu_pass *pass);

/* One submit and fence (or draw and glFinish): complete on return. `time` may be NULL. */
bool aob_gpu_pass_run(struct aob_gpu *gpu, struct aob_gpu_pass *pass, struct aob_gpu_time *time,
                      struct aob_error *error);

size_t aob_gpu_texel_size(enum aob_format format);         /* bytes */
int aob_gpu_texel_components(enum aob_format format);      /* 1, 2 or 4 */
const char *aob_gpu_format_layout(enum aob_format format); /* GLSL image layout word: "r32f" */
#endif
