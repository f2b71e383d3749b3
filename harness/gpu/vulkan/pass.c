#include "vk.h"
#include "base/memory.h"
#include <stdlib.h>
#include <string.h>

struct vk_pass {
    struct aob_gpu_pass base;
    struct vk_binds binds;
    VkImageView targets[AOB_MAX_OUT];
    struct vk_depth depth; /* NULL handles: none */
    VkPipeline pipeline;   /* the program's */
    /* What a run records. */
    VkImageMemoryBarrier2 opening[AOB_MAX_OUT + 1], closing[AOB_MAX_OUT];
    VkRenderingAttachmentInfo outputs[AOB_MAX_OUT], cleared_depth;
    uint32_t opening_count, target_count, first_vertex, vertex_count;
    VkViewport viewport; /* of the whole area; `area` is the part that is drawn */
    VkRect2D area;
};

static bool create_targets(struct vk *vk, const struct aob_gpu_pass_desc *desc, struct vk_pass *pass,
                           struct aob_error *error)
{
    for (size_t i = 0; i < desc->target_count; i++) {
        const struct vk_texture *texture = (const struct vk_texture *)desc->targets[i].texture;
        const VkImageSubresourceRange level = aob_vk_levels(desc->targets[i].level, 1);
        if (!aob_vk_view_create(vk, texture->image.image, aob_vk_format(texture->base.format), &level,
                                &pass->targets[i], error))
            return false;
    }
    return !desc->depth_test || aob_vk_depth_init(vk, desc->width, desc->height, &pass->depth, error);
}

static bool covers(const struct aob_gpu_pass_desc *desc, const struct aob_gpu_target *target)
{
    return desc->width == aob_gpu_level_side(target->texture->width, target->level) &&
           desc->height == aob_gpu_level_side(target->texture->height, target->level);
}

/* From rest to being drawn to. A level that every run draws whole need not keep what it held. */
static void describe_opening(const struct aob_gpu_pass_desc *desc, struct vk_pass *pass)
{
    for (size_t i = 0; i < desc->target_count; i++) {
        const struct aob_gpu_target *target = &desc->targets[i];
        const struct vk_texture *texture = (const struct vk_texture *)target->texture;
        bool whole = covers(desc, target) && !desc->in_parts;
        struct vk_state from = whole ? aob_vk_undefined(texture->rest) : texture->rest;
        pass->opening[pass->opening_count++] = aob_vk_move(
            texture->image.image, aob_vk_levels(target->level, 1), from, aob_vk_drawn(desc->blend));
    }
    if (desc->depth_test)
        pass->opening[pass->opening_count++] = aob_vk_depth_move(&pass->depth);
}

static void describe_closing(const struct aob_gpu_pass_desc *desc, struct vk_pass *pass)
{
    for (size_t i = 0; i < desc->target_count; i++) {
        const struct vk_texture *texture = (const struct vk_texture *)desc->targets[i].texture;
        pass->closing[i] = aob_vk_move(texture->image.image, aob_vk_levels(desc->targets[i].level, 1),
                                       aob_vk_drawn(desc->blend), texture->rest);
    }
}

static void describe_attachments(const struct aob_gpu_pass_desc *desc, struct vk_pass *pass)
{
    for (size_t i = 0; i < desc->target_count; i++)
        pass->outputs[i] = (VkRenderingAttachmentInfo){
            .sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
            .imageView = pass->targets[i],
            .imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
            .loadOp = desc->program->geometry ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_DONT_CARE,
            .storeOp = VK_ATTACHMENT_STORE_OP_STORE};
    pass->cleared_depth = (VkRenderingAttachmentInfo){.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO,
                                                      .imageView = pass->depth.view,
                                                      .imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL,
                                                      .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                                                      .storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE};
}

static void describe_draw(const struct aob_gpu_pass_desc *desc, struct vk_pass *pass)
{
    pass->viewport = (VkViewport){.width = (float)desc->width, .height = (float)desc->height, .maxDepth = 1};
    pass->area.extent = (VkExtent2D){(uint32_t)desc->width, (uint32_t)desc->height};
    pass->target_count = (uint32_t)desc->target_count;
    pass->vertex_count = desc->vertex_count ? desc->vertex_count : 3;
    describe_opening(desc, pass);
    describe_closing(desc, pass);
    describe_attachments(desc, pass);
}

void aob_vk_pass_record(const struct aob_gpu_pass *base, VkCommandBuffer commands)
{
    const struct vk_pass *pass = (const struct vk_pass *)base;
    VkRenderingInfo rendering = {
        .sType = VK_STRUCTURE_TYPE_RENDERING_INFO,
        .renderArea = pass->area,
        .layerCount = 1,
        .colorAttachmentCount = pass->target_count,
        .pColorAttachments = pass->outputs,
        .pDepthAttachment = pass->depth.view ? &pass->cleared_depth : NULL,
    };
    aob_vk_record_moves(commands, pass->opening, pass->opening_count);
    vkCmdBeginRendering(commands, &rendering);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pass->pipeline);
    if (pass->binds.set)
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pass->binds.layout, 0, 1,
                                &pass->binds.set, 0, NULL);
    vkCmdSetViewport(commands, 0, 1, &pass->viewport);
    vkCmdSetScissor(commands, 0, 1, &pass->area);
    vkCmdDraw(commands, pass->vertex_count, 1, pass->first_vertex, 0);
    vkCmdEndRendering(commands);
    aob_vk_record_moves(commands, pass->closing, pass->target_count);
}

bool aob_vk_pass_create(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc, struct aob_gpu_pass **pass,
                        struct aob_error *error)
{
    struct vk *vk = (struct vk *)gpu;
    struct vk_pass *made = AOB_NEW(struct vk_pass);
    if (aob_vk_binds_init(vk, desc, &made->binds, error) &&
        aob_vk_pipeline_lend(vk, desc, made->binds.layout, &made->pipeline, error) &&
        create_targets(vk, desc, made, error)) {
        describe_draw(desc, made);
        *pass = &made->base;
        return true;
    }
    aob_vk_pass_destroy(gpu, &made->base);
    return false;
}

void aob_vk_pass_destroy(struct aob_gpu *gpu, struct aob_gpu_pass *pass)
{
    struct vk *vk = (struct vk *)gpu;
    struct vk_pass *made = (struct vk_pass *)pass;
    for (size_t i = 0; i < AOB_COUNT(made->targets); i++)
        vkDestroyImageView(vk->device, made->targets[i], NULL);
    aob_vk_depth_finish(vk, &made->depth);
    aob_vk_binds_finish(vk, &made->binds);
    free(made);
    aob_vk_destroyed(vk);
}

bool aob_vk_pass_set_uniforms(struct aob_gpu *gpu, struct aob_gpu_pass *pass, const void *block,
                              struct aob_error *error)
{
    (void)gpu;
    (void)error;
    memcpy(((struct vk_pass *)pass)->binds.uniforms.map, block, pass->uniform_size);
    return true;
}

void aob_vk_pass_set_part(struct aob_gpu_pass *base, const struct aob_gpu_part *part)
{
    struct vk_pass *pass = (struct vk_pass *)base;
    pass->area.offset.y = part->row;
    pass->area.extent.height = (uint32_t)part->rows;
    pass->first_vertex = part->first_vertex;
    pass->vertex_count = part->vertex_count ? part->vertex_count : 3;
}
