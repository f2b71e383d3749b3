#include "vk.h"

static bool create_image(struct vk *vk, int width, int height, struct vk_depth *depth,
                         struct aob_error *error)
{
    VkFormatProperties can;
    vkGetPhysicalDeviceFormatProperties(vk->physical, AOB_VK_DEPTH_FORMAT, &can);
    if (!(can.optimalTilingFeatures & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT))
        return aob_fail(error, "vulkan: %s has no 32-bit float depth: use another device or backend",
                        vk->properties.deviceName);
    VkImageCreateInfo create = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
        .imageType = VK_IMAGE_TYPE_2D,
        .format = AOB_VK_DEPTH_FORMAT,
        .extent = {(uint32_t)width, (uint32_t)height, 1},
        .mipLevels = 1,
        .arrayLayers = 1,
        .samples = VK_SAMPLE_COUNT_1_BIT,
        .tiling = VK_IMAGE_TILING_OPTIMAL,
        .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
    };
    if (!aob_vk_ok(vk, vkCreateImage(vk->device, &create, NULL, &depth->image), "create a depth image",
                   error))
        return false;
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(vk->device, depth->image, &needs);
    return aob_vk_allocate(vk, &needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, &depth->memory, error) &&
           aob_vk_ok(vk, vkBindImageMemory(vk->device, depth->image, depth->memory, 0), "bind a depth image",
                     error);
}

bool aob_vk_depth_init(struct vk *vk, int width, int height, struct vk_depth *depth, struct aob_error *error)
{
    if (!create_image(vk, width, height, depth, error))
        return false;
    VkImageViewCreateInfo create = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
        .image = depth->image,
        .viewType = VK_IMAGE_VIEW_TYPE_2D,
        .format = AOB_VK_DEPTH_FORMAT,
        .subresourceRange = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 1, 0, 1},
    };
    return aob_vk_ok(vk, vkCreateImageView(vk->device, &create, NULL, &depth->view), "create a depth view",
                     error);
}

void aob_vk_depth_finish(struct vk *vk, struct vk_depth *depth)
{
    vkDestroyImageView(vk->device, depth->view, NULL);
    vkDestroyImage(vk->device, depth->image, NULL);
    vkFreeMemory(vk->device, depth->memory, NULL);
    *depth = (struct vk_depth){0};
}

void aob_vk_depth_record(const struct vk_depth *depth, VkCommandBuffer commands)
{
    /* From UNDEFINED at every run: each clears it, so that what it held need not be kept. */
    VkImageMemoryBarrier2 to_general = {
        .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
        .srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
        .srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT,
        .dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
        .dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT,
        .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED,
        .newLayout = VK_IMAGE_LAYOUT_GENERAL,
        .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
        .image = depth->image,
        .subresourceRange = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 1, 0, 1},
    };
    vkCmdPipelineBarrier2(commands, &(VkDependencyInfo){.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                                        .imageMemoryBarrierCount = 1,
                                                        .pImageMemoryBarriers = &to_general});
}
