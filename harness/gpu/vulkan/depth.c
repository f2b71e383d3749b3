#include "vk.h"

static const VkImageSubresourceRange whole = {VK_IMAGE_ASPECT_DEPTH_BIT, 0, 1, 0, 1};

bool aob_vk_depth_init(struct vk *vk, int width, int height, struct vk_depth *depth, struct aob_error *error)
{
    const struct vk_image_desc desc = {.format = AOB_VK_DEPTH_FORMAT,
                                       .width = width,
                                       .height = height,
                                       .levels = 1,
                                       .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT};
    return (aob_vk_image_init(vk, &desc, &depth->image, error) &&
            aob_vk_view_create(vk, depth->image.image, desc.format, &whole, &depth->view, error)) ||
           aob_fail_in(error, "depth %dx%d", width, height);
}

void aob_vk_depth_finish(struct vk *vk, struct vk_depth *depth)
{
    vkDestroyImageView(vk->device, depth->view, NULL);
    aob_vk_image_finish(vk, &depth->image);
    *depth = (struct vk_depth){0};
}

VkImageMemoryBarrier2 aob_vk_depth_move(const struct vk_depth *depth)
{
    /* From UNDEFINED at every run: each clears it, so that what it held need not be kept. */
    return aob_vk_move(depth->image.image, whole, aob_vk_undefined(aob_vk_depth_state), aob_vk_depth_state);
}
