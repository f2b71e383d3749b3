#include "gpu/backends.h"
#include "base/memory.h"
#include "gpu/glsl.h"
#include <stdlib.h>
#include <string.h>

enum { NS_PER_TEXEL = 100 };

struct null_texture {
    struct aob_gpu_texture base;
    size_t size;
    unsigned char texels[];
};

struct aob_gpu_pass {
    struct null_texture *targets[AOB_MAX_OUT];
    size_t target_count;
};

static struct null_texture *null_texture(const struct aob_gpu_texture *texture)
{
    return (struct null_texture *)texture;
}

static struct aob_gpu *null_open(const struct aob_gpu_desc *desc, struct aob_error *error)
{
    (void)desc;
    (void)error;
    struct aob_gpu *gpu = AOB_NEW(struct aob_gpu);
    gpu->fns = &aob_gpu_null;
    gpu->info = (struct aob_gpu_info){.backend = aob_gpu_null.name,
                                      .device = "none",
                                      .driver = "none",
                                      .software = true,
                                      .draws_nothing = true};
    return gpu;
}

static void null_close(struct aob_gpu *gpu)
{
    free(gpu);
}

static bool null_texture_create(struct aob_gpu *gpu, enum aob_format format, int width, int height,
                                const void *texels, struct aob_gpu_texture **texture, struct aob_error *error)
{
    (void)gpu;
    (void)error;
    size_t size = (size_t)width * (size_t)height * aob_gpu_texel_size(format);
    struct null_texture *made = aob_alloc(sizeof *made + size, 1);
    made->base = (struct aob_gpu_texture){.format = format, .width = width, .height = height};
    made->size = size;
    if (texels)
        memcpy(made->texels, texels, size);
    *texture = &made->base;
    return true;
}

static void null_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture)
{
    (void)gpu;
    free(null_texture(texture));
}

static bool null_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, void *texels,
                              struct aob_error *error)
{
    (void)gpu;
    (void)error;
    memcpy(texels, null_texture(texture)->texels, null_texture(texture)->size);
    return true;
}

static bool add_bindings(const char *text, enum aob_glsl_stage stage, uint32_t *bindings,
                         struct aob_error *error)
{
    size_t count;
    uint32_t *words = aob_glsl_compile(text, stage, AOB_GLSL_VULKAN, &count, error);
    if (!words)
        return aob_fail_in(error, "%s", aob_gpu_null.name);
    *bindings |= aob_glsl_bindings(words, count);
    free(words);
    return true;
}

static bool null_program_create(struct aob_gpu *gpu, const char *vertex, const char *fragment,
                                struct aob_gpu_program **program, struct aob_error *error)
{
    (void)gpu;
    uint32_t bindings = 0;
    if ((vertex && !add_bindings(vertex, AOB_GLSL_VERTEX, &bindings, error)) ||
        !add_bindings(fragment, AOB_GLSL_FRAGMENT, &bindings, error))
        return false;
    *program = AOB_NEW(struct aob_gpu_program);
    (*program)->bindings = bindings;
    return true;
}

static void null_program_destroy(struct aob_gpu *gpu, struct aob_gpu_program *program)
{
    (void)gpu;
    free(program);
}

static bool null_pass_create(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc,
                             struct aob_gpu_pass **pass, struct aob_error *error)
{
    (void)gpu;
    (void)error;
    *pass = AOB_NEW(struct aob_gpu_pass);
    (*pass)->target_count = desc->target_count;
    for (size_t i = 0; i < desc->target_count; i++)
        (*pass)->targets[i] = null_texture(desc->targets[i]);
    return true;
}

static void null_pass_destroy(struct aob_gpu *gpu, struct aob_gpu_pass *pass)
{
    (void)gpu;
    free(pass);
}

static bool null_pass_run(struct aob_gpu *gpu, struct aob_gpu_pass *pass, struct aob_gpu_time *time,
                          struct aob_error *error)
{
    (void)gpu;
    (void)error;
    int64_t texels = 0;
    for (size_t i = 0; i < pass->target_count; i++) {
        struct null_texture *target = pass->targets[i];
        memset(target->texels, 0, target->size);
        texels += (int64_t)target->base.width * target->base.height;
    }
    time->wall_ns = time->cpu_ns = texels * NS_PER_TEXEL;
    return true;
}

static const char *const no_environment[] = {NULL};

const struct aob_gpu_fns aob_gpu_null = {
    .name = "null",
    .title = "no GPU: compiles shaders, runs none; images are zero and times made up",
    .environment = no_environment,
    .open = null_open,
    .close = null_close,
    .texture_create = null_texture_create,
    .texture_destroy = null_texture_destroy,
    .texture_read = null_texture_read,
    .program_create = null_program_create,
    .program_destroy = null_program_destroy,
    .pass_create = null_pass_create,
    .pass_destroy = null_pass_destroy,
    .pass_run = null_pass_run,
};
