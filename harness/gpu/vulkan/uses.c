#include "vk.h"
#include "base/memory.h"

static const struct {
    uint32_t use;
    VkImageUsageFlags usage;
    VkFormatFeatureFlags feature;
    const char *word;
} uses_table[] = {
    {AOB_GPU_USE_SAMPLED, VK_IMAGE_USAGE_SAMPLED_BIT, VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT, "sampled texture"},
    {AOB_GPU_USE_STORAGE, VK_IMAGE_USAGE_STORAGE_BIT, VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT, "storage image"},
    {AOB_GPU_USE_TARGET, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT,
     "target"},
    {AOB_GPU_USE_READ_BACK, VK_IMAGE_USAGE_TRANSFER_SRC_BIT, VK_FORMAT_FEATURE_TRANSFER_SRC_BIT,
     "texture to read back"},
    {AOB_GPU_NEED_FILTER, 0, VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT, "filtered texture"},
    {AOB_GPU_NEED_BLEND, 0, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT, "blended target"},
};

VkImageUsageFlags aob_vk_usage(uint32_t uses, bool filled)
{
    VkImageUsageFlags usage = filled ? VK_IMAGE_USAGE_TRANSFER_DST_BIT : 0;
    for (size_t i = 0; i < AOB_COUNT(uses_table); i++)
        usage |= uses & uses_table[i].use ? uses_table[i].usage : 0;
    return usage;
}

/* The others need the feature shaderStorageImageExtendedFormats. */
static bool is_plain_storage(enum aob_format format)
{
    return format == AOB_R32F || format == AOB_RGBA8 || format == AOB_RGBA16F || format == AOB_RGBA32F;
}

const char *aob_vk_format_lacks(enum aob_format format, uint32_t needs, VkFormatFeatureFlags has,
                                bool extended)
{
    for (size_t i = 0; i < AOB_COUNT(uses_table); i++)
        if (needs & uses_table[i].use && !(has & uses_table[i].feature))
            return uses_table[i].word;
    return needs & AOB_GPU_USE_STORAGE && !extended && !is_plain_storage(format) ? "storage image" : NULL;
}
