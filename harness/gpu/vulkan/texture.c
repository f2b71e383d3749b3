#include "vk.h"
#include "base/memory.h"
#include "gpu/backends.h"
#include <stdlib.h>
#include <string.h>

const char *aob_vk_lacks(const struct aob_gpu *gpu, enum aob_format format, uint32_t needs)
{
    const struct vk *vk = (const struct vk *)gpu;
    VkFormatProperties can;
    vkGetPhysicalDeviceFormatProperties(vk->physical, aob_vk_format(format), &can);
    return aob_vk_format_lacks(format, needs, can.optimalTilingFeatures, vk->extended_storage);
}

static VkBufferImageCopy whole_level(const struct aob_gpu_texture *texture, int level)
{
    return (VkBufferImageCopy){
        .imageSubresource = {.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT,
                             .mipLevel = (uint32_t)level,
                             .layerCount = 1},
        .imageExtent = {(uint32_t)aob_gpu_level_side(texture->width, level),
                        (uint32_t)aob_gpu_level_side(texture->height, level), 1},
    };
}

static void record_move(struct vk *vk, const struct vk_texture *texture, VkImageSubresourceRange range,
                        struct vk_state from, struct vk_state to)
{
    VkImageMemoryBarrier2 move = aob_vk_move(texture->image.image, range, from, to);
    aob_vk_record_moves(vk->commands, &move, 1);
}

static void record_upload(struct vk *vk, const struct vk_texture *texture, VkBuffer texels)
{
    VkImageSubresourceRange all = aob_vk_levels(0, texture->base.levels);
    struct vk_state from = {VK_IMAGE_LAYOUT_UNDEFINED, VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE};
    VkBufferImageCopy region = whole_level(&texture->base, 0);
    if (texels) {
        record_move(vk, texture, all, from, aob_vk_copied_to);
        from = aob_vk_copied_to;
        vkCmdCopyBufferToImage(vk->commands, texels, texture->image.image, from.layout, 1, &region);
    }
    record_move(vk, texture, all, from, texture->rest);
}

static bool upload(struct vk *vk, const struct vk_texture *texture, const void *texels,
                   struct aob_error *error)
{
    struct vk_buffer staging = {0};
    if (texels) {
        size_t size = aob_gpu_level_bytes(&texture->base, 0);
        if (!aob_vk_buffer_init(vk, size, VK_MEMORY_UPLOAD, &staging, error))
            return false;
        memcpy(staging.map, texels, size);
    }
    bool good = aob_vk_begin(vk, error);
    if (good) {
        record_upload(vk, texture, staging.buffer);
        good = aob_vk_finish(vk, NULL, error);
    }
    aob_vk_buffer_finish(vk, &staging);
    return good;
}

bool aob_vk_texture_write(struct aob_gpu *gpu, struct aob_gpu_texture *texture, const void *texels,
                          struct aob_error *error)
{
    return upload((struct vk *)gpu, (const struct vk_texture *)texture, texels, error);
}

bool aob_vk_texture_create(struct aob_gpu *gpu, const struct aob_gpu_texture_desc *desc,
                           struct aob_gpu_texture **texture, struct aob_error *error)
{
    struct vk *vk = (struct vk *)gpu;
    struct vk_texture *made = AOB_NEW(struct vk_texture);
    made->base = aob_gpu_texture_base(desc);
    made->rest = aob_vk_rest(desc->uses);
    const struct vk_image_desc image = {.format = aob_vk_format(desc->format),
                                        .width = desc->width,
                                        .height = desc->height,
                                        .levels = made->base.levels,
                                        .usage = aob_vk_usage(desc->uses, desc->texels)};
    if (aob_vk_image_init(vk, &image, &made->image, error) && upload(vk, made, desc->texels, error)) {
        *texture = &made->base;
        return true;
    }
    aob_vk_texture_destroy(gpu, &made->base);
    return aob_fail_in(error, "texture %dx%d %s", desc->width, desc->height,
                       aob_gpu_format_layout(desc->format));
}

void aob_vk_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture)
{
    struct vk_texture *made = (struct vk_texture *)texture;
    aob_vk_image_finish((struct vk *)gpu, &made->image);
    free(made);
}

static void record_read(struct vk *vk, const struct vk_texture *texture, int level, VkBuffer texels)
{
    VkImageSubresourceRange range = aob_vk_levels(level, 1);
    struct vk_state read = aob_vk_copied_from;
    VkBufferImageCopy region = whole_level(&texture->base, level);
    record_move(vk, texture, range, texture->rest, read);
    vkCmdCopyImageToBuffer(vk->commands, texture->image.image, read.layout, texels, 1, &region);
    record_move(vk, texture, range, read, texture->rest);
}

bool aob_vk_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, int level, void *texels,
                         struct aob_error *error)
{
    struct vk *vk = (struct vk *)gpu;
    size_t size = aob_gpu_level_bytes(texture, level);
    struct vk_buffer staging;
    if (!aob_vk_buffer_init(vk, size, VK_MEMORY_DOWNLOAD, &staging, error))
        return false;
    bool good = aob_vk_begin(vk, error);
    if (good) {
        record_read(vk, (const struct vk_texture *)texture, level, staging.buffer);
        good = aob_vk_finish(vk, NULL, error);
    }
    if (good)
        memcpy(texels, staging.map, size);
    aob_vk_buffer_finish(vk, &staging);
    return good;
}
