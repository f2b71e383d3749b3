#include "gpu.h"
#include "base/memory.h"

const struct aob_gpu_limits aob_gpu_no_limits = {.side = UINT32_MAX,
                                                 .targets = UINT32_MAX,
                                                 .sampled = UINT32_MAX,
                                                 .storage = UINT32_MAX,
                                                 .vertex_sampled = UINT32_MAX,
                                                 .vertex_storage = UINT32_MAX,
                                                 .storage_bindings = UINT32_MAX,
                                                 .resources = UINT32_MAX,
                                                 .storage_and_targets = UINT32_MAX};

static bool has_format(const struct aob_gpu *gpu, enum aob_format format, uint32_t needs,
                       struct aob_error *error)
{
    const char *lacks = gpu->fns->format_lacks(gpu, format, needs);
    return !lacks || aob_fail(error, "%s: %s has no %s of format %s: use another device or backend",
                              gpu->info.backend, gpu->info.device, lacks, aob_gpu_format_layout(format));
}

bool aob_gpu_texture_fits(const struct aob_gpu *gpu, const struct aob_gpu_texture_desc *desc,
                          struct aob_error *error)
{
    uint32_t side = (uint32_t)(desc->width > desc->height ? desc->width : desc->height);
    if (side > gpu->limits.side)
        return aob_fail(error, "%s: texture size %dx%d: %s has %u at most: use a smaller view",
                        gpu->info.backend, desc->width, desc->height, gpu->info.device, gpu->limits.side);
    return has_format(gpu, desc->format, desc->uses, error);
}

struct counts {
    uint32_t sampled, storage, vertex_sampled, vertex_storage; /* vertex: that the vertex text has too */
    uint32_t bindings; /* bindings: one beyond the last of the storage images */
};

static struct counts count_binds(const struct aob_gpu_pass_desc *desc)
{
    struct counts counts = {0};
    for (size_t i = 0; i < desc->bind_count; i++) {
        const struct aob_gpu_bind *bind = &desc->binds[i];
        bool vertex = desc->vertex_count && bind->vertex;
        counts.sampled += bind->kind == AOB_GPU_SAMPLED;
        counts.storage += bind->kind == AOB_GPU_STORAGE;
        counts.vertex_sampled += vertex && bind->kind == AOB_GPU_SAMPLED;
        counts.vertex_storage += vertex && bind->kind == AOB_GPU_STORAGE;
        if (bind->kind == AOB_GPU_STORAGE && bind->binding >= counts.bindings)
            counts.bindings = bind->binding + 1;
    }
    return counts;
}

static bool has_enough(const struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc,
                       struct aob_error *error)
{
    static const char sampled[] = "use sampled reads, or another device or backend",
                      other[] = "use another device or backend";
    const struct aob_gpu_limits *limits = &gpu->limits;
    const struct counts counts = count_binds(desc);
    const uint32_t targets = (uint32_t)desc->target_count;
    const uint32_t buffers = desc->storage ? 1 : 0;
    const struct {
        const char *what;
        uint32_t count, most;
        const char *cure;
    } rows[] = {
        {"targets", targets, limits->targets, other},
        {"sampled textures", counts.sampled, limits->sampled, other},
        {"storage images", counts.storage, limits->storage, sampled},
        {"sampled textures in its vertex text", counts.vertex_sampled, limits->vertex_sampled, other},
        {"storage images in its vertex text", counts.vertex_storage, limits->vertex_storage, sampled},
        {"bindings up to its last storage image", counts.bindings, limits->storage_bindings, sampled},
        {"storage images, buffers and targets", counts.storage + buffers + targets,
         limits->storage_and_targets, sampled},
        {"textures, targets, buffers and uniform blocks",
         counts.sampled + counts.storage + buffers + targets + (desc->uniforms ? 1 : 0), limits->resources,
         other},
    };
    for (size_t i = 0; i < AOB_COUNT(rows); i++)
        if (rows[i].count > rows[i].most)
            return aob_fail(error, "%s: pass with %u %s: %s has %u at most: %s", gpu->info.backend,
                            rows[i].count, rows[i].what, gpu->info.device, rows[i].most, rows[i].cure);
    return true;
}

bool aob_gpu_pass_fits(const struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc,
                       struct aob_error *error)
{
    if (!has_enough(gpu, desc, error))
        return false;
    for (size_t i = 0; i < desc->bind_count; i++)
        if (desc->binds[i].kind == AOB_GPU_SAMPLED && desc->binds[i].filter == AOB_BILINEAR &&
            !has_format(gpu, desc->binds[i].texture->format, AOB_GPU_NEED_FILTER, error))
            return false;
    for (size_t i = 0; desc->blend == AOB_GPU_ADD && i < desc->target_count; i++)
        if (!has_format(gpu, desc->targets[i].texture->format, AOB_GPU_NEED_BLEND, error))
            return false;
    return !desc->depth_test || !gpu->limits.lacks_depth ||
           aob_fail(error, "%s: %s has no 32-bit float depth: use another device or backend",
                    gpu->info.backend, gpu->info.device);
}
