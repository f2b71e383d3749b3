#include "gl.h"
#include "base/memory.h"
#include <stdlib.h>

bool aob_gl_buffer_create(struct aob_gpu *gpu, size_t size, struct aob_gpu_buffer **buffer,
                          struct aob_error *error)
{
    const struct gl_api *api = aob_gl_use(gpu);
    struct gl_buffer *made = AOB_NEW(struct gl_buffer);
    api->CreateBuffers(1, &made->name);
    api->NamedBufferStorage(made->name, (GLsizeiptr)size, NULL, GL_DYNAMIC_STORAGE_BIT);
    if (aob_gl_ok(gpu, "create a storage buffer", error)) {
        *buffer = &made->base;
        return true;
    }
    aob_gl_buffer_destroy(gpu, &made->base);
    return aob_fail_in(error, "storage buffer of %zu bytes", size);
}

void aob_gl_buffer_destroy(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer)
{
    struct gl_buffer *made = (struct gl_buffer *)buffer;
    aob_gl_use(gpu)->DeleteBuffers(1, &made->name);
    free(made);
}

bool aob_gl_buffer_write(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                         const void *bytes, struct aob_error *error)
{
    aob_gl_use(gpu)->NamedBufferSubData(((struct gl_buffer *)buffer)->name, (GLintptr)offset,
                                        (GLsizeiptr)size, bytes);
    return aob_gl_ok(gpu, "write a storage buffer", error);
}

bool aob_gl_buffer_read(struct aob_gpu *gpu, const struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                        void *bytes, struct aob_error *error)
{
    const struct gl_api *api = aob_gl_use(gpu);
    api->MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    api->GetNamedBufferSubData(((const struct gl_buffer *)buffer)->name, (GLintptr)offset, (GLsizeiptr)size,
                               bytes);
    return aob_gl_ok(gpu, "read a storage buffer", error);
}
