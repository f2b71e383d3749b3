#include "vk.h"
#include "base/memory.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const no_driver =
    "vulkan: no driver: install mesa-vulkan-drivers, or set VK_ICD_FILENAMES to your driver's JSON file";

static VKAPI_ATTR VkBool32 VKAPI_CALL keep_complaint(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                                     VkDebugUtilsMessageTypeFlagsEXT type,
                                                     const VkDebugUtilsMessengerCallbackDataEXT *data,
                                                     void *user)
{
    (void)type;
    struct vk *vk = user;
    if (!vk->complaint[0])
        snprintf(vk->complaint, sizeof vk->complaint, "%s", data->pMessage);
    for (char *c = vk->complaint; *c; c++)
        if (*c == '\n' || *c == '\r')
            *c = ' ';
    /* True takes the call back before the driver sees it: lavapipe dies of some of these. */
    return !!(severity & VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT);
}

static VkDebugUtilsMessengerCreateInfoEXT describe_messenger(struct vk *vk)
{
    return (VkDebugUtilsMessengerCreateInfoEXT){
        .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
        .messageSeverity =
            VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT,
        .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT,
        .pfnUserCallback = keep_complaint,
        .pUserData = vk,
    };
}

static bool create_messenger(struct vk *vk, struct aob_error *error)
{
    PFN_vkCreateDebugUtilsMessengerEXT create = (PFN_vkCreateDebugUtilsMessengerEXT)vkGetInstanceProcAddr(
        vk->instance, "vkCreateDebugUtilsMessengerEXT");
    VkDebugUtilsMessengerCreateInfoEXT messenger = describe_messenger(vk);
    return aob_vk_ok(vk, create(vk->instance, &messenger, NULL, &vk->messenger), "listen to validation",
                     error);
}

static bool check_instance(struct vk *vk, VkResult result, struct aob_error *error)
{
    if (result == VK_ERROR_LAYER_NOT_PRESENT || result == VK_ERROR_EXTENSION_NOT_PRESENT)
        return aob_fail(error, "vulkan: no validation layer: install vulkan-validationlayers");
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER)
        return aob_fail(error, "%s", no_driver);
    return aob_vk_ok(vk, result, "create an instance", error);
}

bool aob_vk_instance_create(struct vk *vk, bool validate, struct aob_error *error)
{
    static const char *const layers[] = {"VK_LAYER_KHRONOS_validation"};
    static const char *const extensions[] = {VK_EXT_DEBUG_UTILS_EXTENSION_NAME,
                                             VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME};
    VkDebugUtilsMessengerCreateInfoEXT messenger = describe_messenger(vk);
    VkValidationFeaturesEXT features = {
        .sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
        .pNext = &messenger,
        .enabledValidationFeatureCount = 1,
        .pEnabledValidationFeatures =
            &(VkValidationFeatureEnableEXT){VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT},
    };
    VkInstanceCreateInfo create = {
        .sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
        .pNext = validate ? &features : NULL,
        .pApplicationInfo = &(VkApplicationInfo){.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                                 .pApplicationName = "aobudget",
                                                 .apiVersion = VK_API_VERSION_1_3},
        .enabledLayerCount = validate ? AOB_COUNT(layers) : 0,
        .ppEnabledLayerNames = layers,
        .enabledExtensionCount = validate ? AOB_COUNT(extensions) : 0,
        .ppEnabledExtensionNames = extensions,
    };
    if (!check_instance(vk, vkCreateInstance(&create, NULL, &vk->instance), error))
        return false;
    return !validate || create_messenger(vk, error);
}

void aob_vk_instance_destroy(struct vk *vk)
{
    if (!vk->instance)
        return;
    PFN_vkDestroyDebugUtilsMessengerEXT destroy = (PFN_vkDestroyDebugUtilsMessengerEXT)vkGetInstanceProcAddr(
        vk->instance, "vkDestroyDebugUtilsMessengerEXT");
    if (vk->messenger)
        destroy(vk->instance, vk->messenger, NULL);
    vkDestroyInstance(vk->instance, NULL);
}

static bool find_family(VkPhysicalDevice physical, uint32_t *family, uint32_t *stamp_bits)
{
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, NULL);
    VkQueueFamilyProperties *families = AOB_NEW_ARRAY(VkQueueFamilyProperties, count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families);
    uint32_t found = 0;
    while (found < count && !(families[found].queueFlags & VK_QUEUE_GRAPHICS_BIT))
        found++;
    *family = found;
    *stamp_bits = found < count ? families[found].timestampValidBits : 0;
    free(families);
    return found < count;
}

static int rank_type(VkPhysicalDeviceType type)
{
    static const VkPhysicalDeviceType order[] = {
        VK_PHYSICAL_DEVICE_TYPE_OTHER, VK_PHYSICAL_DEVICE_TYPE_CPU, VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU,
        VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU, VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU};
    for (size_t i = 0; i < AOB_COUNT(order); i++)
        if (order[i] == type)
            return (int)i + 1;
    return 1;
}

static void consider(struct vk *vk, VkPhysicalDevice physical, int *best)
{
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical, &properties);
    uint32_t family, stamp_bits;
    int rank = rank_type(properties.deviceType);
    if (rank <= *best || properties.apiVersion < VK_API_VERSION_1_3 ||
        !find_family(physical, &family, &stamp_bits))
        return;
    *best = rank;
    vk->physical = physical;
    vk->properties = properties;
    vk->family = family;
    vk->stamp_bits = stamp_bits;
}

static bool check_formats(struct vk *vk, struct aob_error *error)
{
    const VkFormatFeatureFlags wanted =
        VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT |
        VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT | VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT |
        VK_FORMAT_FEATURE_TRANSFER_SRC_BIT | VK_FORMAT_FEATURE_TRANSFER_DST_BIT;
    for (enum aob_format format = 0; format < AOB_FORMAT_COUNT; format++) {
        VkFormatProperties properties;
        vkGetPhysicalDeviceFormatProperties(vk->physical, aob_vk_format(format), &properties);
        if ((properties.optimalTilingFeatures & wanted) != wanted)
            return aob_fail(error,
                            "vulkan: %s cannot use format %s in all ways: use another device or backend",
                            vk->properties.deviceName, aob_gpu_format_layout(format));
    }
    return true;
}

bool aob_vk_choose_device(struct vk *vk, struct aob_error *error)
{
    uint32_t count = 0;
    VkResult result = vkEnumeratePhysicalDevices(vk->instance, &count, NULL);
    if (result == VK_ERROR_INITIALIZATION_FAILED || (result == VK_SUCCESS && !count))
        return aob_fail(error, "%s", no_driver);
    if (!aob_vk_ok(vk, result, "count devices", error))
        return false;
    VkPhysicalDevice *devices = AOB_NEW_ARRAY(VkPhysicalDevice, count);
    vkEnumeratePhysicalDevices(vk->instance, &count, devices);
    int best = 0;
    for (uint32_t i = 0; i < count; i++)
        consider(vk, devices[i], &best);
    free(devices);
    if (!best)
        return aob_fail(error, "vulkan: no device has Vulkan 1.3 and a graphics queue: use a newer driver");
    vkGetPhysicalDeviceMemoryProperties(vk->physical, &vk->memory);
    return check_formats(vk, error);
}
