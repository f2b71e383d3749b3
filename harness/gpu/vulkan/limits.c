#include "vk.h"

static uint32_t least(uint32_t a, uint32_t b)
{
    return a < b ? a : b;
}

/* Of a stage, and of the one descriptor set that a pass has. Both of our stages have the same limits, and each sampled texture
 * brings its sampler. */
struct aob_gpu_limits aob_vk_limits(const VkPhysicalDeviceLimits *device)
{
    struct aob_gpu_limits limits = aob_gpu_no_limits;
    limits.side = device->maxImageDimension2D;
    limits.targets = least(device->maxColorAttachments, device->maxFragmentOutputAttachments);
    limits.sampled =
        least(least(device->maxPerStageDescriptorSamplers, device->maxPerStageDescriptorSampledImages),
              least(device->maxDescriptorSetSamplers, device->maxDescriptorSetSampledImages));
    limits.storage = least(device->maxPerStageDescriptorStorageImages, device->maxDescriptorSetStorageImages);
    limits.resources = device->maxPerStageResources;
    limits.storage_and_targets = device->maxFragmentCombinedOutputResources;
    return limits;
}
