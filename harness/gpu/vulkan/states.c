#include "vk.h"

#define SHADERS (VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT)
#define DEPTH   (VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT)

/* It is not known which pass runs after which, so between passes a texture lies in one layout, that of its readers, and is
 * ready for all of them. GENERAL serves all but costs a real GPU its compression; a storage image may be read in no
 * other. A copy needs no place in here: it has a submit of its own, which begins behind everything (commands.c). */
struct vk_state aob_vk_rest(uint32_t uses)
{
    struct vk_state rest = {VK_IMAGE_LAYOUT_UNDEFINED, SHADERS, 0};
    if (uses & AOB_GPU_USE_STORAGE)
        rest.access |= VK_ACCESS_2_SHADER_STORAGE_READ_BIT;
    if (uses & AOB_GPU_USE_SAMPLED)
        rest.access |= VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
    if (!rest.access)
        return uses & AOB_GPU_USE_TARGET ? aob_vk_drawn(AOB_GPU_ADD) : aob_vk_copied_from;
    rest.layout =
        uses & AOB_GPU_USE_STORAGE ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    return rest;
}

struct vk_state aob_vk_drawn(enum aob_gpu_blend blend)
{
    return (struct vk_state){VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                             VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                             VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT |
                                 (blend == AOB_GPU_ADD ? VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT : 0)};
}

const struct vk_state aob_vk_depth_state = {VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, DEPTH,
                                            VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                                                VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT};
const struct vk_state aob_vk_copied_to = {VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_2_COPY_BIT,
                                          VK_ACCESS_2_TRANSFER_WRITE_BIT};
const struct vk_state aob_vk_copied_from = {VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                            VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};

struct vk_state aob_vk_undefined(struct vk_state state)
{
    state.layout = VK_IMAGE_LAYOUT_UNDEFINED;
    return state;
}
