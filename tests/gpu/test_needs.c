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
    assert_int_equal(aob_vk_rest_layout(AOB_GPU_USE_TARGET | AOB_GPU_USE_SAMPLED | AOB_GPU_USE_READ_BACK),
                     VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    assert_int_equal(aob_vk_rest_layout(AOB_GPU_USE_TARGET | AOB_GPU_USE_READ_BACK),
                     VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    assert_int_equal(aob_vk_rest_layout(AOB_GPU_USE_SAMPLED | AOB_GPU_USE_STORAGE), VK_IMAGE_LAYOUT_GENERAL);
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
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_memory),
        cmocka_unit_test(test_a_texture_has_what_it_needs),
        cmocka_unit_test(test_a_format_is_refused_where_it_is_used),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
