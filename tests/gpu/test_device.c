/* Which device is used: by default, by another API's default, and by what a user says. */
#include "check.h"
#include "gpu/backends.h"

#define LIST(...)                                                                                            \
    (struct aob_gpu_device_list)                                                                             \
    {                                                                                                        \
        .items = {__VA_ARGS__},                                                                              \
        .count = sizeof((struct aob_gpu_device[]){__VA_ARGS__}) / sizeof(struct aob_gpu_device)              \
    }
#define CPU                                                                                                  \
    {                                                                                                        \
        .name = "llvmpipe (LLVM 15.0.6, 256 bits)", .device_class = "cpu", .software = true                  \
    }
#define INTEL                                                                                                \
    {                                                                                                        \
        .name = "Intel(R) UHD Graphics 630 (CFL GT2)", .device_class = "integrated", .node = 128             \
    }
#define RADEON                                                                                               \
    {                                                                                                        \
        .name = "AMD Radeon RX 6800 (RADV NAVI21)", .device_class = "discrete", .node = 129                  \
    }
#define VIRTUAL                                                                                              \
    {                                                                                                        \
        .name = "Virtio-GPU Venus", .device_class = "virtual"                                                \
    }
#define OTHER                                                                                                \
    {                                                                                                        \
        .name = "Layered", .device_class = "gpu"                                                             \
    }
#define OLD                                                                                                  \
    {                                                                                                        \
        .name = "GeForce GTX 680", .device_class = "discrete", .lacks = "Vulkan 1.3"                         \
    }

static void test_the_default(void **state)
{
    (void)state;
    struct aob_gpu_device_list all = LIST(CPU, OTHER, VIRTUAL, INTEL, RADEON), old = LIST(OLD, CPU),
                               none = LIST(OLD), empty = {0}, two = LIST(CPU, RADEON, RADEON);
    for (size_t best = 4;; best--) { /* each of them when those above it are gone */
        assert_int_equal(aob_gpu_default_device(&all), best);
        all.count--;
        if (!best)
            break;
    }
    assert_int_equal(aob_gpu_default_device(&old), 1);
    assert_int_equal(aob_gpu_default_device(&none), 1); /* the count: there is none */
    assert_int_equal(aob_gpu_default_device(&empty), 0);
    assert_int_equal(aob_gpu_default_device(&two), 1); /* the first of equals */
}

static void test_the_same_device_on_another_api(void **state)
{
    (void)state;
    const struct aob_gpu_device radeon = RADEON, intel = INTEL, cpu = CPU;
    const struct aob_gpu_device card = {.name = "NVIDIA H100 PCIe", .device_class = "discrete"};
#define GL_INTEL                                                                                             \
    {                                                                                                        \
        .name = "Mesa Intel(R) UHD Graphics 630 (CFL GT2)", .device_class = "gpu", .node = 128               \
    }
#define GL_RADEON                                                                                            \
    {                                                                                                        \
        .name = "AMD Radeon RX 6800 (radeonsi, navi21, LLVM 15.0.6)", .device_class = "gpu", .node = 129     \
    }
#define GL_CARD                                                                                              \
    {                                                                                                        \
        .name = "NVIDIA H100 PCIe/PCIe/SSE2", .device_class = "gpu"                                          \
    }
    struct aob_gpu_device_list egl = LIST(GL_INTEL, GL_RADEON, GL_CARD, CPU), processors = LIST(CPU);
    assert_int_equal(aob_gpu_default_like(&egl, &intel), 0);
    assert_int_equal(aob_gpu_default_like(&egl, &radeon), 1);
    assert_int_equal(aob_gpu_default_like(&egl, &card), 2); /* by its name: it has no node */
    assert_int_equal(aob_gpu_default_like(&egl, &cpu), 0);  /* a GPU that only EGL has is no step down */
    assert_int_equal(aob_gpu_default_like(&processors, &cpu), 0);
    assert_int_equal(aob_gpu_default_like(&processors, &radeon), 1); /* none: not silently the processor */
    egl.items[0].node = egl.items[1].node = 0;                       /* an EGL that tells no nodes */
    assert_int_equal(aob_gpu_default_like(&egl, &radeon), 1);
    assert_int_equal(aob_gpu_default_like(&egl, &intel), 0);
    /* Two of one name are told apart by their nodes. */
    struct aob_gpu_device_list twins = LIST(GL_RADEON, GL_RADEON);
    twins.items[0].node = 130;
    assert_int_equal(aob_gpu_default_like(&twins, &radeon), 1);
}

static void expect_choice(const struct aob_gpu_device_list *list, const char *wanted, size_t expected)
{
    struct aob_error error = {""};
    size_t chosen;
    if (!aob_gpu_choose(list, "vulkan", wanted, &chosen, &error))
        fail_msg("%s", error.text);
    assert_int_equal(chosen, expected);
}

static void expect_refusal(const struct aob_gpu_device_list *list, const char *wanted, const char *why)
{
    struct aob_error error = {""};
    size_t chosen;
    assert_false(aob_gpu_choose(list, "vulkan", wanted, &chosen, &error));
    assert_string_equal(error.text, why);
}

static void test_what_a_user_says(void **state)
{
    (void)state;
    struct aob_gpu_device_list list = LIST(OLD, INTEL, RADEON, CPU, RADEON), one = LIST(CPU), empty = {0};
    list.items[4].lacks[0] = '\0';
    snprintf(list.items[4].name, sizeof list.items[4].name, "AMD Radeon");
    expect_choice(&list, "1", 1);
    expect_choice(&list, "003", 3);
    expect_choice(&list, "Intel(R) UHD Graphics 630 (CFL GT2)", 1);
    expect_choice(&list, "uhd", 1);
    expect_choice(&list, "LLVMPIPE", 3);
    expect_choice(&list, "amd radeon", 4); /* the whole name, though it is a part of another */
    expect_refusal(&list, "0",
                   "vulkan: GeForce GTX 680 lacks Vulkan 1.3: use another device or a newer driver");
    expect_refusal(&one, "1", "vulkan: no device '1': there is 0 llvmpipe (LLVM 15.0.6, 256 bits)");
    expect_refusal(&one, "", "vulkan: no device '': there is 0 llvmpipe (LLVM 15.0.6, 256 bits)");
    expect_refusal(
        &one, "99999999999999999999999",
        "vulkan: no device '99999999999999999999999': there is 0 llvmpipe (LLVM 15.0.6, 256 bits)");
    expect_refusal(&empty, "0", "vulkan: no device '0': there are none");
    expect_refusal(
        &list, "radeon",
        "vulkan: give a number, as several devices are 'radeon': there are 0 GeForce GTX 680; 1 "
        "Intel(R) UHD Graphics 630 (CFL GT2); 2 AMD Radeon RX 6800 (RADV NAVI21); 3 llvmpipe (LLVM "
        "15.0.6, 256 bits); 4 AMD Radeon");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_default),
        cmocka_unit_test(test_the_same_device_on_another_api),
        cmocka_unit_test(test_what_a_user_says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
