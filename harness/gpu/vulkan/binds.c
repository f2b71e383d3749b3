#include "vk.h"
#include "base/memory.h"
#include "gpu/backends.h"
#include "gpu/glsl.h"
#include <string.h>

static VkDescriptorType descriptor_type(enum aob_gpu_bind_kind kind)
{
    return kind == AOB_GPU_STORAGE ? VK_DESCRIPTOR_TYPE_STORAGE_IMAGE
                                   : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
}

static VkDescriptorSetLayoutBinding describe_binding(uint32_t binding, VkDescriptorType type, bool geometry)
{
    VkShaderStageFlags vertex = geometry ? VK_SHADER_STAGE_VERTEX_BIT : 0;
    return (VkDescriptorSetLayoutBinding){.binding = binding,
                                          .descriptorType = type,
                                          .descriptorCount = 1,
                                          .stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT | vertex};
}

static bool create_layout(struct vk *vk, const struct aob_gpu_pass_desc *desc, struct vk_binds *binds,
                          struct aob_error *error)
{
    VkDescriptorSetLayoutBinding bindings[AOB_GPU_MAX_BINDING + 2];
    uint32_t count = 0;
    bool geometry = desc->program->geometry;
    if (desc->uniforms)
        bindings[count++] = describe_binding(0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, geometry);
    for (size_t i = 0; i < desc->bind_count; i++)
        bindings[count++] =
            describe_binding(desc->binds[i].binding, descriptor_type(desc->binds[i].kind), geometry);
    if (desc->storage)
        bindings[count++] =
            describe_binding(AOB_GLSL_STORAGE_BINDING, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, false);
    VkDescriptorSetLayoutCreateInfo set = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                           .bindingCount = count,
                                           .pBindings = bindings};
    if (!aob_vk_ok(vk, vkCreateDescriptorSetLayout(vk->device, &set, NULL, &binds->set_layout),
                   "create a descriptor layout", error))
        return false;
    VkPipelineLayoutCreateInfo layout = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                         .setLayoutCount = 1,
                                         .pSetLayouts = &binds->set_layout};
    return aob_vk_ok(vk, vkCreatePipelineLayout(vk->device, &layout, NULL, &binds->layout),
                     "create a pipeline layout", error);
}

static bool allocate_set(struct vk *vk, struct vk_binds *binds, struct aob_error *error)
{
    VkDescriptorPoolSize sizes[] = {
        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
        {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, AOB_GPU_MAX_BINDING},
        {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, AOB_GPU_MAX_BINDING},
        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1},
    };
    VkDescriptorPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                       .maxSets = 1,
                                       .poolSizeCount = AOB_COUNT(sizes),
                                       .pPoolSizes = sizes};
    if (!aob_vk_ok(vk, vkCreateDescriptorPool(vk->device, &pool, NULL, &binds->pool),
                   "create a descriptor pool", error))
        return false;
    VkDescriptorSetAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                            .descriptorPool = binds->pool,
                                            .descriptorSetCount = 1,
                                            .pSetLayouts = &binds->set_layout};
    return aob_vk_ok(vk, vkAllocateDescriptorSets(vk->device, &allocate, &binds->set),
                     "allocate a descriptor set", error);
}

static bool write_texture(struct vk *vk, const struct aob_gpu_bind *bind, VkDescriptorSet set,
                          VkImageView *view, struct aob_error *error)
{
    const struct vk_texture *texture = (const struct vk_texture *)bind->texture;
    const VkImageSubresourceRange range = aob_vk_levels(bind->first_level, aob_gpu_bind_levels(bind));
    VkFormat format = aob_vk_format(texture->base.format);
    if (!aob_vk_view_create(vk, texture->image.image, format, &range, view, error))
        return false;
    VkDescriptorImageInfo image = {
        .sampler = vk->samplers[bind->filter], .imageView = *view, .imageLayout = texture->rest.layout};
    VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                  .dstSet = set,
                                  .dstBinding = bind->binding,
                                  .descriptorCount = 1,
                                  .descriptorType = descriptor_type(bind->kind),
                                  .pImageInfo = &image};
    vkUpdateDescriptorSets(vk->device, 1, &write, 0, NULL);
    return true;
}

static void write_buffer(struct vk *vk, VkBuffer buffer, VkDescriptorSet set, uint32_t binding,
                         VkDescriptorType type)
{
    VkDescriptorBufferInfo whole = {.buffer = buffer, .range = VK_WHOLE_SIZE};
    VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                  .dstSet = set,
                                  .dstBinding = binding,
                                  .descriptorCount = 1,
                                  .descriptorType = type,
                                  .pBufferInfo = &whole};
    vkUpdateDescriptorSets(vk->device, 1, &write, 0, NULL);
}

static bool write_uniforms(struct vk *vk, const struct aob_gpu_pass_desc *desc, struct vk_binds *binds,
                           struct aob_error *error)
{
    /* std140 rounds a block up to 16 bytes, and its reader may not. */
    size_t size = (desc->uniform_size + 15) / 16 * 16;
    if (!aob_vk_buffer_init(vk, size, VK_MEMORY_UNIFORMS, &binds->uniforms, error))
        return false;
    memcpy(binds->uniforms.map, desc->uniforms, desc->uniform_size);
    write_buffer(vk, binds->uniforms.buffer, binds->set, 0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
    return true;
}

bool aob_vk_binds_init(struct vk *vk, const struct aob_gpu_pass_desc *desc, struct vk_binds *binds,
                       struct aob_error *error)
{
    if (!create_layout(vk, desc, binds, error))
        return false;
    if (!desc->uniforms && !desc->bind_count && !desc->storage)
        return true;
    if (!allocate_set(vk, binds, error))
        return false;
    for (size_t i = 0; i < desc->bind_count; i++)
        if (!write_texture(vk, &desc->binds[i], binds->set, &binds->views[i], error))
            return false;
    if (desc->storage)
        write_buffer(vk, ((const struct vk_storage *)desc->storage)->buffer.buffer, binds->set,
                     AOB_GLSL_STORAGE_BINDING, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    return !desc->uniforms || write_uniforms(vk, desc, binds, error);
}

void aob_vk_binds_finish(struct vk *vk, struct vk_binds *binds)
{
    vkDestroyDescriptorPool(vk->device, binds->pool, NULL);
    vkDestroyPipelineLayout(vk->device, binds->layout, NULL);
    vkDestroyDescriptorSetLayout(vk->device, binds->set_layout, NULL);
    for (size_t i = 0; i < AOB_COUNT(binds->views); i++)
        vkDestroyImageView(vk->device, binds->views[i], NULL);
    aob_vk_buffer_finish(vk, &binds->uniforms);
    *binds = (struct vk_binds){0};
}
