#include "gl.h"

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

static const char *explain(GLenum code)
{
    switch (code) {
    case GL_OUT_OF_MEMORY:
        return "out of memory";
    case GL_INVALID_ENUM:
        return "invalid enumerator";
    case GL_INVALID_VALUE:
        return "invalid value";
    case GL_INVALID_OPERATION:
        return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "incomplete framebuffer";
    default:
        return "context lost or unknown error";
    }
}

bool aob_gl_ok(struct aob_gpu *gpu, const char *what, struct aob_error *error)
{
    GLenum code = ((struct gl *)gpu)->api.GetError();
    return code == GL_NO_ERROR ||
           aob_fail(error, "%s: cannot %s: %s (GL error 0x%x)", gpu->info.backend, what, explain(code), code);
}

const struct gl_api *aob_gl_use(struct aob_gpu *gpu)
{
    struct gl *gl = (struct gl *)gpu;
    gl->context->fns->make_current(gl->context);
    return &gl->api;
}
