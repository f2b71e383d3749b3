#include "gpu/backends.h"
#include "base/memory.h"
#include <stdlib.h>
#include <string.h>

enum { NS_PER_TEXEL = 100, STORAGE_BYTES = 128 << 20 };

struct null_texture {
    struct aob_gpu_texture base;
    unsigned char texels[]; /* a level after the other */
};

struct null_pass {
    struct aob_gpu_pass base;
    struct aob_gpu_target targets[AOB_MAX_OUT];
    size_t target_count;
    int width, row, rows;
};

struct null_buffer {
    struct aob_gpu_buffer base;
    unsigned char bytes[];
};

static struct null_texture *null_texture(const struct aob_gpu_texture *texture)
{
    return (struct null_texture *)texture;
}

static struct aob_gpu *null_open(const struct aob_gpu_desc *desc, struct aob_error *error)
{
    struct aob_gpu *gpu = AOB_NEW(struct aob_gpu);
    gpu->fns = &aob_gpu_null;
    gpu->info = (struct aob_gpu_info){.backend = aob_gpu_null.name,
                                      .device = "none",
                                      .driver = "none",
                                      .device_class = "cpu",
                                      .software = true,
                                      .timer = true,
                                      .draws_nothing = true,
                                      .storage_bytes = STORAGE_BYTES};
    gpu->limits = aob_gpu_no_limits;
    return aob_gpu_keep_single(gpu, desc, error);
}

static bool null_devices(struct aob_gpu_device_list *list, size_t *chosen, struct aob_error *error)
{
    return aob_gpu_single_device(&aob_gpu_null, list, chosen, error);
}

static void null_close(struct aob_gpu *gpu)
{
    free(gpu);
}

static const char *null_format_lacks(const struct aob_gpu *gpu, enum aob_format format, uint32_t needs)
{
    (void)gpu;
    (void)format;
    (void)needs;
    return NULL;
}

static size_t level_offset(const struct aob_gpu_texture *texture, int level)
{
    size_t offset = 0;
    for (int above = 0; above < level; above++)
        offset += aob_gpu_level_bytes(texture, above);
    return offset;
}

static bool null_texture_create(struct aob_gpu *gpu, const struct aob_gpu_texture_desc *desc,
                                struct aob_gpu_texture **texture, struct aob_error *error)
{
    (void)gpu;
    (void)error;
    struct aob_gpu_texture base = aob_gpu_texture_base(desc);
    struct null_texture *made = aob_alloc(sizeof *made + level_offset(&base, base.levels), 1);
    made->base = base;
    if (desc->texels)
        memcpy(made->texels, desc->texels, aob_gpu_level_bytes(&base, 0));
    *texture = &made->base;
    return true;
}

static void null_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture)
{
    (void)gpu;
    free(null_texture(texture));
}

static bool null_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, int level,
                              void *texels, struct aob_error *error)
{
    (void)gpu;
    (void)error;
    memcpy(texels, null_texture(texture)->texels + level_offset(texture, level),
           aob_gpu_level_bytes(texture, level));
    return true;
}

static bool null_texture_write(struct aob_gpu *gpu, struct aob_gpu_texture *texture, const void *texels,
                               struct aob_error *error)
{
    (void)gpu;
    (void)error;
    memcpy(null_texture(texture)->texels, texels, aob_gpu_level_bytes(texture, 0));
    return true;
}

static bool null_buffer_create(struct aob_gpu *gpu, size_t size, struct aob_gpu_buffer **buffer,
                               struct aob_error *error)
{
    (void)gpu;
    (void)error;
    struct null_buffer *made = aob_alloc(sizeof *made + size, 1);
    *buffer = &made->base;
    return true;
}

static void null_buffer_destroy(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer)
{
    (void)gpu;
    free(buffer);
}

static bool null_buffer_write(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                              const void *bytes, struct aob_error *error)
{
    (void)gpu;
    (void)error;
    memcpy(((struct null_buffer *)buffer)->bytes + offset, bytes, size);
    return true;
}

static bool null_buffer_read(struct aob_gpu *gpu, const struct aob_gpu_buffer *buffer, size_t offset,
                             size_t size, void *bytes, struct aob_error *error)
{
    (void)gpu;
    (void)error;
    memcpy(bytes, ((const struct null_buffer *)buffer)->bytes + offset, size);
    return true;
}

