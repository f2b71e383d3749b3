#include "vk.h"
#include "gpu/backends.h"

/* Code from a disk cache may have been made under other settings, and hides what a compile costs. */
static const char *const environment[] = {
    "MESA_SHADER_CACHE_DISABLE=true",
    "__GL_SHADER_DISK_CACHE=0",
    NULL,
};

const struct aob_gpu_fns aob_gpu_vulkan = {
    .name = "vulkan",
    .title = "Vulkan 1.3, any driver: the first real GPU, else the processor (lavapipe)",
    .environment = environment,
    .open = aob_vk_open,
    .close = aob_vk_close,
    .texture_create = aob_vk_texture_create,
    .texture_destroy = aob_vk_texture_destroy,
    .texture_read = aob_vk_texture_read,
    .program_create = aob_vk_program_create,
    .program_destroy = aob_vk_program_destroy,
    .pass_create = aob_vk_pass_create,
    .pass_destroy = aob_vk_pass_destroy,
    .pass_run = aob_vk_pass_run,
};
