#include "vk.h"

bool aob_vk_image_init(struct vk *vk, const struct vk_image_desc *desc, struct vk_image *image,
                       struct aob_error *error)
{
    VkImageCreateInfo create = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
        .imageType = VK_IMAGE_TYPE_2D,
        .format = desc->format,
        .extent = {(uint32_t)desc->width, (uint32_t)desc->height, 1},
        .mipLevels = (uint32_t)desc->levels,
        .arrayLayers = 1,
        .samples = VK_SAMPLE_COUNT_1_BIT,
        .tiling = VK_IMAGE_TILING_OPTIMAL,
        .usage = desc->usage,
    };
    if (!aob_vk_ok(vk, vkCreateImage(vk->device, &create, NULL, &image->image), "create an image", error))
        return false;
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(vk->device, image->image, &needs);
    return aob_vk_allocate(vk, &needs, VK_MEMORY_IMAGE, &image->memory, error) &&
           aob_vk_ok(vk, vkBindImageMemory(vk->device, image->image, image->memory, 0), "bind an image",
                     error);
}

void aob_vk_image_finish(struct vk *vk, struct vk_image *image)
{
    vkDestroyImage(vk->device, image->image, NULL);
    vkFreeMemory(vk->device, image->memory, NULL);
    *image = (struct vk_image){0};
}

bool aob_vk_view_create(struct vk *vk, VkImage image, VkFormat format, const VkImageSubresourceRange *range,
                        VkImageView *view, struct aob_error *error)
{
    VkImageViewCreateInfo create = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .image = image,
        .viewType = VK_IMAGE_VIEW_TYPE_2D,
        .format = format,
        .subresourceRange = *range,
    };
    return aob_vk_ok(vk, vkCreateImageView(vk->device, &create, NULL, view), "create an image view", error);
}

VkImageSubresourceRange aob_vk_levels(int first, int count)
{
    return (VkImageSubresourceRange){.aspectMask = VK_IMAGE_ASPECT_COLOR_BIT,
                                     .baseMipLevel = (uint32_t)first,
                                     .levelCount = (uint32_t)count,
                                     .layerCount = 1};
}

VkImageMemoryBarrier2 aob_vk_move(VkImage image, VkImageSubresourceRange range, struct vk_state from,
                                  struct vk_state to)
{
    /* Nothing has to be made available of what only read; that it is done is enough. */
    const VkAccessFlags2 writes = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT |
                                  VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT |
                                  VK_ACCESS_2_TRANSFER_WRITE_BIT;
    return (VkImageMemoryBarrier2){
        .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
        .srcStageMask = from.stages,
        .srcAccessMask = from.access & writes,
        .dstStageMask = to.stages,
        .dstAccessMask = to.access,
        .oldLayout = from.layout,
        .newLayout = to.layout,
        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .image = image,
        .subresourceRange = range,
    };
}

void aob_vk_record_moves(VkCommandBuffer commands, const VkImageMemoryBarrier2 *moves, uint32_t count)
{
    vkCmdPipelineBarrier2(commands, &(VkDependencyInfo){.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                                        .imageMemoryBarrierCount = count,
                                                        .pImageMemoryBarriers = moves});
}