static bool add_bindings(const struct aob_gpu_program_desc *desc, enum aob_glsl_stage stage,
                         uint64_t *bindings, struct aob_error *error)
{
    size_t count;
    uint32_t *words = aob_gpu_program_words(desc, stage, AOB_GLSL_VULKAN, &count, bindings, error);
    free(words);
    return words || aob_fail_in(error, "%s", aob_gpu_null.name);
}

static bool null_program_create(struct aob_gpu *gpu, const struct aob_gpu_program_desc *desc,
                                struct aob_gpu_program **program, struct aob_error *error)
{
    (void)gpu;
    uint64_t bindings = 0;
    if ((desc->vertex && !add_bindings(desc, AOB_GLSL_VERTEX, &bindings, error)) ||
        !add_bindings(desc, AOB_GLSL_FRAGMENT, &bindings, error))
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
    struct null_pass *made = AOB_NEW(struct null_pass);
    made->target_count = desc->target_count;
    for (size_t i = 0; i < desc->target_count; i++)
        made->targets[i] = desc->targets[i];
    made->width = desc->width;
    made->rows = desc->height;
    *pass = &made->base;
    return true;
}

static void null_pass_destroy(struct aob_gpu *gpu, struct aob_gpu_pass *pass)
{
    (void)gpu;
    free(pass);
}

static bool null_pass_set_uniforms(struct aob_gpu *gpu, struct aob_gpu_pass *pass, const void *block,
                                   struct aob_error *error)
{
    (void)gpu;
    (void)pass;
    (void)block;
    (void)error;
    return true;
}

static void null_pass_set_part(struct aob_gpu_pass *base, const struct aob_gpu_part *part)
{
    struct null_pass *pass = (struct null_pass *)base;
    pass->row = part->row;
    pass->rows = part->rows;
}

static void clear_area(const struct aob_gpu_target *target, const struct null_pass *pass)
{
    const struct aob_gpu_texture *texture = target->texture;
    size_t texel = aob_gpu_texel_size(texture->format);
    size_t row = (size_t)aob_gpu_level_side(texture->width, target->level) * texel;
    unsigned char *texels = null_texture(texture)->texels + level_offset(texture, target->level);
    for (int y = pass->row; y < pass->row + pass->rows; y++)
        memset(texels + (size_t)y * row, 0, (size_t)pass->width * texel);
}

static int64_t run_pass(const struct null_pass *pass)
{
    for (size_t i = 0; i < pass->target_count; i++)
        clear_area(&pass->targets[i], pass);
    return (int64_t)pass->target_count * pass->width * pass->rows * NS_PER_TEXEL;
}

static bool null_run(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                     struct aob_gpu_time *whole, struct aob_error *error)
{
    (void)error;
    for (size_t i = 0; i < desc->count; i++) {
        int64_t ns = run_pass((const struct null_pass *)desc->passes[i]) * desc->repeats;
        whole->wall_ns += ns;
        whole->cpu_ns += ns;
        times[i].device_ns += gpu->lists ? ns : 0;
        whole->device_ns += gpu->lists ? ns : 0;
    }
    return true;
}

static const char *const no_environment[] = {NULL};

const struct aob_gpu_fns aob_gpu_null = {
    .name = "null",
    .title = "no GPU: compiles shaders, runs none; images are zero and times made up",
    .environment = no_environment,
    .devices = null_devices,
    .open = null_open,
    .close = null_close,
    .format_lacks = null_format_lacks,
    .texture_create = null_texture_create,
    .texture_destroy = null_texture_destroy,
    .texture_read = null_texture_read,
    .texture_write = null_texture_write,
    .buffer_create = null_buffer_create,
    .buffer_destroy = null_buffer_destroy,
    .buffer_write = null_buffer_write,
    .buffer_read = null_buffer_read,
    .program_create = null_program_create,
    .program_destroy = null_program_destroy,
    .pass_create = null_pass_create,
    .pass_destroy = null_pass_destroy,
    .pass_set_uniforms = null_pass_set_uniforms,
    .pass_set_part = null_pass_set_part,
    .run = null_run,
};
