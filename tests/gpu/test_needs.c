/* What textures and buffers ask of a Vulkan device, on the memory of devices that are not here. The tables are in the order
 * in which the drivers list their types. */
#include "check.h"
#include "gpu/vulkan/vk.h"

enum {
    D = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT,
    V = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT,
    C = VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
    H = VK_MEMORY_PROPERTY_HOST_CACHED_BIT,
    L = VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT,
    P = VK_MEMORY_PROPERTY_PROTECTED_BIT,
    A = VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD,
};
struct device {
    const char *name;
    VkMemoryPropertyFlags types[10];
    uint32_t count, allowed;
    int expected[4]; /* by enum vk_memory_use; -1: none */
};
static const struct device devices[] = {
    {"lavapipe", {D | V | C | H}, 1, ~0u, {0, 0, 0, 0}},
    {"Intel, one pool for both", {D, D | V | C, D | V | C | H}, 3, ~0u, {0, 1, 1, 2}},
    {"NVIDIA with a window of 256 MiB", {0, D, V | C, V | C | H, D | V | C}, 5, ~0u, {1, 4, 2, 3}},
    {"NVIDIA without", {0, D, V | C, V | C | H}, 4, ~0u, {1, 2, 2, 3}},
    {"AMD, all of its memory seen",
     {D, D, V | C, D | V | C, D | V | C, V | C | H, V | C | H},
     7,
     ~0u,
     {0, 3, 2, 5}},
    {"AMD with coherent types",
     {D | A, D | V | C | A, V | C | A, D, V | C, D | V | C, V | C | H},
     7,
     ~0u,
     {3, 5, 4, 6}},
    {"Arm", {D | V | C, D | V | C | H, D | L}, 3, ~0u, {0, 0, 0, 1}},
    {"protected first", {D | P, D, V | C}, 3, ~0u, {1, 2, 2, 2}},
    {"cached, not coherent", {D, V | H, V | C}, 3, ~0u, {0, 2, 2, 2}},
    {"only some allowed", {0, D, V | C, V | C | H, D | V | C}, 5, 1u << 3, {3, 3, 3, 3}},
    {"nothing to write to", {D}, 1, ~0u, {0, -1, -1, -1}},
    {"nothing allowed", {D, V | C}, 2, 0, {-1, -1, -1, -1}},
};

static void test_memory(void **state)
{
    (void)state;
    for (size_t d = 0; d < sizeof devices / sizeof *devices; d++) {
        const struct device *device = &devices[d];
        VkPhysicalDeviceMemoryProperties memory = {.memoryTypeCount = device->count};
        for (uint32_t i = 0; i < device->count; i++)
            memory.memoryTypes[i].propertyFlags = device->types[i];
        for (int use = 0; use < 4; use++) {
            uint32_t type = 99;
            bool found = aob_vk_memory_choose(&memory, device->allowed, (enum vk_memory_use)use, &type);
            if (found != (device->expected[use] >= 0) || (found && (int)type != device->expected[use]))
                fail_msg("%s, use %d: type %d in place of %d", device->name, use, found ? (int)type : -1,
                         device->expected[use]);
        }
    }
}

