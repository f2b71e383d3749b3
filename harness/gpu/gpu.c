#include "gpu.h"
#include "backends.h"
#include "base/text.h"
#include "glsl.h"
#include <string.h>

enum { MAX_SIDE = 16384, MAX_UNIFORM_SIZE = 16384 };

const struct aob_gpu_fns *const aob_gpu_backends[] = {
    &aob_gpu_vulkan, &aob_gpu_gl_egl, &aob_gpu_gl_osmesa, &aob_gpu_null, NULL,
};

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
    if (!fns) {
        fail_unknown(backend, error);
        return NULL;
    }
    struct aob_gpu *gpu = fns->open(desc ? desc : &plain, error);
    if (gpu)
        gpu->lists = !gpu->info.software || (desc && desc->as_gpu);
    return gpu;
}

void aob_gpu_close(struct aob_gpu *gpu)
{
    if (gpu)
        gpu->fns->close(gpu);
}

static int most_levels(int width, int height)
{
    int levels = 1;
    for (int side = width > height ? width : height; side > 1; side >>= 1)
        levels++;
    return levels;
}

static bool check_texture(const char *name, const struct aob_gpu_texture_desc *desc, struct aob_error *error)
{
    const uint32_t known =
        AOB_GPU_USE_SAMPLED | AOB_GPU_USE_STORAGE | AOB_GPU_USE_TARGET | AOB_GPU_USE_READ_BACK;
    int width = desc->width, height = desc->height;
    if ((unsigned)desc->format >= AOB_FORMAT_COUNT)
        return aob_fail(error, "%s: texture format %d does not exist", name, (int)desc->format);
    if (width < 1 || height < 1 || width > MAX_SIDE || height > MAX_SIDE)
        return aob_fail(error, "%s: texture size %dx%d is outside 1..%d", name, width, height, MAX_SIDE);
    if (desc->levels < 0 || desc->levels > most_levels(width, height))
        return aob_fail(error, "%s: texture %dx%d with %d levels: this size has 1..%d", name, width, height,
                        desc->levels, most_levels(width, height));
    if (!desc->uses || desc->uses & ~known)
        return aob_fail(error, "%s: texture %dx%d with uses 0x%x: it must have some of AOB_GPU_USE_...", name,
                        width, height, desc->uses);
    return true;
}

struct aob_gpu_texture *aob_gpu_texture_create(struct aob_gpu *gpu, const struct aob_gpu_texture_desc *desc,
                                               struct aob_error *error)
{
    struct aob_gpu_texture *texture = NULL;
    if (check_texture(gpu->info.backend, desc, error) && aob_gpu_texture_fits(gpu, desc, error))
        gpu->fns->texture_create(gpu, desc, &texture, error);
    return texture;
}

void aob_gpu_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture)
{
    if (texture)
        gpu->fns->texture_destroy(gpu, texture);
}

bool aob_gpu_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, int level, void *texels,
                          struct aob_error *error)
{
    const char *name = gpu->info.backend;
    if (!(texture->uses & AOB_GPU_USE_READ_BACK))
        return aob_fail(error,
                        "%s: texture %dx%d was made without AOB_GPU_USE_READ_BACK, so it cannot be read",
                        name, texture->width, texture->height);
    if (level < 0 || level >= texture->levels)
        return aob_fail(error, "%s: texture %dx%d has no level %d to read: it has 0..%d", name,
                        texture->width, texture->height, level, texture->levels - 1);
    return gpu->fns->texture_read(gpu, texture, level, texels, error);
}

bool aob_gpu_texture_write(struct aob_gpu *gpu, struct aob_gpu_texture *texture, const void *texels,
                           struct aob_error *error)
{
    if (!texture->filled || texture->levels != 1)
        return aob_fail(error, "%s: write to a texture that was made without texels, or of %d levels",
                        gpu->info.backend, texture->levels);
    return gpu->fns->texture_write(gpu, texture, texels, error);
}

static int target_width(const struct aob_gpu_target *target)
{
    return aob_gpu_level_side(target->texture->width, target->level);
}

static int target_height(const struct aob_gpu_target *target)
{
    return aob_gpu_level_side(target->texture->height, target->level);
}

