#include "vk.h"
#include "base/memory.h"
#include <stdlib.h>
#include <string.h>

struct aob_gpu_pass {
    struct vk_buffer uniforms;
    VkDescriptorSetLayout set_layout;
    VkDescriptorPool pool;
    VkDescriptorSet set;
    VkPipelineLayout layout;
    VkPipeline pipeline;
    VkCommandBuffer commands;
    struct vk_depth depth; /* NULL handles: none */
};

enum { MAX_SET = 16, FLUSH_EVERY = 8 };

static const VkPipelineVertexInputStateCreateInfo no_vertices = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
};
static const VkPipelineInputAssemblyStateCreateInfo triangles = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
    .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST,
};
static const VkPipelineRasterizationStateCreateInfo fill = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO,
    .lineWidth = 1,
};
static const VkPipelineDepthStencilStateCreateInfo greater_wins = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
    .depthTestEnable = VK_TRUE,
    .depthWriteEnable = VK_TRUE,
    .depthCompareOp = VK_COMPARE_OP_GREATER,
};
static const VkPipelineMultisampleStateCreateInfo one_sample = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
    .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT,
};

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

static bool create_layout(struct vk *vk, const struct aob_gpu_pass_desc *desc, struct aob_gpu_pass *pass,
                          struct aob_error *error)
{
    VkDescriptorSetLayoutBinding bindings[MAX_SET];
    uint32_t count = 0;
    bool geometry = desc->program->geometry;
    if (desc->uniforms)
        bindings[count++] = describe_binding(0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, geometry);
    for (size_t i = 0; i < desc->bind_count; i++)
        bindings[count++] =
            describe_binding(desc->binds[i].binding, descriptor_type(desc->binds[i].kind), geometry);
    VkDescriptorSetLayoutCreateInfo set = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                           .bindingCount = count,
                                           .pBindings = bindings};
    if (!aob_vk_ok(vk, vkCreateDescriptorSetLayout(vk->device, &set, NULL, &pass->set_layout),
                   "create a descriptor layout", error))
        return false;
    VkPipelineLayoutCreateInfo layout = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                         .setLayoutCount = 1,
                                         .pSetLayouts = &pass->set_layout};
    return aob_vk_ok(vk, vkCreatePipelineLayout(vk->device, &layout, NULL, &pass->layout),
                     "create a pipeline layout", error);
}

static bool allocate_set(struct vk *vk, struct aob_gpu_pass *pass, struct aob_error *error)
{
    VkDescriptorPoolSize sizes[] = {
        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1},
        {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, MAX_SET},
        {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, MAX_SET},
    };
    VkDescriptorPoolCreateInfo pool = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                       .maxSets = 1,
                                       .poolSizeCount = AOB_COUNT(sizes),
                                       .pPoolSizes = sizes};
    if (!aob_vk_ok(vk, vkCreateDescriptorPool(vk->device, &pool, NULL, &pass->pool),
                   "create a descriptor pool", error))
        return false;
    VkDescriptorSetAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                            .descriptorPool = pass->pool,
                                            .descriptorSetCount = 1,
                                            .pSetLayouts = &pass->set_layout};
    return aob_vk_ok(vk, vkAllocateDescriptorSets(vk->device, &allocate, &pass->set),
                     "allocate a descriptor set", error);
}

static void write_texture(struct vk *vk, const struct aob_gpu_bind *bind, VkDescriptorSet set)
{
    VkDescriptorImageInfo image = {.sampler = vk->samplers[bind->filter],
                                   .imageView = ((const struct vk_texture *)bind->texture)->view,
                                   .imageLayout = VK_IMAGE_LAYOUT_GENERAL};
    VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                  .dstSet = set,
                                  .dstBinding = bind->binding,
                                  .descriptorCount = 1,
                                  .descriptorType = descriptor_type(bind->kind),
                                  .pImageInfo = &image};
    vkUpdateDescriptorSets(vk->device, 1, &write, 0, NULL);
}

static void write_uniforms(struct vk *vk, const struct aob_gpu_pass *pass)
{
    VkDescriptorBufferInfo buffer = {.buffer = pass->uniforms.buffer, .range = VK_WHOLE_SIZE};
    VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                  .dstSet = pass->set,
                                  .descriptorCount = 1,
                                  .descriptorType = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                                  .pBufferInfo = &buffer};
    vkUpdateDescriptorSets(vk->device, 1, &write, 0, NULL);
}

