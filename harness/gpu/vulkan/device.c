#include "vk.h"
#include "base/memory.h"
#include "gpu/glsl.h"
#include <stdio.h>
#include <stdlib.h>

static bool create_device(struct vk *vk, bool robust, struct aob_error *error)
{
    VkPhysicalDeviceFeatures has;
    vkGetPhysicalDeviceFeatures(vk->physical, &has);
    vk->extended_storage = has.shaderStorageImageExtendedFormats;
    vk->fragment_stores = has.fragmentStoresAndAtomics;
    VkPhysicalDeviceVulkan13Features features13 = {
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
        .dynamicRendering = VK_TRUE,
        .synchronization2 = VK_TRUE,
        .robustImageAccess = robust, /* every Vulkan 1.3 has both */
    };
    VkDeviceCreateInfo create = {
        .sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
        .pNext = &features13,
        .queueCreateInfoCount = 1,
        .pQueueCreateInfos = &(VkDeviceQueueCreateInfo){.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                                        .queueFamilyIndex = vk->family,
                                                        .queueCount = 1,
                                                        .pQueuePriorities = &(float){1}},
        .pEnabledFeatures =
            &(VkPhysicalDeviceFeatures){.shaderStorageImageExtendedFormats =
                                            has.shaderStorageImageExtendedFormats,
                                        .fragmentStoresAndAtomics = has.fragmentStoresAndAtomics,
                                        .robustBufferAccess = robust},
    };
    if (!aob_vk_ok(vk, vkCreateDevice(vk->physical, &create, NULL, &vk->device), "create a device", error))
        return false;
    vkGetDeviceQueue(vk->device, vk->family, 0, &vk->queue);
    return true;
}

static bool create_commands(struct vk *vk, struct aob_error *error)
{
    VkCommandPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                    .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                    .queueFamilyIndex = vk->family};
    if (!aob_vk_ok(vk, vkCreateCommandPool(vk->device, &pool, NULL, &vk->pool), "create a command pool",
                   error))
        return false;
    VkCommandBufferAllocateInfo one = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                       .commandPool = vk->pool,
                                       .commandBufferCount = 1};
    VkFenceCreateInfo fence = {.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    return aob_vk_ok(vk, vkAllocateCommandBuffers(vk->device, &one, &vk->commands),
                     "allocate a command buffer", error) &&
           aob_vk_ok(vk, vkCreateFence(vk->device, &fence, NULL, &vk->fence), "create a fence", error);
}

static bool create_sampler(struct vk *vk, enum aob_filter filter, struct aob_error *error)
{
    VkFilter kind = filter == AOB_BILINEAR ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    VkSamplerCreateInfo sampler = {
        .sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
        .magFilter = kind,
        .minFilter = kind,
        .mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST,
        .addressModeU = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
        .addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
        .addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE,
        .maxLod = VK_LOD_CLAMP_NONE,
    };
    return aob_vk_ok(vk, vkCreateSampler(vk->device, &sampler, NULL, &vk->samplers[filter]),
                     "create a sampler", error);
}

static bool create_triangle(struct vk *vk, struct aob_error *error)
{
    size_t count;
    uint32_t *words =
        aob_glsl_compile(aob_glsl_screen_triangle, AOB_GLSL_VERTEX, AOB_GLSL_VULKAN, &count, error);
    if (!words)
        return false;
    vk->triangle = aob_vk_shader_create(vk, words, count, error);
    free(words);
    return vk->triangle;
}

static void read_limits(struct vk *vk)
{
    VkFormatProperties depth;
    vkGetPhysicalDeviceFormatProperties(vk->physical, AOB_VK_DEPTH_FORMAT, &depth);
    vk->base.limits = aob_vk_limits(&vk->properties.limits);
    vk->base.limits.lacks_depth =
        !(depth.optimalTilingFeatures & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT);
}

static void describe(struct vk *vk)
{
    vk->base.info = (struct aob_gpu_info){
        .backend = vk->base.fns->name,
        .device = vk->chosen.name,
        .driver = vk->chosen.driver,
        .device_class = vk->chosen.device_class,
        .software = vk->chosen.software,
        .timer = vk->chosen.timer,
        .storage_bytes = vk->fragment_stores ? vk->properties.limits.maxStorageBufferRange / 4 * 4 : 0};
}

struct aob_gpu *aob_vk_open(const struct aob_gpu_fns *fns, const struct aob_gpu_desc *desc,
                            struct aob_error *error)
{
    struct vk *vk = AOB_NEW(struct vk);
    vk->base.fns = fns;
    if (aob_vk_instance_create(vk, desc->validate, error) && aob_vk_choose_device(vk, desc->device, error) &&
        create_device(vk, desc->robust, error) && create_commands(vk, error) &&
        create_sampler(vk, AOB_NEAREST, error) && create_sampler(vk, AOB_BILINEAR, error) &&
        create_triangle(vk, error) && aob_vk_stamps_create(vk, error)) {
        describe(vk);
        read_limits(vk);
        return &vk->base;
    }
    aob_vk_close(&vk->base);
    return NULL;
}

static void destroy_device(struct vk *vk)
{
    vkDestroyShaderModule(vk->device, vk->triangle, NULL);
    for (size_t i = 0; i < AOB_COUNT(vk->samplers); i++)
        vkDestroySampler(vk->device, vk->samplers[i], NULL);
    vkDestroyQueryPool(vk->device, vk->stamps, NULL);
    vkDestroyFence(vk->device, vk->fence, NULL);
    vkDestroyCommandPool(vk->device, vk->pool, NULL);
    vkDestroyDevice(vk->device, NULL);
}

void aob_vk_close(struct aob_gpu *gpu)
{
    struct vk *vk = (struct vk *)gpu;
    if (vk->device)
        destroy_device(vk);
    if (vk->complaint[0])
        aob_warn("vulkan: validation, on closing: %s", vk->complaint);
    aob_vk_instance_destroy(vk);
    free(vk);
}
