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
struct aob_gpu_buffer;
struct aob_gpu_program;
struct aob_gpu_pass;

struct aob_gpu_info {    /* for the record's fingerprint; strings live as long as the device */
    const char *backend; /* "vulkan" */
    const char *device;  /* "llvmpipe (LLVM 15.0.6, 256 bits)" */
    const char *driver;  /* "Mesa 22.3.6" and the API version */
    const char *
        device_class; /* what a history may follow: "cpu", "integrated", "discrete", "virtual"; "gpu" where the
                                 API does not say which */
    bool software;    /* a processor does the work: costs are its CPU time */
    bool timer;       /* it has a clock of its own; timing/timer.h finds out whether that tells the truth */
    bool draws_nothing;   /* the null backend: images are zero and no fault of a technique */
    size_t storage_bytes; /* of the largest storage buffer that fragment programs can write; 0: they cannot */
};

struct aob_gpu_desc {
    bool validate; /* Vulkan validation layer (core, synchronization): its first message fails the call it
                      came from */
    bool
        as_gpu; /* a software device runs lists of passes as a GPU does (aob_gpu_run): for the test of its timer,
                      and so that the ways of a GPU are tested where there is none */
    bool
        robust; /* reads outside of images and buffers give zeros, and writes there do nothing: Vulkan's robust access */
    const char *device; /* number or name, as aob_gpu_choose says; NULL: the backend's default */
};

/* How much of something a device has, so that what needs more is refused before it is made. */
struct aob_gpu_limits {
    uint32_t side;             /* texels of a texture's width or height */
    uint32_t targets;          /* of a pass */
    uint32_t sampled, storage; /* textures that a pass binds as AOB_GPU_SAMPLED, as AOB_GPU_STORAGE */
    uint32_t vertex_sampled, vertex_storage; /* the same of a pass with a vertex text */
    uint32_t storage_bindings;               /* the bindings of storage images lie below it */
    uint32_t resources;           /* textures, targets, buffer and uniform block of a pass together */
    uint32_t storage_and_targets; /* storage images, buffer and targets together */
    bool lacks_depth;             /* no pass can have a depth test */
};
extern const struct aob_gpu_limits aob_gpu_no_limits; /* a pass can reach none of them */

struct aob_gpu_device {          /* one that a backend can see, opened or not */
    char name[256], driver[640]; /* as in struct aob_gpu_info */
    const char *device_class;    /* the same */
    bool software, timer;        /* the same */
    char lacks[128];             /* what it lacks to be opened, "Vulkan 1.3"; empty: nothing */
    uint64_t node;               /* device number of its DRM render node; 0: none, or not known */
};
enum { AOB_GPU_MAX_DEVICES = 32 };
struct aob_gpu_device_list { /* a device's number is its place */
    struct aob_gpu_device items[AOB_GPU_MAX_DEVICES];
    size_t count;
    struct aob_error none; /* why none of them is the default; empty where one is */
};

/* A time that nobody took is 0. */
struct aob_gpu_time {
    int64_t wall_ns, cpu_ns; /* of submit to completion; cpu: all threads of this process */
    int64_t device_ns;       /* by the device's own clock */
};

/* What a texture may be used for: a device keeps it in the form that is fastest for just that, so ask for no
 * more than is needed. A use that it was not made for is refused. */
enum aob_gpu_use {
    AOB_GPU_USE_SAMPLED = 1,   /* bound as AOB_GPU_SAMPLED */
    AOB_GPU_USE_STORAGE = 2,   /* bound as AOB_GPU_STORAGE */
    AOB_GPU_USE_TARGET = 4,    /* drawn to by a pass */
    AOB_GPU_USE_READ_BACK = 8, /* read by aob_gpu_texture_read */
};
/* What a pass may ask of a texture's format besides its uses. */
enum aob_gpu_need {
    AOB_GPU_NEED_FILTER = 16, /* bound with AOB_BILINEAR */
    AOB_GPU_NEED_BLEND = 32,  /* drawn to with AOB_GPU_ADD */
};
struct aob_gpu_texture_desc {
    enum aob_format format;
    int width, height; /* in texels, of level 0 */
    int levels;        /* 0 means 1; each level's sides are half of those above it: aob_gpu_level_side */
    uint32_t uses;     /* bits of enum aob_gpu_use, at least one */
    const void
        *texels; /* of level 0, tightly packed, row 0 at the top, in the format's own bits; NULL: undefined
                           content, as that of the other levels always is */
};