static bool bind_resources(struct vk *vk, const struct aob_gpu_pass_desc *desc, struct aob_gpu_pass *pass,
                           struct aob_error *error)
{
    if (!create_layout(vk, desc, pass, error))
        return false;
    if (!desc->uniforms && !desc->bind_count)
        return true;
    if (!allocate_set(vk, pass, error))
        return false;
    for (size_t i = 0; i < desc->bind_count; i++)
        write_texture(vk, &desc->binds[i], pass->set);
    if (!desc->uniforms)
        return true;
    /* std140 rounds a block up to 16 bytes, and its reader may not. */
    size_t size = (desc->uniform_size + 15) / 16 * 16;
    if (!aob_vk_buffer_init(vk, size, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT, &pass->uniforms, error))
        return false;
    memcpy(pass->uniforms.map, desc->uniforms, desc->uniform_size);
    write_uniforms(vk, pass);
    return true;
}

static VkRect2D area(const struct aob_gpu_pass_desc *desc)
{
    return (VkRect2D){.extent = {(uint32_t)desc->targets[0]->width, (uint32_t)desc->targets[0]->height}};
}

static VkPipelineShaderStageCreateInfo describe_stage(VkShaderStageFlagBits stage, VkShaderModule module)
{
    return (VkPipelineShaderStageCreateInfo){.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                             .stage = stage,
                                             .module = module,
                                             .pName = "main"};
}

static VkPipelineColorBlendStateCreateInfo
describe_output(const struct aob_gpu_pass_desc *desc,
                VkPipelineColorBlendAttachmentState outputs[AOB_MAX_OUT])
{
    for (size_t i = 0; i < desc->target_count; i++)
        outputs[i] = (VkPipelineColorBlendAttachmentState){.blendEnable = desc->blend == AOB_GPU_ADD,
                                                           .srcColorBlendFactor = VK_BLEND_FACTOR_ONE,
                                                           .dstColorBlendFactor = VK_BLEND_FACTOR_ONE,
                                                           .srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE,
                                                           .dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE,
                                                           .colorWriteMask = 0xf};
    return (VkPipelineColorBlendStateCreateInfo){
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = (uint32_t)desc->target_count,
        .pAttachments = outputs,
    };
}

static bool can_blend(const struct vk *vk, const struct aob_gpu_pass_desc *desc, struct aob_error *error)
{
    for (size_t i = 0; desc->blend != AOB_GPU_REPLACE && i < desc->target_count; i++) {
        VkFormatProperties can;
        vkGetPhysicalDeviceFormatProperties(vk->physical, aob_vk_format(desc->targets[i]->format), &can);
        if (!(can.optimalTilingFeatures & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT))
            return aob_fail(error, "vulkan: %s cannot blend to %s: use another device or backend",
                            vk->properties.deviceName, aob_gpu_format_layout(desc->targets[i]->format));
    }
    return true;
}

static bool create_pipeline(struct vk *vk, const struct aob_gpu_pass_desc *desc, struct aob_gpu_pass *pass,
                            struct aob_error *error)
{
    const struct vk_program *program = (const struct vk_program *)desc->program;
    uint32_t count = (uint32_t)desc->target_count;
    VkFormat formats[AOB_MAX_OUT];
    VkPipelineColorBlendAttachmentState outputs[AOB_MAX_OUT];
    for (uint32_t i = 0; i < count; i++)
        formats[i] = aob_vk_format(desc->targets[i]->format);
    VkRect2D scissor = area(desc);
    VkViewport viewport = {
        .width = (float)scissor.extent.width, .height = (float)scissor.extent.height, .maxDepth = 1};
    VkPipelineShaderStageCreateInfo stages[] = {
        describe_stage(VK_SHADER_STAGE_VERTEX_BIT, program->vertex ? program->vertex : vk->triangle),
        describe_stage(VK_SHADER_STAGE_FRAGMENT_BIT, program->fragment),
    };
    VkPipelineViewportStateCreateInfo view = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1,
        .pViewports = &viewport,
        .scissorCount = 1,
        .pScissors = &scissor,
    };
    VkPipelineColorBlendStateCreateInfo output = describe_output(desc, outputs);
    VkPipelineRenderingCreateInfo rendering = {
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = count,
        .pColorAttachmentFormats = formats,
        .depthAttachmentFormat = desc->depth_test ? AOB_VK_DEPTH_FORMAT : VK_FORMAT_UNDEFINED};
    VkGraphicsPipelineCreateInfo create = {
        .sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
        .pNext = &rendering,
        .stageCount = AOB_COUNT(stages),
        .pStages = stages,
        .pVertexInputState = &no_vertices,
        .pInputAssemblyState = &triangles,
        .pViewportState = &view,
        .pRasterizationState = &fill,
        .pMultisampleState = &one_sample,
        .pDepthStencilState = desc->depth_test ? &greater_wins : NULL,
        .pColorBlendState = &output,
        .layout = pass->layout,
    };
    return aob_vk_ok(vk, vkCreateGraphicsPipelines(vk->device, NULL, 1, &create, NULL, &pass->pipeline),
                     "create a pipeline", error);
}

