#include "gl.h"
#include "base/memory.h"
#include <stdlib.h>

static const struct gl_format formats[AOB_FORMAT_COUNT] = {
    [AOB_R8] = {GL_R8, GL_RED, GL_UNSIGNED_BYTE},
    [AOB_R16] = {GL_R16, GL_RED, GL_UNSIGNED_SHORT},
    [AOB_R16F] = {GL_R16F, GL_RED, GL_HALF_FLOAT},
    [AOB_R32F] = {GL_R32F, GL_RED, GL_FLOAT},
    [AOB_RG8] = {GL_RG8, GL_RG, GL_UNSIGNED_BYTE},
    [AOB_RG16F] = {GL_RG16F, GL_RG, GL_HALF_FLOAT},
    [AOB_RG32F] = {GL_RG32F, GL_RG, GL_FLOAT},
    [AOB_RGBA8] = {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
    [AOB_RGBA16F] = {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT},
    [AOB_RGBA32F] = {GL_RGBA32F, GL_RGBA, GL_FLOAT},
};

const struct gl_format *aob_gl_format(enum aob_format format)
{
    return &formats[format];
}

bool aob_gl_texture_create(struct aob_gpu *gpu, enum aob_format format, int width, int height,
                           const void *texels, struct aob_gpu_texture **texture, struct aob_error *error)
{
    const struct gl_api *api = aob_gl_use(gpu);
    const struct gl_format *kind = &formats[format];
    GLint limit = ((struct gl *)gpu)->max_texture_size;
    if (width > limit || height > limit)
        return aob_fail(error, "%s: texture size %dx%d is beyond this device's %d", gpu->info.backend, width,
                        height, limit);
    struct gl_texture *made = AOB_NEW(struct gl_texture);
    made->base = (struct aob_gpu_texture){.format = format, .width = width, .height = height};
    api->CreateTextures(GL_TEXTURE_2D, 1, &made->name);
    api->TextureStorage2D(made->name, 1, kind->internal, width, height);
    if (texels)
        api->TextureSubImage2D(made->name, 0, 0, 0, width, height, kind->layout, kind->type, texels);
    if (aob_gl_ok(gpu, "create the texture", error)) {
        *texture = &made->base;
        return true;
    }
    aob_gl_texture_destroy(gpu, &made->base);
    return aob_fail_in(error, "texture %dx%d %s", width, height, aob_gpu_format_layout(format));
}

void aob_gl_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture)
{
    struct gl_texture *made = (struct gl_texture *)texture;
    aob_gl_use(gpu)->DeleteTextures(1, &made->name);
    free(made);
}

bool aob_gl_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, void *texels,
                         struct aob_error *error)
{
    const struct gl_format *kind = &formats[texture->format];
    size_t size = (size_t)texture->width * (size_t)texture->height * aob_gpu_texel_size(texture->format);
    /* GL counts bytes in an int; the size still matters to a driver with robust access. */
    GLsizei room = size > INT32_MAX ? INT32_MAX : (GLsizei)size;
    aob_gl_use(gpu)->GetTextureImage(((const struct gl_texture *)texture)->name, 0, kind->layout, kind->type,
                                     room, texels);
    return aob_gl_ok(gpu, "read the texture", error);
}