enum aob_gpu_bind_kind {
    AOB_GPU_SAMPLED, /* uniform sampler2D, clamped to the edge, at `binding` */
    AOB_GPU_STORAGE, /* uniform readonly image2D, at `binding` */
};
struct aob_gpu_bind {
    enum aob_gpu_bind_kind kind;
    uint32_t binding;       /* 1..AOB_GPU_MAX_BINDING, unique in the pass; 0 is the uniform block */
    enum aob_filter filter; /* within a level; of the levels the nearest is read */
    const struct aob_gpu_texture *texture;
    int first_level; /* GLSL's lod 0 */
    int level_count; /* 0: all from first_level on. A storage image shows one level */
    bool vertex;     /* the vertex text has it too */
};
enum { AOB_GPU_MAX_BINDING = 31 };

struct aob_gpu_target {
    const struct aob_gpu_texture *texture;
    int level;
};
enum aob_gpu_blend {
    AOB_GPU_REPLACE,
    AOB_GPU_ADD, /* to what the target holds, in its own format */
};
/* Changes the words of a fragment text before the driver gets them, for a program that writes down what it does. `words`
 * gives allocated ones (free()) and their count, or NULL after one line. `storage` is the number of BIND_STORAGE there, in
 * set 0. It is called while the program is created and not later. */
struct aob_gpu_rewrite {
    void *self;
    uint32_t *(*words)(void *self, const uint32_t *words, size_t *count /* of `words`, then of the result */,
                       uint32_t storage, struct aob_error *error);
};
struct aob_gpu_program_desc {
    const char *vertex;                    /* NULL: the screen triangle */
    const char *fragment;                  /* required */
    const struct aob_gpu_rewrite *rewrite; /* NULL: the driver gets the words as they are */
};

struct aob_gpu_pass_desc {
    const struct aob_gpu_program *program;
    const struct aob_gpu_bind *binds;
    size_t bind_count;
    const struct aob_gpu_target *targets; /* location 0, 1, ...; levels of one size, 1..AOB_MAX_OUT */
    size_t target_count;
    int width, height;    /* area drawn, in texels from row and column 0; the rest of the level keeps what it
                             holds. 0: the level's whole width or height */
    const void *uniforms; /* std140 block at binding 0 (copied); NULL: the program declares none */
    size_t uniform_size;
    /* The rest is for programs with a vertex text only, and zero for others. The area is cleared to 0 first; triangles
     * are drawn in order, both sides alike. */
    uint32_t vertex_count; /* three a triangle */
    bool depth_test;       /* against a float depth of the pass's own, cleared to 0: the greater wins */
    enum aob_gpu_blend blend;
    /* For passes that write down what they do; zero for others. */
    const struct aob_gpu_buffer *storage; /* at BIND_STORAGE; NULL: the program declares none */
    bool in_parts;                        /* aob_gpu_pass_set_part is for it */
};
struct aob_gpu_part { /* of a pass: what the next runs draw, and clear if they clear */
    int row, rows;    /* of its area; 0 rows: all of it */
    uint32_t first_vertex,
        vertex_count; /* three a triangle; VERTEX_ID counts from the pass's first; 0: all */
};

enum { AOB_GPU_MAX_LIST = 2 * AOB_MAX_PASS }; /* two frames of a technique that keeps a history */
struct aob_gpu_run_desc {
    struct aob_gpu_pass *const *passes; /* run in this order; a pass may stand in it more than once */
    size_t count;                       /* 1..AOB_GPU_MAX_LIST */
    int repeats;                        /* of the whole list, at least 1 */
};