static void test_a_texture_has_what_it_needs(void **state)
{
    (void)state;
    assert_int_equal(aob_vk_usage(AOB_GPU_USE_SAMPLED, true),
                     VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT);
    assert_int_equal(aob_vk_usage(AOB_GPU_USE_TARGET | AOB_GPU_USE_SAMPLED, false),
                     VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
    assert_int_equal(aob_vk_usage(AOB_GPU_USE_STORAGE | AOB_GPU_USE_READ_BACK, false),
                     VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
}

#define SHADERS (VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT)
#define OUTPUT  VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT
static const uint64_t sampled = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                      storage = VK_ACCESS_2_SHADER_STORAGE_READ_BIT;

static void expect_state(struct vk_state state, VkImageLayout layout, uint64_t stages, uint64_t access)
{
    assert_int_equal(state.layout, layout);
    assert_int_equal(state.stages, stages);
    assert_int_equal(state.access, access);
}

/* Between passes a texture waits for those that may read it, and for nobody else. */
static void test_a_texture_rests_for_its_readers(void **state)
{
    (void)state;
    const uint32_t drawn = AOB_GPU_USE_TARGET | AOB_GPU_USE_READ_BACK;
    expect_state(aob_vk_rest(drawn | AOB_GPU_USE_SAMPLED), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, SHADERS,
                 sampled);
    expect_state(aob_vk_rest(AOB_GPU_USE_STORAGE), VK_IMAGE_LAYOUT_GENERAL, SHADERS, storage);
    expect_state(aob_vk_rest(AOB_GPU_USE_SAMPLED | AOB_GPU_USE_STORAGE), VK_IMAGE_LAYOUT_GENERAL, SHADERS,
                 sampled | storage);
    expect_state(aob_vk_rest(drawn), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, OUTPUT,
                 VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
    expect_state(aob_vk_rest(AOB_GPU_USE_READ_BACK), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                 VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT);
    expect_state(aob_vk_drawn(AOB_GPU_REPLACE), VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, OUTPUT,
                 VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
    expect_state(aob_vk_undefined(aob_vk_rest(AOB_GPU_USE_SAMPLED)), VK_IMAGE_LAYOUT_UNDEFINED, SHADERS,
                 sampled);
}

/* What was written is made available to the next user; what was only read is waited for. */
static void test_a_move_is_no_wider_than_its_ends(void **state)
{
    (void)state;
    const struct vk_state rest = aob_vk_rest(AOB_GPU_USE_SAMPLED), drawn = aob_vk_drawn(AOB_GPU_REPLACE);
    VkImageMemoryBarrier2 closing = aob_vk_move(VK_NULL_HANDLE, aob_vk_levels(0, 1), drawn, rest),
                          opening = aob_vk_move(VK_NULL_HANDLE, aob_vk_levels(0, 1), rest, drawn);
    assert_int_equal(closing.srcStageMask, OUTPUT);
    assert_int_equal(closing.srcAccessMask, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
    assert_int_equal(closing.dstStageMask, SHADERS);
    assert_int_equal(closing.dstAccessMask, sampled);
    assert_int_equal(closing.oldLayout, drawn.layout);
    assert_int_equal(closing.newLayout, rest.layout);
    assert_int_equal(opening.srcStageMask, SHADERS);
    assert_int_equal(opening.srcAccessMask, 0);
    assert_int_equal(opening.dstStageMask, OUTPUT);
    assert_int_equal(opening.dstAccessMask, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
    VkImageMemoryBarrier2 depth =
        aob_vk_move(VK_NULL_HANDLE, aob_vk_levels(0, 1), aob_vk_depth_state, aob_vk_depth_state);
    assert_int_equal(depth.srcStageMask, VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT |
                                             VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT);
    assert_int_equal(depth.srcAccessMask, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT);
    VkImageMemoryBarrier2 filled = aob_vk_move(VK_NULL_HANDLE, aob_vk_levels(0, 1), aob_vk_copied_to, rest);
    assert_int_equal(filled.srcStageMask, VK_PIPELINE_STAGE_2_COPY_BIT);
    assert_int_equal(filled.srcAccessMask, VK_ACCESS_2_TRANSFER_WRITE_BIT);
}

/* Each limit is the least of those that Vulkan has for it. */
static void test_limits(void **state)
{
    (void)state;
    VkPhysicalDeviceLimits device = {.maxImageDimension2D = 4096,
                                     .maxColorAttachments = 8,
                                     .maxFragmentOutputAttachments = 7,
                                     .maxPerStageDescriptorSamplers = 16,
                                     .maxPerStageDescriptorSampledImages = 17,
                                     .maxDescriptorSetSamplers = 18,
                                     .maxDescriptorSetSampledImages = 19,
                                     .maxPerStageDescriptorStorageImages = 5,
                                     .maxDescriptorSetStorageImages = 6,
                                     .maxPerStageResources = 128,
                                     .maxFragmentCombinedOutputResources = 9};
    struct aob_gpu_limits limits = aob_vk_limits(&device);
    assert_int_equal(limits.side, 4096);
    assert_int_equal(limits.targets, 7);
    assert_int_equal(limits.sampled, 16);
    assert_int_equal(limits.storage, 5);
    assert_int_equal(limits.resources, 128);
    assert_int_equal(limits.storage_and_targets, 9);
    assert_int_equal(limits.storage_bindings, UINT32_MAX);
    device.maxPerStageDescriptorSampledImages = 15;
    assert_int_equal(aob_vk_limits(&device).sampled, 15);
    device.maxDescriptorSetSamplers = 14;
    assert_int_equal(aob_vk_limits(&device).sampled, 14);
    device.maxDescriptorSetSampledImages = 13;
    assert_int_equal(aob_vk_limits(&device).sampled, 13);
    device.maxDescriptorSetStorageImages = 4;
    assert_int_equal(aob_vk_limits(&device).storage, 4);
    device.maxColorAttachments = 6;
    assert_int_equal(aob_vk_limits(&device).targets, 6);
}

/* A device that cannot store to 16 bits is refused only where that is done. */
static void test_a_format_is_refused_where_it_is_used(void **state)
{
    (void)state;
    const VkFormatFeatureFlags drawn = VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT |
                                       VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT |
                                       VK_FORMAT_FEATURE_TRANSFER_SRC_BIT;
    const VkFormatFeatureFlags all = drawn | VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT;
    const uint32_t uses = AOB_GPU_USE_SAMPLED | AOB_GPU_USE_TARGET | AOB_GPU_USE_READ_BACK;
    assert_null(aob_vk_format_lacks(AOB_R16, uses, drawn, false));
    assert_string_equal(aob_vk_format_lacks(AOB_R16, uses | AOB_GPU_USE_STORAGE, drawn, true),
                        "storage image");
    assert_string_equal(aob_vk_format_lacks(AOB_R16, AOB_GPU_USE_STORAGE, all, false), "storage image");
    assert_null(aob_vk_format_lacks(AOB_R16, AOB_GPU_USE_STORAGE, all, true));
    assert_null(aob_vk_format_lacks(AOB_R32F, AOB_GPU_USE_STORAGE, all, false)); /* of the plain ones */
    assert_string_equal(aob_vk_format_lacks(AOB_R16, uses, VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT, true),
                        "target");
    assert_string_equal(aob_vk_format_lacks(AOB_R16, uses, 0, true), "sampled texture");
    assert_string_equal(aob_vk_format_lacks(AOB_R16, AOB_GPU_USE_READ_BACK, 0, true), "texture to read back");
    assert_string_equal(aob_vk_format_lacks(AOB_R32F, AOB_GPU_NEED_FILTER, all, true), "filtered texture");
    assert_string_equal(aob_vk_format_lacks(AOB_R32F, AOB_GPU_NEED_BLEND, all, true), "blended target");
    assert_null(aob_vk_format_lacks(AOB_R32F, AOB_GPU_NEED_FILTER | AOB_GPU_NEED_BLEND,
                                    VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT |
                                        VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT,
                                    true));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_memory),
        cmocka_unit_test(test_a_texture_has_what_it_needs),
        cmocka_unit_test(test_a_texture_rests_for_its_readers),
        cmocka_unit_test(test_a_move_is_no_wider_than_its_ends),
        cmocka_unit_test(test_limits),
        cmocka_unit_test(test_a_format_is_refused_where_it_is_used),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
