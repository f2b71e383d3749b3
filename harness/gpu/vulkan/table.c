#include "vk.h"
#include "gpu/backends.h"

static struct aob_gpu *open_device(const struct aob_gpu_desc *desc, struct aob_error *error)
{
    return aob_vk_open(&aob_gpu_vulkan, desc, error);
}

const struct aob_gpu_fns aob_gpu_vulkan = {
    .name = "vulkan",
    .title = "Vulkan 1.3, any driver: a GPU if there is one, else the processor (lavapipe)",
    .environment = aob_gpu_driver_environment,
    .devices = aob_vk_devices,
    .open = open_device,
    .close = aob_vk_close,
    .format_lacks = aob_vk_lacks,
    .texture_create = aob_vk_texture_create,
    .texture_destroy = aob_vk_texture_destroy,
    .texture_read = aob_vk_texture_read,
    .texture_write = aob_vk_texture_write,
    .buffer_create = aob_vk_storage_create,
    .buffer_destroy = aob_vk_storage_destroy,
    .buffer_write = aob_vk_storage_write,
    .buffer_read = aob_vk_storage_read,
    .program_create = aob_vk_program_create,
    .program_destroy = aob_vk_program_destroy,
    .pass_create = aob_vk_pass_create,
    .pass_destroy = aob_vk_pass_destroy,
    .pass_set_uniforms = aob_vk_pass_set_uniforms,
    .pass_set_part = aob_vk_pass_set_part,
    .run = aob_vk_run,
};