/* One row per backend. All slots are required. */
struct aob_gpu_fns {
    const char *name;               /* the word in configs */
    const char *title;              /* one line for `list backends` */
    const char *const *environment; /* NULL-ended "NAME=value" that a worker's process must start with */
    bool (*devices)(struct aob_gpu_device_list *list, size_t *chosen, struct aob_error *error);
    struct aob_gpu *(*open)(const struct aob_gpu_desc *desc, struct aob_error *error);
    void (*close)(struct aob_gpu *gpu);
    /* The word for the first of the needs (bits of enum aob_gpu_use and enum aob_gpu_need) that the device lacks for the
     * format: "storage image"; NULL: none. */
    const char *(*format_lacks)(const struct aob_gpu *gpu, enum aob_format format, uint32_t needs);
    bool (*texture_create)(struct aob_gpu *gpu, const struct aob_gpu_texture_desc *desc,
                           struct aob_gpu_texture **texture, struct aob_error *error);
    void (*texture_destroy)(struct aob_gpu *gpu, struct aob_gpu_texture *texture);
    bool (*texture_read)(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, int level, void *texels,
                         struct aob_error *error);
    bool (*texture_write)(struct aob_gpu *gpu, struct aob_gpu_texture *texture, const void *texels,
                          struct aob_error *error);
    bool (*buffer_create)(struct aob_gpu *gpu, size_t size, struct aob_gpu_buffer **buffer,
                          struct aob_error *error);
    void (*buffer_destroy)(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer);
    bool (*buffer_write)(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                         const void *bytes, struct aob_error *error);
    bool (*buffer_read)(struct aob_gpu *gpu, const struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                        void *bytes, struct aob_error *error);
    bool (*program_create)(struct aob_gpu *gpu, const struct aob_gpu_program_desc *desc,
                           struct aob_gpu_program **program, struct aob_error *error);
    void (*program_destroy)(struct aob_gpu *gpu, struct aob_gpu_program *program);
    bool (*pass_create)(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc, struct aob_gpu_pass **pass,
                        struct aob_error *error);
    void (*pass_destroy)(struct aob_gpu *gpu, struct aob_gpu_pass *pass);
    bool (*pass_set_uniforms)(struct aob_gpu *gpu, struct aob_gpu_pass *pass, const void *block,
                              struct aob_error *error);
    void (*pass_set_part)(struct aob_gpu_pass *pass, const struct aob_gpu_part *part); /* no zeros in it */
    /* The whole list in one submit, `repeats` times. The times are zeros when it is called, and what it takes is added:
     * wall_ns and cpu_ns to `whole`; device_ns to `whole` and to each of `times` if the device runs lists and has a
     * timer. */
    bool (*run)(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                struct aob_gpu_time *whole, struct aob_error *error);
};
struct aob_gpu { /* first member of every backend's own struct */
    const struct aob_gpu_fns *fns;
    struct aob_gpu_info info;
    struct aob_gpu_limits limits;
    bool
        lists; /* aob_gpu_run puts many passes into a submit: it is no software device, or was opened as_gpu */
};
struct aob_gpu_texture { /* first member of each backend's own, as are the next three */
    enum aob_format format;
    int width, height; /* of level 0 */
    int levels;
    uint32_t uses;
    bool filled; /* it was made with texels */
};
struct aob_gpu_buffer {
    size_t size;
};
struct aob_gpu_program {
    uint64_t
        bindings;  /* bit n: it declares BIND(n), so a pass must bind it; AOB_GLSL_STORAGE: BIND_STORAGE */
    bool geometry; /* it has a vertex text */
};
struct aob_gpu_pass {
    size_t uniform_size; /* 0: it has no block */
    int height;          /* of its area */
    uint32_t vertex_count;
    bool in_parts;
    int64_t last_ns; /* wall time of its last run, as its share of a list's; 0: it never ran */
};

extern const struct aob_gpu_fns *const aob_gpu_backends[]; /* NULL-ended, in the order of `list backends` */
const struct aob_gpu_fns *aob_gpu_find(const char *name);  /* NULL if unknown */

/* All devices that a backend sees, and the number of its default: the first discrete one that lacks nothing, else
 * integrated, virtual, of a class that the API does not say, processor. gl-egl prefers the default of `vulkan`, and has none
 * where that is a GPU and EGL offers processors only: figures of a processor must not pass for a GPU's. `chosen` is the
 * count then, and list->none says why. False after a line: no driver. */
bool aob_gpu_devices(const struct aob_gpu_fns *fns, struct aob_gpu_device_list *list, size_t *chosen,
                     struct aob_error *error);

/* The number of the device that `wanted` means: its number, its whole name, or a part of it that no other device has, in
 * capitals or not. False after a line that names the devices there are, or says what the meant one lacks. */
bool aob_gpu_choose(const struct aob_gpu_device_list *list, const char *backend, const char *wanted,
                    size_t *chosen, struct aob_error *error);

/* NULL after one line that says what is missing (driver, loader, package). */
struct aob_gpu *aob_gpu_open(const char *backend, const struct aob_gpu_desc *desc, struct aob_error *error);
void aob_gpu_close(struct aob_gpu *gpu);

/* Whether the device has what such a texture, or such a pass, takes: its format, its size, as many images. False after a
 * line that says what it has. The pass's desc is a right one, but its program may be missing: on some drivers a program for
 * too many images cannot even be linked. aob_gpu_texture_create and aob_gpu_pass_create refuse with the same line; who asks
 * before knows that it is the device that lacks something. */
bool aob_gpu_texture_fits(const struct aob_gpu *gpu, const struct aob_gpu_texture_desc *desc,
                          struct aob_error *error);
bool aob_gpu_pass_fits(const struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc,
                       struct aob_error *error);

/* NULL after one line. A desc without a use, or with more levels than its size has, is refused. */
struct aob_gpu_texture *aob_gpu_texture_create(struct aob_gpu *gpu, const struct aob_gpu_texture_desc *desc,
                                               struct aob_error *error);
void aob_gpu_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture);

/* Writes the level's texels, aob_gpu_level_bytes of them, packed as those that a texture is made with. */
bool aob_gpu_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, int level, void *texels,
                          struct aob_error *error);