static bool check_target(const char *name, const struct aob_gpu_pass_desc *desc, size_t index,
                         struct aob_error *error)
{
    const struct aob_gpu_target *first = &desc->targets[0], *target = &desc->targets[index];
    if (!target->texture)
        return aob_fail(error, "%s: pass without a texture at target %zu", name, index);
    if (!(target->texture->uses & AOB_GPU_USE_TARGET))
        return aob_fail(error,
                        "%s: pass with a texture at target %zu that was made without AOB_GPU_USE_TARGET",
                        name, index);
    if (target->level < 0 || target->level >= target->texture->levels)
        return aob_fail(error, "%s: pass with level %d at target %zu: its texture has 0..%d", name,
                        target->level, index, target->texture->levels - 1);
    if (target_width(target) != target_width(first) || target_height(target) != target_height(first))
        return aob_fail(error, "%s: pass with targets of two sizes: %dx%d and %dx%d", name,
                        target_width(first), target_height(first), target_width(target),
                        target_height(target));
    for (size_t i = 0; i < index; i++)
        if (desc->targets[i].texture == target->texture) /* of one size, so it is the same level */
            return aob_fail(error, "%s: pass with one level at two targets, %zu and %zu", name, i, index);
    return true;
}

static bool check_targets(const char *name, const struct aob_gpu_pass_desc *desc, struct aob_error *error)
{
    if (desc->target_count < 1 || desc->target_count > AOB_MAX_OUT)
        return aob_fail(error, "%s: pass with %zu targets: there must be 1..%d", name, desc->target_count,
                        AOB_MAX_OUT);
    for (size_t i = 0; i < desc->target_count; i++)
        if (!check_target(name, desc, i, error))
            return false;
    int width = target_width(desc->targets), height = target_height(desc->targets);
    if (desc->width < 0 || desc->height < 0 || desc->width > width || desc->height > height)
        return aob_fail(error, "%s: pass with an area of %dx%d on targets of %dx%d: it must lie within them",
                        name, desc->width, desc->height, width, height);
    return true;
}

/* After the rest of the bind: which levels it shows. */
static bool check_levels(const char *name, const struct aob_gpu_pass_desc *desc,
                         const struct aob_gpu_bind *bind, struct aob_error *error)
{
    int first = bind->first_level, levels = bind->texture->levels;
    if (first < 0 || first >= levels || bind->level_count < 0 || bind->level_count > levels - first)
        return aob_fail(error, "%s: pass with %d levels from %d at binding %u: its texture has 0..%d", name,
                        bind->level_count, first, bind->binding, levels - 1);
    int count = aob_gpu_bind_levels(bind);
    if (bind->kind == AOB_GPU_STORAGE && count != 1)
        return aob_fail(error, "%s: pass with %d levels at binding %u: a storage image shows one", name,
                        count, bind->binding);
    for (size_t i = 0; i < desc->target_count; i++) {
        const struct aob_gpu_target *target = &desc->targets[i];
        if (target->texture == bind->texture && target->level >= first && target->level < first + count)
            return aob_fail(
                error, "%s: pass reads level %d of the texture at binding %u and writes it at target %zu",
                name, target->level, bind->binding, i);
    }
    return true;
}

static bool check_bind(const char *name, const struct aob_gpu_bind *bind, uint64_t earlier,
                       struct aob_error *error)
{
    static const char *const uses[] = {
        [AOB_GPU_SAMPLED] = "AOB_GPU_USE_SAMPLED", [AOB_GPU_STORAGE] = "AOB_GPU_USE_STORAGE"};
    if (bind->binding < 1 || bind->binding > AOB_GPU_MAX_BINDING)
        return aob_fail(error, "%s: pass with binding %u: it must be 1..%d", name, bind->binding,
                        AOB_GPU_MAX_BINDING);
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
    uint32_t use = bind->kind == AOB_GPU_SAMPLED ? AOB_GPU_USE_SAMPLED : AOB_GPU_USE_STORAGE;
    return bind->texture->uses & use ||
           aob_fail(error, "%s: pass with a texture at binding %u that was made without %s", name,
                    bind->binding, uses[bind->kind]);
}

