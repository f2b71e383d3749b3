#include "gpu.h"

const char *aob_gpu_storage_lacks(const struct aob_gpu *gpu)
{
    return gpu->info.draws_nothing    ? "draws nothing"
           : !gpu->info.storage_bytes ? "has fragment programs that cannot write storage buffers"
                                      : NULL;
}

struct aob_gpu_buffer *aob_gpu_buffer_create(struct aob_gpu *gpu, size_t size, struct aob_error *error)
{
    const struct aob_gpu_info *info = &gpu->info;
    struct aob_gpu_buffer *buffer = NULL;
    if (!info->storage_bytes)
        aob_fail(error,
                 "%s: fragment programs of %s cannot write storage buffers: use another device or backend",
                 info->backend, info->device);
    else if (!size || size % 4 || size > info->storage_bytes)
        aob_fail(error, "%s: storage buffer of %zu bytes: must be 4, 8, ... %zu", info->backend, size,
                 info->storage_bytes);
    else if (gpu->fns->buffer_create(gpu, size, &buffer, error))
        buffer->size = size;
    return buffer;
}

void aob_gpu_buffer_destroy(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer)
{
    if (buffer)
        gpu->fns->buffer_destroy(gpu, buffer);
}

static bool check_range(const struct aob_gpu *gpu, const struct aob_gpu_buffer *buffer, size_t offset,
                        size_t size, struct aob_error *error)
{
    return (offset <= buffer->size && size <= buffer->size - offset) ||
           aob_fail(error, "%s: %zu bytes from %zu of a storage buffer of %zu", gpu->info.backend, size,
                    offset, buffer->size);
}

bool aob_gpu_buffer_write(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                          const void *bytes, struct aob_error *error)
{
    return check_range(gpu, buffer, offset, size, error) &&
           gpu->fns->buffer_write(gpu, buffer, offset, size, bytes, error);
}

bool aob_gpu_buffer_read(struct aob_gpu *gpu, const struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                         void *bytes, struct aob_error *error)
{
    return check_range(gpu, buffer, offset, size, error) &&
           gpu->fns->buffer_read(gpu, buffer, offset, size, bytes, error);
}
