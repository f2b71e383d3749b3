#include "gpu.h"
#include "backends.h"
#include "base/text.h"
#include <string.h>

enum { MAX_BINDING = 15, MAX_SIDE = 16384, MAX_UNIFORM_SIZE = 16384 };

const struct aob_gpu_fns *const aob_gpu_backends[] = {
    &aob_gpu_vulkan, &aob_gpu_gl_egl, &aob_gpu_gl_osmesa, &aob_gpu_null, NULL,
};

static const struct {
    size_t size;
    int components;
    const char *layout;
} formats[AOB_FORMAT_COUNT] = {
    [AOB_R8] = {1, 1, "r8"},           [AOB_R16] = {2, 1, "r16"},
    [AOB_R16F] = {2, 1, "r16f"},       [AOB_R32F] = {4, 1, "r32f"},
    [AOB_RG8] = {2, 2, "rg8"},         [AOB_RG16F] = {4, 2, "rg16f"},
    [AOB_RG32F] = {8, 2, "rg32f"},     [AOB_RGBA8] = {4, 4, "rgba8"},
    [AOB_RGBA16F] = {8, 4, "rgba16f"}, [AOB_RGBA32F] = {16, 4, "rgba32f"},
};

size_t aob_gpu_texel_size(enum aob_format format)
{
    return formats[format].size;
}

int aob_gpu_texel_components(enum aob_format format)
{
    return formats[format].components;
}

const char *aob_gpu_format_layout(enum aob_format format)
{
    return formats[format].layout;
}

const struct aob_gpu_fns *aob_gpu_find(const char *name)
{
    for (const struct aob_gpu_fns *const *fns = aob_gpu_backends; *fns; fns++)
        if (!strcmp((*fns)->name, name))
            return *fns;
    return NULL;
}

static void fail_unknown(const char *name, struct aob_error *error)
{
    struct aob_text known = {0};
    for (const struct aob_gpu_fns *const *fns = aob_gpu_backends; *fns; fns++)
        aob_text_add(&known, "%s%s", known.size ? ", " : "", (*fns)->name);
    aob_fail(error, "backend '%s' is unknown: use one of %s", name, known.data);
    aob_text_finish(&known);
}

struct aob_gpu *aob_gpu_open(const char *backend, const struct aob_gpu_desc *desc, struct aob_error *error)
{
    static const struct aob_gpu_desc plain;
    const struct aob_gpu_fns *fns = aob_gpu_find(backend);
    if (fns)
        return fns->open(desc ? desc : &plain, error);
    fail_unknown(backend, error);
    return NULL;
}

void aob_gpu_close(struct aob_gpu *gpu)
{
    if (gpu)
        gpu->fns->close(gpu);
}

struct aob_gpu_texture *aob_gpu_texture_create(struct aob_gpu *gpu, enum aob_format format, int width,
                                               int height, const void *texels, struct aob_error *error)
{
    const char *name = gpu->info.backend;
    struct aob_gpu_texture *texture = NULL;
    if ((unsigned)format >= AOB_FORMAT_COUNT)
        aob_fail(error, "%s: texture format %d does not exist", name, (int)format);
    else if (width < 1 || height < 1 || width > MAX_SIDE || height > MAX_SIDE)
        aob_fail(error, "%s: texture size %dx%d is outside 1..%d", name, width, height, MAX_SIDE);
    else
        gpu->fns->texture_create(gpu, format, width, height, texels, &texture, error);
    return texture;
}

void aob_gpu_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture)
{
    if (texture)
        gpu->fns->texture_destroy(gpu, texture);
}

bool aob_gpu_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, void *texels,
                          struct aob_error *error)
{
    return gpu->fns->texture_read(gpu, texture, texels, error);
}

struct aob_gpu_program *aob_gpu_program_create(struct aob_gpu *gpu, const char *glsl, struct aob_error *error)
{
    struct aob_gpu_program *program = NULL;
    gpu->fns->program_create(gpu, NULL, glsl, &program, error);
    return program;
}

struct aob_gpu_program *aob_gpu_program_create_geometry(struct aob_gpu *gpu, const char *vertex,
                                                        const char *fragment, struct aob_error *error)
{
    struct aob_gpu_program *program = NULL;
    if (gpu->fns->program_create(gpu, vertex, fragment, &program, error))
        program->geometry = true;
    return program;
}

void aob_gpu_program_destroy(struct aob_gpu *gpu, struct aob_gpu_program *program)
{
    if (program)
        gpu->fns->program_destroy(gpu, program);
}

static bool is_target(const struct aob_gpu_pass_desc *desc, size_t count,
                      const struct aob_gpu_texture *texture)
{
    for (size_t i = 0; i < count; i++)
        if (desc->targets[i] == texture)
            return true;
    return false;
}

