#include "vk.h"

static const VkFormat formats[AOB_FORMAT_COUNT] = {
    [AOB_R8] = VK_FORMAT_R8_UNORM,
    [AOB_R16] = VK_FORMAT_R16_UNORM,
    [AOB_R16F] = VK_FORMAT_R16_SFLOAT,
    [AOB_R32F] = VK_FORMAT_R32_SFLOAT,
    [AOB_RG8] = VK_FORMAT_R8G8_UNORM,
    [AOB_RG16F] = VK_FORMAT_R16G16_SFLOAT,
    [AOB_RG32F] = VK_FORMAT_R32G32_SFLOAT,
    [AOB_RGBA8] = VK_FORMAT_R8G8B8A8_UNORM,
    [AOB_RGBA16F] = VK_FORMAT_R16G16B16A16_SFLOAT,
    [AOB_RGBA32F] = VK_FORMAT_R32G32B32A32_SFLOAT,
};

VkFormat aob_vk_format(enum aob_format format)
{
    return formats[format];
}

static const char *explain(VkResult result)
{
    switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return "out of memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return "out of device memory";
    case VK_ERROR_DEVICE_LOST:
        return "the device is lost (a crash or hang in the driver)";
    case VK_ERROR_INITIALIZATION_FAILED:
        return "the driver failed to start";
    case VK_ERROR_FEATURE_NOT_PRESENT:
        return "the device lacks a feature";
    default:
        return NULL;
    }
}

bool aob_vk_fail_no_driver(struct aob_error *error)
{
    return aob_fail(
        error,
        "vulkan: no driver: install mesa-vulkan-drivers, or set VK_ICD_FILENAMES to your driver's JSON file");
}

bool aob_vk_ok(struct vk *vk, VkResult result, const char *what, struct aob_error *error)
{
    if (vk->complaint[0]) {
        aob_fail(error, "vulkan: validation, on the way to %s: %s", what, vk->complaint);
        vk->complaint[0] = '\0';
        return false;
    }
    if (result == VK_SUCCESS)
        return true;
    const char *why = explain(result);
    return why ? aob_fail(error, "vulkan: cannot %s: %s", what, why)
               : aob_fail(error, "vulkan: cannot %s: VkResult %d", what, (int)result);
}
