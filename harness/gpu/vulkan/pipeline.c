#include "vk.h"
#include "base/memory.h"
#include <string.h>

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

static VkPipelineRenderingCreateInfo describe_targets(const struct aob_gpu_pass_desc *desc,
                                                      VkFormat formats[AOB_MAX_OUT])
{
    for (size_t i = 0; i < desc->target_count; i++)
        formats[i] = aob_vk_format(desc->targets[i].texture->format);
    return (VkPipelineRenderingCreateInfo){.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
                                           .colorAttachmentCount = (uint32_t)desc->target_count,
                                           .pColorAttachmentFormats = formats,
                                           .depthAttachmentFormat =
                                               desc->depth_test ? AOB_VK_DEPTH_FORMAT : VK_FORMAT_UNDEFINED};
}

/* So that one pipeline serves passes of all sizes. */
static const VkDynamicState area_states[] = {VK_DYNAMIC_STATE_SCISSOR, VK_DYNAMIC_STATE_VIEWPORT};
static const VkPipelineDynamicStateCreateInfo any_area = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
    .dynamicStateCount = AOB_COUNT(area_states),
    .pDynamicStates = area_states,
};
static const VkPipelineViewportStateCreateInfo one_area = {
    .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
    .viewportCount = 1,
    .scissorCount = 1,
};

static bool create(struct vk *vk, const struct aob_gpu_pass_desc *desc, VkPipelineLayout layout,
                   VkPipeline *pipeline, struct aob_error *error)
{
    const struct vk_program *program = (const struct vk_program *)desc->program;
    VkPipelineShaderStageCreateInfo stages[] = {
        describe_stage(VK_SHADER_STAGE_VERTEX_BIT, program->vertex ? program->vertex : vk->triangle),
        describe_stage(VK_SHADER_STAGE_FRAGMENT_BIT, program->fragment),
    };
    VkFormat formats[AOB_MAX_OUT];
    VkPipelineColorBlendAttachmentState outputs[AOB_MAX_OUT];
    VkPipelineRenderingCreateInfo targets = describe_targets(desc, formats);
    VkPipelineColorBlendStateCreateInfo output = describe_output(desc, outputs);
    VkGraphicsPipelineCreateInfo info = {
        .sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
        .pNext = &targets,
        .stageCount = AOB_COUNT(stages),
        .pStages = stages,
        .pVertexInputState = &no_vertices,
        .pInputAssemblyState = &triangles,
        .pViewportState = &one_area,
        .pRasterizationState = &fill,
        .pMultisampleState = &one_sample,
        .pDepthStencilState = desc->depth_test ? &greater_wins : NULL,
        .pColorBlendState = &output,
        .pDynamicState = &any_area,
        .layout = layout,
    };
    return aob_vk_ok(vk, vkCreateGraphicsPipelines(vk->device, NULL, 1, &info, NULL, pipeline),
                     "create a pipeline", error);
}

/* Cleared first, so that its padding and unused formats compare equal. */
static void describe_kind(const struct aob_gpu_pass_desc *desc, struct vk_pipeline_kind *kind)
{
    memset(kind, 0, sizeof *kind);
    for (size_t i = 0; i < desc->target_count; i++)
        kind->formats[i] = aob_vk_format(desc->targets[i].texture->format);
    for (size_t i = 0; i < desc->bind_count; i++) {
        uint32_t bit = 1u << desc->binds[i].binding;
        if (desc->binds[i].kind == AOB_GPU_STORAGE)
            kind->stored |= bit;
        else
            kind->sampled |= bit;
    }
    kind->target_count = (uint32_t)desc->target_count;
    kind->uniforms = desc->uniforms ? 1 : 0;
    kind->storage = desc->storage ? 1 : 0;
    kind->depth_test = desc->depth_test;
    kind->blend = desc->blend;
}

bool aob_vk_pipeline_lend(struct vk *vk, const struct aob_gpu_pass_desc *desc, VkPipelineLayout layout,
                          VkPipeline *pipeline, struct aob_error *error)
{
    /* A program is const to passes, which know nothing of what it keeps for them. */
    struct vk_program *program = (struct vk_program *)(uintptr_t)desc->program;
    struct vk_pipeline_kind kind;
    describe_kind(desc, &kind);
    for (size_t i = 0; i < program->pipeline_count; i++)
        if (memcmp(&program->pipelines[i].kind, &kind, sizeof kind) == 0) {
            *pipeline = program->pipelines[i].pipeline;
            return true;
        }
    if (!create(vk, desc, layout, pipeline, error)) {
        vkDestroyPipeline(vk->device, *pipeline, NULL);
        return false;
    }
    program->pipelines =
        aob_realloc(program->pipelines, program->pipeline_count + 1, sizeof *program->pipelines);
    program->pipelines[program->pipeline_count++] = (struct vk_pipeline){kind, *pipeline};
    return true;
}
