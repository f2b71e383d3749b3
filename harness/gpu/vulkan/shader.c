#include "vk.h"
#include "base/memory.h"
#include "gpu/backends.h"
#include <stdlib.h>

VkShaderModule aob_vk_shader_create(struct vk *vk, const uint32_t *words, size_t word_count,
                                    struct aob_error *error)
{
    VkShaderModuleCreateInfo create = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                       .codeSize = word_count * sizeof *words,
                                       .pCode = words};
    VkShaderModule module = VK_NULL_HANDLE;
    if (aob_vk_ok(vk, vkCreateShaderModule(vk->device, &create, NULL, &module), "create a shader", error))
        return module;
    vkDestroyShaderModule(vk->device, module, NULL);
    return VK_NULL_HANDLE;
}

static bool compile(struct vk *vk, const struct aob_gpu_program_desc *desc, enum aob_glsl_stage stage,
                    VkShaderModule *module, uint64_t *bindings, struct aob_error *error)
{
    size_t count;
    uint32_t *words = aob_gpu_program_words(desc, stage, AOB_GLSL_VULKAN, &count, bindings, error);
    if (!words)
        return aob_fail_in(error, "vulkan");
    *module = aob_vk_shader_create(vk, words, count, error);
    free(words);
    return *module;
}

bool aob_vk_program_create(struct aob_gpu *gpu, const struct aob_gpu_program_desc *desc,
                           struct aob_gpu_program **program, struct aob_error *error)
{
    struct vk *vk = (struct vk *)gpu;
    struct vk_program *made = AOB_NEW(struct vk_program);
    if ((!desc->vertex || compile(vk, desc, AOB_GLSL_VERTEX, &made->vertex, &made->base.bindings, error)) &&
        compile(vk, desc, AOB_GLSL_FRAGMENT, &made->fragment, &made->base.bindings, error)) {
        *program = &made->base;
        return true;
    }
    aob_vk_program_destroy(gpu, &made->base);
    return false;
}

void aob_vk_program_destroy(struct aob_gpu *gpu, struct aob_gpu_program *program)
{
    struct vk *vk = (struct vk *)gpu;
    struct vk_program *made = (struct vk_program *)program;
    vkDestroyShaderModule(vk->device, made->vertex, NULL);
    vkDestroyShaderModule(vk->device, made->fragment, NULL);
    for (size_t i = 0; i < made->pipeline_count; i++)
        vkDestroyPipeline(vk->device, made->pipelines[i].pipeline, NULL);
    free(made->pipelines);
    free(made);
    aob_vk_destroyed(vk);
}