static bool check_targets(const char *name, const struct aob_gpu_pass_desc *desc, struct aob_error *error)
{
    if (desc->target_count < 1 || desc->target_count > AOB_MAX_OUT)
        return aob_fail(error, "%s: pass with %zu targets: there must be 1..%d", name, desc->target_count,
                        AOB_MAX_OUT);
    for (size_t i = 0; i < desc->target_count; i++) {
        const struct aob_gpu_texture *first = desc->targets[0], *target = desc->targets[i];
        if (!target)
            return aob_fail(error, "%s: pass without a texture at target %zu", name, i);
        if (target->width != first->width || target->height != first->height)
            return aob_fail(error, "%s: pass with targets of two sizes: %dx%d and %dx%d", name, first->width,
                            first->height, target->width, target->height);
        if (is_target(desc, i, target))
            return aob_fail(error, "%s: pass with one texture at two targets, the second %zu", name, i);
    }
    return true;
}

static bool check_bind(const char *name, const struct aob_gpu_pass_desc *desc,
                       const struct aob_gpu_bind *bind, uint32_t earlier, struct aob_error *error)
{
    if (bind->binding < 1 || bind->binding > MAX_BINDING)
        return aob_fail(error, "%s: pass with binding %u: it must be 1..%d", name, bind->binding,
                        MAX_BINDING);
    if (earlier >> bind->binding & 1)
        return aob_fail(error, "%s: pass with two textures at binding %u", name, bind->binding);
    if (!bind->texture)
        return aob_fail(error, "%s: pass without a texture at binding %u", name, bind->binding);
    if (bind->kind != AOB_GPU_SAMPLED && bind->kind != AOB_GPU_STORAGE)
        return aob_fail(error, "%s: pass with an unknown kind %d at binding %u", name, (int)bind->kind,
                        bind->binding);
    if (bind->filter != AOB_NEAREST && bind->filter != AOB_BILINEAR)
        return aob_fail(error, "%s: pass with an unknown filter %d at binding %u", name, (int)bind->filter,
                        bind->binding);
    if (is_target(desc, desc->target_count, bind->texture))
        return aob_fail(error, "%s: pass reads and writes the texture at binding %u", name, bind->binding);
    return true;
}

static bool check_bindings(const char *name, const struct aob_gpu_pass_desc *desc, struct aob_error *error)
{
    uint32_t bound = 0;
    if (!desc->uniforms != !desc->uniform_size || desc->uniform_size > MAX_UNIFORM_SIZE)
        return aob_fail(error, "%s: pass with a uniform block of %zu bytes%s: it must have 1..%d, or be none",
                        name, desc->uniform_size, desc->uniforms ? "" : " at NULL", MAX_UNIFORM_SIZE);
    if (desc->uniforms)
        bound |= 1;
    for (size_t i = 0; i < desc->bind_count; i++) {
        if (!check_bind(name, desc, &desc->binds[i], bound, error))
            return false;
        bound |= 1u << desc->binds[i].binding;
    }
    uint32_t unbound = desc->program->bindings & ~bound;
    if (unbound)
        return aob_fail(error, "%s: pass binds nothing at %d, which its program declares", name,
                        __builtin_ctz(unbound));
    return true;
}

static bool check_geometry(const char *name, const struct aob_gpu_pass_desc *desc, struct aob_error *error)
{
    if (!desc->program->geometry)
        return (!desc->vertex_count && !desc->depth_test && desc->blend == AOB_GPU_REPLACE) ||
               aob_fail(error,
                        "%s: pass with vertices, depth or blending, but its program has no vertex text",
                        name);
    if (!desc->vertex_count || desc->vertex_count % 3 || desc->vertex_count > INT32_MAX)
        return aob_fail(error, "%s: pass with %u vertices: it must have three a triangle, and one triangle",
                        name, desc->vertex_count);
    return desc->blend == AOB_GPU_REPLACE || desc->blend == AOB_GPU_ADD ||
           aob_fail(error, "%s: pass with an unknown blend %d", name, (int)desc->blend);
}

struct aob_gpu_pass *aob_gpu_pass_create(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc,
                                         struct aob_error *error)
{
    const char *name = gpu->info.backend;
    struct aob_gpu_pass *pass = NULL;
    if (!desc->program)
        aob_fail(error, "%s: pass without a program", name);
    else if (check_targets(name, desc, error) && check_bindings(name, desc, error) &&
             check_geometry(name, desc, error))
        gpu->fns->pass_create(gpu, desc, &pass, error);
    return pass;
}

void aob_gpu_pass_destroy(struct aob_gpu *gpu, struct aob_gpu_pass *pass)
{
    if (pass)
        gpu->fns->pass_destroy(gpu, pass);
}

bool aob_gpu_pass_run(struct aob_gpu *gpu, struct aob_gpu_pass *pass, struct aob_gpu_time *time,
                      struct aob_error *error)
{
    struct aob_gpu_time unwanted;
    return gpu->fns->pass_run(gpu, pass, time ? time : &unwanted, error);
}