/* Gives a texture that was made with texels, of one level, others in their place: as many, packed alike. Between runs only, so it
 * is in no run's time; passes that bind the texture read the new ones. */
bool aob_gpu_texture_write(struct aob_gpu *gpu, struct aob_gpu_texture *texture, const void *texels,
                           struct aob_error *error);

/* Why passes of the device cannot write down what they do in a storage buffer: it "draws nothing"; NULL: they can. */
const char *aob_gpu_storage_lacks(const struct aob_gpu *gpu);

/* A storage buffer of undefined content: 1..info.storage_bytes bytes, a multiple of four. What runs wrote into it can be
 * read, what is written can be read by runs: between runs only. NULL after one line. */
struct aob_gpu_buffer *aob_gpu_buffer_create(struct aob_gpu *gpu, size_t size, struct aob_error *error);
void aob_gpu_buffer_destroy(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer);
bool aob_gpu_buffer_write(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                          const void *bytes, struct aob_error *error);
bool aob_gpu_buffer_read(struct aob_gpu *gpu, const struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                         void *bytes, struct aob_error *error);

/* A fragment program from whole GLSL 4.50 text (prelude included, with BIND(n) macros: see gpu/glsl.h), drawn
 * over the pass's area by one triangle. A compile error's first line, with its line number, is the reason. */
struct aob_gpu_program *aob_gpu_program_create(struct aob_gpu *gpu, const char *glsl,
                                               struct aob_error *error);

/* A program that draws triangles: its vertex text has no inputs but VERTEX_ID and its bindings, which both
 * texts share, and writes gl_Position (0 <= z <= w is seen; y = -w is the image's upper edge on every API).
 * Outputs of the one are inputs of the other by location. */
struct aob_gpu_program *aob_gpu_program_create_geometry(struct aob_gpu *gpu, const char *vertex,
                                                        const char *fragment, struct aob_error *error);

/* Either kind, by its desc. */
struct aob_gpu_program *aob_gpu_program_create_desc(struct aob_gpu *gpu,
                                                    const struct aob_gpu_program_desc *desc,
                                                    struct aob_error *error);
void aob_gpu_program_destroy(struct aob_gpu *gpu, struct aob_gpu_program *program);

/* A pass is made once and run many times. It may read other levels of a texture that it writes a level of,
 * never the same one. Its program and textures must outlive it; binds, targets and uniforms are copied. */
struct aob_gpu_pass *aob_gpu_pass_create(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc,
                                         struct aob_error *error);
void aob_gpu_pass_destroy(struct aob_gpu *gpu, struct aob_gpu_pass *pass);

/* The block that the next runs read, of the size that the pass was made with. Copied; between runs only, so it is
 * in no run's time. */
bool aob_gpu_pass_set_uniforms(struct aob_gpu *gpu, struct aob_gpu_pass *pass, const void *block, size_t size,
                               struct aob_error *error);

/* The part of a pass in_parts that the next runs draw; the rest of its targets keeps what it holds. Places in the image are
 * those of the whole, and the pass is not compiled again. */
bool aob_gpu_pass_set_part(struct aob_gpu *gpu, struct aob_gpu_pass *pass, const struct aob_gpu_part *part,
                           struct aob_error *error);

/* The list of passes, `repeats` times, complete on return; each pass sees what those before it wrote. The times are sums
 * over the repeats. `times`: one for each place in the list, or NULL; `whole`: or NULL.
 *
 * On a software device each pass is one submit and fence (or one draw and glFinish) and is timed by the host's clocks; the
 * whole is their sum. On any other device one submit holds the whole list, several times where that is short, because the
 * way to a GPU and back takes longer than a short pass: the device's clock times each pass and the whole list from its
 * begin to its end, and the host's clocks time the submits only. A submit is meant to take AOB_GPU_SUBMIT_NS at most, as
 * drivers stop what takes seconds; a list that is longer is a submit of its own. */
bool aob_gpu_run(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                 struct aob_gpu_time *whole, struct aob_error *error);
enum {
    AOB_GPU_SUBMIT_NS = 100000000,
    AOB_GPU_SUBMIT_MAX = 512, /* passes in a submit */
};

void aob_gpu_time_add(struct aob_gpu_time *sum, const struct aob_gpu_time *time);

/* A level's width or height in texels, from that of level 0: half of the one above, rounded down, at least 1. */
int aob_gpu_level_side(int side, int level);
size_t aob_gpu_level_bytes(const struct aob_gpu_texture *texture, int level);

size_t aob_gpu_texel_size(enum aob_format format);         /* bytes */
int aob_gpu_texel_components(enum aob_format format);      /* 1, 2 or 4 */
const char *aob_gpu_format_layout(enum aob_format format); /* GLSL image layout word: "r32f" */
#endif
