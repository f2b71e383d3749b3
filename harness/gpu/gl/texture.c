#include "gl.h"
#include "base/memory.h"
#include "gpu/backends.h"
#include <stdlib.h>

/* OpenGL 4.5 has each of our formats for each use. */
const char *aob_gl_lacks(const struct aob_gpu *gpu, enum aob_format format, uint32_t needs)
{
    (void)gpu;
    (void)format;
    (void)needs;
    return NULL;
}

static void upload(const struct gl_api *api, const struct gl_texture *texture, const void *texels)
{
    const struct gl_format *kind = aob_gl_format(texture->base.format);
    api->TextureSubImage2D(texture->name, 0, 0, 0, texture->base.width, texture->base.height, kind->layout,
                           kind->type, texels);
}

bool aob_gl_texture_write(struct aob_gpu *gpu, struct aob_gpu_texture *texture, const void *texels,
                          struct aob_error *error)
{
    upload(aob_gl_use(gpu), (const struct gl_texture *)texture, texels);
    return aob_gl_ok(gpu, "write the texture", error);
}

bool aob_gl_texture_create(struct aob_gpu *gpu, const struct aob_gpu_texture_desc *desc,
                           struct aob_gpu_texture **texture, struct aob_error *error)
{
    const struct gl_api *api = aob_gl_use(gpu);
    const struct gl_format *kind = aob_gl_format(desc->format);
    GLsizei width = desc->width, height = desc->height;
    struct gl_texture *made = AOB_NEW(struct gl_texture);
    made->base = aob_gpu_texture_base(desc);
    api->CreateTextures(GL_TEXTURE_2D, 1, &made->name);
    api->TextureStorage2D(made->name, made->base.levels, kind->internal, width, height);
    if (desc->texels)
        upload(api, made, desc->texels);
    if (aob_gl_ok(gpu, "create the texture", error)) {
        *texture = &made->base;
        return true;
    }
    aob_gl_texture_destroy(gpu, &made->base);
    return aob_fail_in(error, "texture %dx%d %s", width, height, aob_gpu_format_layout(desc->format));
}

void aob_gl_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture)
{
    struct gl_texture *made = (struct gl_texture *)texture;
    aob_gl_use(gpu)->DeleteTextures(1, &made->name);
    free(made);
}

bool aob_gl_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, int level, void *texels,
                         struct aob_error *error)
{
    const struct gl_format *kind = aob_gl_format(texture->format);
    size_t size = aob_gpu_level_bytes(texture, level);
    /* GL counts bytes in an int; the size still matters to a driver with robust access. */
    GLsizei room = size > INT32_MAX ? INT32_MAX : (GLsizei)size;
    aob_gl_use(gpu)->GetTextureImage(((const struct gl_texture *)texture)->name, level, kind->layout,
                                     kind->type, room, texels);
    return aob_gl_ok(gpu, "read the texture", error);
}
