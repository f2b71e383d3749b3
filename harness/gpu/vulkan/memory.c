#include "vk.h"
#include "base/memory.h"

#define DEVICE VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT
#define HOST   (VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT)
#define CACHED VK_MEMORY_PROPERTY_HOST_CACHED_BIT

/* Memory of these kinds is slow or refused where it was not asked for. */
static const VkMemoryPropertyFlags never =
    VK_MEMORY_PROPERTY_PROTECTED_BIT | VK_MEMORY_PROPERTY_LAZILY_ALLOCATED_BIT |
    VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD | VK_MEMORY_PROPERTY_DEVICE_UNCACHED_BIT_AMD |
    VK_MEMORY_PROPERTY_RDMA_CAPABLE_BIT_NV;

/* For each use the best first: what the type has, and what it has not. */
static const struct {
    VkMemoryPropertyFlags has, lacks;
} wishes[][3] = {
    [VK_MEMORY_IMAGE] = {{DEVICE, HOST}, {DEVICE, 0}, {0, 0}},
    [VK_MEMORY_UNIFORMS] = {{DEVICE | HOST, 0}, {HOST, 0}, {HOST, 0}},
    [VK_MEMORY_UPLOAD] = {{HOST, DEVICE}, {HOST, 0}, {HOST, 0}},
    [VK_MEMORY_DOWNLOAD] = {{HOST | CACHED, DEVICE}, {HOST | CACHED, 0}, {HOST, 0}},
    [VK_MEMORY_STORAGE] = {{HOST | CACHED, DEVICE}, {HOST | CACHED, 0}, {HOST, 0}},
};

static bool find_type(const VkPhysicalDeviceMemoryProperties *memory, uint32_t allowed,
                      VkMemoryPropertyFlags has, VkMemoryPropertyFlags lacks, uint32_t *type)
{
    for (uint32_t i = 0; i < memory->memoryTypeCount; i++) {
        VkMemoryPropertyFlags flags = memory->memoryTypes[i].propertyFlags;
        if ((allowed >> i & 1) && (flags & has) == has && !(flags & (lacks | never))) {
            *type = i;
            return true;
        }
    }
    return false;
}

bool aob_vk_memory_choose(const VkPhysicalDeviceMemoryProperties *memory, uint32_t allowed,
                          enum vk_memory_use use, uint32_t *type)
{
    for (size_t i = 0; i < AOB_COUNT(wishes[use]); i++)
        if (find_type(memory, allowed, wishes[use][i].has, wishes[use][i].lacks, type))
            return true;
    return false;
}

bool aob_vk_allocate(struct vk *vk, const VkMemoryRequirements *needs, enum vk_memory_use use,
                     VkDeviceMemory *memory, struct aob_error *error)
{
    uint32_t type;
    if (!aob_vk_memory_choose(&vk->memory, needs->memoryTypeBits, use, &type))
        return aob_fail(error, "vulkan: %s has no memory of the kind needed: use another device or backend",
                        vk->properties.deviceName);
    VkMemoryAllocateInfo allocate = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                     .allocationSize = needs->size,
                                     .memoryTypeIndex = type};
    return aob_vk_ok(vk, vkAllocateMemory(vk->device, &allocate, NULL, memory), "allocate memory", error);
}

bool aob_vk_buffer_init(struct vk *vk, size_t size, enum vk_memory_use use, struct vk_buffer *buffer,
                        struct aob_error *error)
{
    static const VkBufferUsageFlags usages[] = {
        [VK_MEMORY_UNIFORMS] = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT,
        [VK_MEMORY_UPLOAD] = VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
        [VK_MEMORY_DOWNLOAD] = VK_BUFFER_USAGE_TRANSFER_DST_BIT,
        [VK_MEMORY_STORAGE] = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
    };
    *buffer = (struct vk_buffer){0};
    VkBufferCreateInfo create = {
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size, .usage = usages[use]};
    if (!aob_vk_ok(vk, vkCreateBuffer(vk->device, &create, NULL, &buffer->buffer), "create a buffer", error))
        goto error;
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(vk->device, buffer->buffer, &needs);
    if (!aob_vk_allocate(vk, &needs, use, &buffer->memory, error) ||
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