static bool check_bindings(const char *name, const struct aob_gpu_pass_desc *desc, struct aob_error *error)
{
    uint64_t bound = desc->storage ? AOB_GPU_STORAGE_BIT : 0;
    if (!desc->uniforms != !desc->uniform_size || desc->uniform_size > MAX_UNIFORM_SIZE)
        return aob_fail(error, "%s: pass with a uniform block of %zu bytes%s: it must have 1..%d, or be none",
                        name, desc->uniform_size, desc->uniforms ? "" : " at NULL", MAX_UNIFORM_SIZE);
    if (desc->uniforms)
        bound |= 1;
    for (size_t i = 0; i < desc->bind_count; i++) {
        if (!check_bind(name, &desc->binds[i], bound, error) ||
            !check_levels(name, desc, &desc->binds[i], error))
            return false;
        bound |= (uint64_t)1 << desc->binds[i].binding;
    }
    uint64_t unbound = desc->program->bindings & ~bound;
    if (unbound & AOB_GPU_STORAGE_BIT)
        return aob_fail(error, "%s: pass without a storage buffer, which its program declares", name);
    if (unbound)
        return aob_fail(error, "%s: pass binds nothing at %d, which its program declares", name,
                        __builtin_ctzll(unbound));
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

static struct aob_gpu_pass *create_pass(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc,
                                        struct aob_error *error)
{
    struct aob_gpu_pass_desc whole = *desc;
    struct aob_gpu_pass *pass = NULL;
    whole.width = desc->width ? desc->width : target_width(desc->targets);
    whole.height = desc->height ? desc->height : target_height(desc->targets);
    if (!gpu->fns->pass_create(gpu, &whole, &pass, error))
        return NULL;
    pass->uniform_size = desc->uniform_size;
    pass->height = whole.height;
    pass->vertex_count = desc->vertex_count;
    pass->in_parts = desc->in_parts;
    return pass;
}

struct aob_gpu_pass *aob_gpu_pass_create(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc,
                                         struct aob_error *error)
{
    const char *name = gpu->info.backend;
    if (!desc->program)
        aob_fail(error, "%s: pass without a program", name);
    else if (check_targets(name, desc, error) && check_bindings(name, desc, error) &&
             check_geometry(name, desc, error) && aob_gpu_pass_fits(gpu, desc, error))
        return create_pass(gpu, desc, error);
    return NULL;
}

void aob_gpu_pass_destroy(struct aob_gpu *gpu, struct aob_gpu_pass *pass)
{
    if (pass)
        gpu->fns->pass_destroy(gpu, pass);
}

bool aob_gpu_pass_set_uniforms(struct aob_gpu *gpu, struct aob_gpu_pass *pass, const void *block, size_t size,
                               struct aob_error *error)
{
    if (!size || size != pass->uniform_size)
        return aob_fail(error, "%s: uniform block of %zu bytes for a pass that was made with %zu",
                        gpu->info.backend, size, pass->uniform_size);
    return gpu->fns->pass_set_uniforms(gpu, pass, block, error);
}

static bool check_part(const char *name, const struct aob_gpu_pass *pass, const struct aob_gpu_part *part,
                       struct aob_error *error)
{
    if (!pass->in_parts)
        return aob_fail(error, "%s: part of a pass that was made without in_parts", name);
    if (part->row < 0 || part->rows < 0 || part->row > pass->height - part->rows)
        return aob_fail(error, "%s: part of %d rows from %d: the pass has %d", name, part->rows, part->row,
                        pass->height);
    if (part->first_vertex % 3 || part->vertex_count % 3 || part->vertex_count > pass->vertex_count ||
        part->first_vertex > pass->vertex_count - part->vertex_count)
        return aob_fail(error, "%s: part of %u vertices from %u: the pass has %u, three a triangle", name,
                        part->vertex_count, part->first_vertex, pass->vertex_count);
    return true;
}

bool aob_gpu_pass_set_part(struct aob_gpu *gpu, struct aob_gpu_pass *pass, const struct aob_gpu_part *part,
                           struct aob_error *error)
{
    struct aob_gpu_part whole = *part;
    if (!check_part(gpu->info.backend, pass, part, error))
        return false;
    whole.rows = part->rows ? part->rows : pass->height - part->row;
    whole.vertex_count = part->vertex_count ? part->vertex_count : pass->vertex_count - part->first_vertex;
    gpu->fns->pass_set_part(pass, &whole);
    return true;
}
