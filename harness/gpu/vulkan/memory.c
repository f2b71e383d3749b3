#include "vk.h"

static bool find_type(const struct vk *vk, uint32_t allowed, VkMemoryPropertyFlags wanted, uint32_t *type)
{
    for (uint32_t i = 0; i < vk->memory.memoryTypeCount; i++) {
        if ((allowed >> i & 1) && (vk->memory.memoryTypes[i].propertyFlags & wanted) == wanted) {
            *type = i;
            return true;
        }
    }
    return false;
}

bool aob_vk_allocate(struct vk *vk, const VkMemoryRequirements *needs, VkMemoryPropertyFlags wanted,
                     VkDeviceMemory *memory, struct aob_error *error)
{
    /* Reads from memory that the host does not cache are slow, but it need not exist. */
    uint32_t type;
    if (!find_type(vk, needs->memoryTypeBits, wanted | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, &type) &&
        !find_type(vk, needs->memoryTypeBits, wanted, &type))
        return aob_fail(error, "vulkan: %s has no memory of the kind needed: use another device or backend",
                        vk->properties.deviceName);
    VkMemoryAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                     .allocationSize = needs->size,
                                     .memoryTypeIndex = type};
    return aob_vk_ok(vk, vkAllocateMemory(vk->device, &allocate, NULL, memory), "allocate memory", error);
}

bool aob_vk_buffer_init(struct vk *vk, size_t size, VkBufferUsageFlags usage, struct vk_buffer *buffer,
                        struct aob_error *error)
{
    *buffer = (struct vk_buffer){0};
    VkBufferCreateInfo create = {.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size, .usage = usage};
    if (!aob_vk_ok(vk, vkCreateBuffer(vk->device, &create, NULL, &buffer->buffer), "create a buffer", error))
        goto error;
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(vk->device, buffer->buffer, &needs);
    const VkMemoryPropertyFlags host =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    if (!aob_vk_allocate(vk, &needs, host, &buffer->memory, error) ||
        !aob_vk_ok(vk, vkBindBufferMemory(vk->device, buffer->buffer, buffer->memory, 0), "bind a buffer",
                   error) ||
        !aob_vk_ok(vk, vkMapMemory(vk->device, buffer->memory, 0, VK_WHOLE_SIZE, 0, &buffer->map),
                   "map a buffer", error))
        goto error;
    return true;
error:
    aob_vk_buffer_finish(vk, buffer);
    return false;
}

void aob_vk_buffer_finish(struct vk *vk, struct vk_buffer *buffer)
{
    vkDestroyBuffer(vk->device, buffer->buffer, NULL);
    vkFreeMemory(vk->device, buffer->memory, NULL);
    *buffer = (struct vk_buffer){0};
}