static void record_draw(const struct aob_gpu_pass_desc *desc, const struct aob_gpu_pass *pass)
{
    VkRenderingAttachmentInfo targets[AOB_MAX_OUT];
    for (size_t i = 0; i < desc->target_count; i++)
        targets[i] = (VkRenderingAttachmentInfo){
            .sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
            .imageView = ((const struct vk_texture *)desc->targets[i])->view,
            .imageLayout = VK_IMAGE_LAYOUT_GENERAL,
            .loadOp = desc->program->geometry ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_DONT_CARE,
            .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
    VkRenderingAttachmentInfo depth = {.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                       .imageView = pass->depth.view,
                                       .imageLayout = VK_IMAGE_LAYOUT_GENERAL,
                                       .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                       .storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE};
    VkRenderingInfo rendering = {.sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
                                 .renderArea = area(desc),
                                 .layerCount = 1,
                                 .colorAttachmentCount = (uint32_t)desc->target_count,
                                 .pColorAttachments = targets,
                                 .pDepthAttachment = desc->depth_test ? &depth : NULL};
    if (desc->depth_test)
        aob_vk_depth_record(&pass->depth, pass->commands);
    vkCmdBeginRendering(pass->commands, &rendering);
    vkCmdBindPipeline(pass->commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pass->pipeline);
    if (pass->set)
        vkCmdBindDescriptorSets(pass->commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pass->layout, 0, 1,
                                &pass->set, 0, NULL);
    vkCmdDraw(pass->commands, desc->vertex_count ? desc->vertex_count : 3, 1, 0, 0);
    vkCmdEndRendering(pass->commands);
}

static bool record(struct vk *vk, const struct aob_gpu_pass_desc *desc, struct aob_gpu_pass *pass,
                   struct aob_error *error)
{
    VkCommandBufferAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                            .commandPool = vk->pool,
                                            .commandBufferCount = 1};
    if (!aob_vk_ok(vk, vkAllocateCommandBuffers(vk->device, &allocate, &pass->commands),
                   "allocate a command buffer", error) ||
        !aob_vk_begin(vk, pass->commands, error))
        return false;
    record_draw(desc, pass);
    return aob_vk_end(vk, pass->commands, error);
}

bool aob_vk_pass_create(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc, struct aob_gpu_pass **pass,
                        struct aob_error *error)
{
    struct vk *vk = (struct vk *)gpu;
    struct aob_gpu_pass *made = AOB_NEW(struct aob_gpu_pass);
    int width = desc->targets[0]->width, height = desc->targets[0]->height;
    if (can_blend(vk, desc, error) && bind_resources(vk, desc, made, error) &&
        (!desc->depth_test || aob_vk_depth_init(vk, width, height, &made->depth, error)) &&
        create_pipeline(vk, desc, made, error) && record(vk, desc, made, error)) {
        *pass = made;
        return true;
    }
    aob_vk_pass_destroy(gpu, made);
    return false;
}

void aob_vk_pass_destroy(struct aob_gpu *gpu, struct aob_gpu_pass *pass)
{
    struct vk *vk = (struct vk *)gpu;
    if (pass->commands)
        vkFreeCommandBuffers(vk->device, vk->pool, 1, &pass->commands);
    vkDestroyPipeline(vk->device, pass->pipeline, NULL);
    vkDestroyDescriptorPool(vk->device, pass->pool, NULL);
    vkDestroyPipelineLayout(vk->device, pass->layout, NULL);
    vkDestroyDescriptorSetLayout(vk->device, pass->set_layout, NULL);
    aob_vk_buffer_finish(vk, &pass->uniforms);
    aob_vk_depth_finish(vk, &pass->depth);
    free(pass);
    /* lavapipe frees what was destroyed at the next submit only, and a sweep may destroy much in a row. */
    if (++vk->destroyed_passes % FLUSH_EVERY == 0)
        aob_vk_submit(vk, VK_NULL_HANDLE, NULL, NULL);
}

bool aob_vk_pass_run(struct aob_gpu *gpu, struct aob_gpu_pass *pass, struct aob_gpu_time *time,
                     struct aob_error *error)
{
    return aob_vk_submit((struct vk *)gpu, pass->commands, time, error);
}
