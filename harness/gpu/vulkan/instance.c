#include "vk.h"
#include "base/memory.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
        return aob_vk_fail_no_driver(error);
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
