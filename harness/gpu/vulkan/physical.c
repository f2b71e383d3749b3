#include "vk.h"
#include "base/memory.h"
#include "gpu/backends.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/sysmacros.h>

/* The first family that draws, and the valid bits of its timestamps. */
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

static const char *device_class(VkPhysicalDeviceType type)
{
    switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
        return "cpu";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
        return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
        return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
        return "virtual";
    default:
        return "gpu";
    }
}

static bool has_extension(VkPhysicalDevice physical, const char *name)
{
    uint32_t count = 0;
    vkEnumerateDeviceExtensionProperties(physical, NULL, &count, NULL);
    VkExtensionProperties *all = AOB_NEW_ARRAY(VkExtensionProperties, count);
    vkEnumerateDeviceExtensionProperties(physical, NULL, &count, all);
    bool found = false;
    for (uint32_t i = 0; i < count && !found; i++)
        found = !strcmp(all[i].extensionName, name);
    free(all);
    return found;
}

static uint64_t node_of(VkPhysicalDevice physical)
{
    VkPhysicalDeviceDrmPropertiesEXT drm = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRM_PROPERTIES_EXT};
    VkPhysicalDeviceProperties2 all = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                       .pNext = &drm};
    if (!has_extension(physical, VK_EXT_PHYSICAL_DEVICE_DRM_EXTENSION_NAME))
        return 0;
    vkGetPhysicalDeviceProperties2(physical, &all);
    return drm.hasRender ? (uint64_t)makedev((unsigned)drm.renderMajor, (unsigned)drm.renderMinor) : 0;
}

static void describe_driver(VkPhysicalDevice physical, uint32_t version, struct aob_gpu_device *device)
{
    VkPhysicalDeviceDriverProperties driver = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceProperties2 all = {.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                       .pNext = &driver};
    vkGetPhysicalDeviceProperties2(physical, &all);
    snprintf(device->driver, sizeof device->driver, "%s %s, Vulkan %u.%u.%u", driver.driverName,
             driver.driverInfo, VK_API_VERSION_MAJOR(version), VK_API_VERSION_MINOR(version),
             VK_API_VERSION_PATCH(version));
}

static void describe(VkPhysicalDevice physical, struct aob_gpu_device *device)
{
    VkPhysicalDeviceProperties properties;
    uint32_t family, stamp_bits;
    vkGetPhysicalDeviceProperties(physical, &properties);
    bool draws = find_family(physical, &family, &stamp_bits);
    *device = (struct aob_gpu_device){.device_class = device_class(properties.deviceType),
                                      .software = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU,
                                      .timer = stamp_bits > 0,
                                      .node = node_of(physical)};
    snprintf(device->name, sizeof device->name, "%s", properties.deviceName);
    if (properties.apiVersion >= VK_API_VERSION_1_2) /* what describes a driver came with it */
        describe_driver(physical, properties.apiVersion, device);
    if (properties.apiVersion < VK_API_VERSION_1_3)
        snprintf(device->lacks, sizeof device->lacks, "Vulkan 1.3");
    else if (!draws)
        snprintf(device->lacks, sizeof device->lacks, "a graphics queue");
}

static bool enumerate(struct vk *vk, VkPhysicalDevice devices[AOB_GPU_MAX_DEVICES],
                      struct aob_gpu_device_list *list, struct aob_error *error)
{
    uint32_t count = AOB_GPU_MAX_DEVICES;
    VkResult result = vkEnumeratePhysicalDevices(vk->instance, &count, devices);
    if (result == VK_ERROR_INITIALIZATION_FAILED || (result == VK_SUCCESS && !count))
        return aob_vk_fail_no_driver(error);
    if (result != VK_INCOMPLETE && !aob_vk_ok(vk, result, "list devices", error))
        return false;
    for (list->count = 0; list->count < count; list->count++)
        describe(devices[list->count], &list->items[list->count]);
    return true;
}

static bool choose_default(const struct aob_gpu_device_list *list, size_t *chosen, struct aob_error *error)
{
    *chosen = aob_gpu_default_device(list);
    return *chosen < list->count ||
           aob_fail(error, "vulkan: no device has Vulkan 1.3 and a graphics queue: use a newer driver");
}

bool aob_vk_devices(struct aob_gpu_device_list *list, size_t *chosen, struct aob_error *error)
{
    struct vk vk = {0};
    VkPhysicalDevice devices[AOB_GPU_MAX_DEVICES];
    bool ok = aob_vk_instance_create(&vk, false, error) && enumerate(&vk, devices, list, error);
    if (ok)
        choose_default(list, chosen, &list->none);
    aob_vk_instance_destroy(&vk);
    return ok;
}

static bool choose(const struct aob_gpu_device_list *list, const char *wanted, size_t *chosen,
                   struct aob_error *error)
{
    return wanted ? aob_gpu_choose(list, "vulkan", wanted, chosen, error)
                  : choose_default(list, chosen, error);
}

bool aob_vk_choose_device(struct vk *vk, const char *wanted, struct aob_error *error)
{
    VkPhysicalDevice devices[AOB_GPU_MAX_DEVICES];
    struct aob_gpu_device_list *list = AOB_NEW(struct aob_gpu_device_list);
    size_t chosen;
    bool ok = enumerate(vk, devices, list, error) && choose(list, wanted, &chosen, error);
    if (ok) {
        vk->chosen = list->items[chosen];
        vk->physical = devices[chosen];
        vkGetPhysicalDeviceProperties(vk->physical, &vk->properties);
        vkGetPhysicalDeviceMemoryProperties(vk->physical, &vk->memory);
        find_family(vk->physical, &vk->family, &vk->stamp_bits);
    }
    free(list);
    return ok;
}
