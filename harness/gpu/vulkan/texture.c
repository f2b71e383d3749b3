#include "vk.h"
#include "base/memory.h"
#include <stdlib.h>
#include <string.h>

static size_t byte_size(const struct aob_gpu_texture *texture)
{
    return (size_t)texture->width * (size_t)texture->height * aob_gpu_texel_size(texture->format);
}

static VkBufferImageCopy whole(const struct vk_texture *texture)
{
    return (VkBufferImageCopy){
        .imageSubresource = {.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT, .layerCount = 1},
        .imageExtent = {(uint32_t)texture->base.width, (uint32_t)texture->base.height, 1},
    };
}

static bool create_image(struct vk *vk, struct vk_texture *texture, struct aob_error *error)
{
    VkImageCreateInfo create = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
        .imageType = VK_IMAGE_TYPE_2D,
        .format = aob_vk_format(texture->base.format),
        .extent = {(uint32_t)texture->base.width, (uint32_t)texture->base.height, 1},
        .mipLevels = 1,
        .arrayLayers = 1,
        .samples = VK_SAMPLE_COUNT_1_BIT,
        .tiling = VK_IMAGE_TILING_OPTIMAL,
        .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                 VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                 VK_IMAGE_USAGE_TRANSFER_DST_BIT,
    };
    if (!aob_vk_ok(vk, vkCreateImage(vk->device, &create, NULL, &texture->image), "create an image", error))
        return false;
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(vk->device, texture->image, &needs);
    return aob_vk_allocate(vk, &needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, &texture->memory, error) &&
           aob_vk_ok(vk, vkBindImageMemory(vk->device, texture->image, texture->memory, 0), "bind an image",
                     error);
}

static bool create_view(struct vk *vk, struct vk_texture *texture, struct aob_error *error)
{
    VkImageViewCreateInfo create = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .image = texture->image,
        .viewType = VK_IMAGE_VIEW_TYPE_2D,
        .format = aob_vk_format(texture->base.format),
        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1},
    };
    return aob_vk_ok(vk, vkCreateImageView(vk->device, &create, NULL, &texture->view), "create an image view",
                     error);
}

static void record_layout(struct vk *vk, const struct vk_texture *texture)
{
    VkImageMemoryBarrier2 to_general = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
        .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
        .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
        .dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
        .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED,
        .newLayout = VK_IMAGE_LAYOUT_GENERAL,
        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .image = texture->image,
        .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1},
    };
    vkCmdPipelineBarrier2(vk->scratch, &(VkDependencyInfo){.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                                           .imageMemoryBarrierCount = 1,
                                                           .pImageMemoryBarriers = &to_general});
}

static bool upload(struct vk *vk, const struct vk_texture *texture, const void *texels,
                   struct aob_error *error)
{
    struct vk_buffer staging = {0};
    if (texels) {
        size_t size = byte_size(&texture->base);
        if (!aob_vk_buffer_init(vk, size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, &staging, error))
            return false;
        memcpy(staging.map, texels, size);
    }
    bool good = aob_vk_begin(vk, vk->scratch, error);
    if (good) {
        VkBufferImageCopy region = whole(texture);
        record_layout(vk, texture);
        if (texels)
            vkCmdCopyBufferToImage(vk->scratch, staging.buffer, texture->image, VK_IMAGE_LAYOUT_GENERAL, 1,
                                   &region);
        good = aob_vk_end(vk, vk->scratch, error) && aob_vk_submit(vk, vk->scratch, NULL, error);
    }
    aob_vk_buffer_finish(vk, &staging);
    return good;
}

bool aob_vk_texture_create(struct aob_gpu *gpu, enum aob_format format, int width, int height,
                           const void *texels, struct aob_gpu_texture **texture, struct aob_error *error)
{
    struct vk *vk = (struct vk *)gpu;
    uint32_t limit = vk->properties.limits.maxImageDimension2D;
    if ((uint32_t)width > limit || (uint32_t)height > limit)
        return aob_fail(error, "vulkan: texture size %dx%d is beyond this device's %u", width, height, limit);
    struct vk_texture *made = AOB_NEW(struct vk_texture);
    made->base = (struct aob_gpu_texture){.format = format, .width = width, .height = height};
    if (create_image(vk, made, error) && create_view(vk, made, error) && upload(vk, made, texels, error)) {
        *texture = &made->base;
        return true;
    }
    aob_vk_texture_destroy(gpu, &made->base);
    return aob_fail_in(error, "texture %dx%d %s", width, height, aob_gpu_format_layout(format));
}

void aob_vk_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture)
{
    struct vk *vk = (struct vk *)gpu;
    struct vk_texture *made = (struct vk_texture *)texture;
    vkDestroyImageView(vk->device, made->view, NULL);
    vkDestroyImage(vk->device, made->image, NULL);
    vkFreeMemory(vk->device, made->memory, NULL);
    free(made);
}

bool aob_vk_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, void *texels,
                         struct aob_error *error)
{
    struct vk *vk = (struct vk *)gpu;
    const struct vk_texture *made = (const struct vk_texture *)texture;
    size_t size = byte_size(texture);
    struct vk_buffer staging;
    if (!aob_vk_buffer_init(vk, size, VK_BUFFER_USAGE_TRANSFER_DST_BIT, &staging, error))
        return false;
    bool good = aob_vk_begin(vk, vk->scratch, error);
    if (good) {
        VkBufferImageCopy region = whole(made);
        vkCmdCopyImageToBuffer(vk->scratch, made->image, VK_IMAGE_LAYOUT_GENERAL, staging.buffer, 1, &region);
        good = aob_vk_end(vk, vk->scratch, error) && aob_vk_submit(vk, vk->scratch, NULL, error);
    }
    if (good)
        memcpy(texels, staging.map, size);
    aob_vk_buffer_finish(vk, &staging);
    return good;
}
