#include "vk.h"
#include "base/memory.h"
#include <stdlib.h>
#include <string.h>

bool aob_vk_storage_create(struct aob_gpu *gpu, size_t size, struct aob_gpu_buffer **buffer,
                           struct aob_error *error)
{
    struct vk_storage *made = AOB_NEW(struct vk_storage);
    if (aob_vk_buffer_init((struct vk *)gpu, size, VK_MEMORY_STORAGE, &made->buffer, error)) {
        *buffer = &made->base;
        return true;
    }
    free(made);
    return aob_fail_in(error, "storage buffer of %zu bytes", size);
}

void aob_vk_storage_destroy(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer)
{
    struct vk_storage *made = (struct vk_storage *)buffer;
    aob_vk_buffer_finish((struct vk *)gpu, &made->buffer);
    free(made);
}

/* The memory is coherent, a submit makes what the host wrote before it visible, and ends with a barrier for the host. */
bool aob_vk_storage_write(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                          const void *bytes, struct aob_error *error)
{
    (void)gpu;
    (void)error;
    memcpy((char *)((struct vk_storage *)buffer)->buffer.map + offset, bytes, size);
    return true;
}

bool aob_vk_storage_read(struct aob_gpu *gpu, const struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                         void *bytes, struct aob_error *error)
{
    (void)gpu;
    (void)error;
    memcpy(bytes, (const char *)((const struct vk_storage *)buffer)->buffer.map + offset, size);
    return true;
}
