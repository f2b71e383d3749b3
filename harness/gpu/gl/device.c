#include "gl.h"
#include "base/memory.h"
#include "gpu/glsl.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool load_functions(struct gl *gl, struct aob_error *error)
{
    struct gl_context *context = gl->context;
#define X(type, name)                                                                                        \
    gl->api.name = (type)context->fns->find(context, "gl" #name);                                            \
    if (!gl->api.name)                                                                                       \
        return aob_fail(error, "%s: the driver lacks gl%s: it needs OpenGL 4.5 and ARB_gl_spirv",            \
                        gl->base.info.backend, #name);
    AOB_GL_FUNCTIONS(X)
#undef X
    return true;
}

static bool check_extension(struct gl *gl, const char *wanted, struct aob_error *error)
{
    GLint count = 0;
    gl->api.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; i++)
        if (!strcmp((const char *)gl->api.GetStringi(GL_EXTENSIONS, (GLuint)i), wanted))
            return true;
    return aob_fail(error, "%s: %s lacks %s: use a newer driver", gl->base.info.backend, gl->base.info.device,
                    wanted);
}

static bool is_software(const char *renderer)
{
    static const char *const names[] = {"llvmpipe", "softpipe", "swrast"};
    for (size_t i = 0; i < AOB_COUNT(names); i++)
        if (strstr(renderer, names[i]))
            return true;
    return false;
}

void aob_gl_describe(PFNGLGETSTRINGPROC get, struct aob_gpu_device *device)
{
    snprintf(device->name, sizeof device->name, "%s", (const char *)get(GL_RENDERER));
    snprintf(device->driver, sizeof device->driver, "%s, OpenGL %s", (const char *)get(GL_VENDOR),
             (const char *)get(GL_VERSION));
    device->software = is_software(device->name);
    device->device_class = device->software ? "cpu" : "gpu";
}

/* A program that cannot write to a storage buffer has no block for one. */
static size_t storage_bytes(const struct gl_api *api)
{
    GLint blocks = 0;
    GLint64 bytes = 0;
    api->GetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &blocks);
    api->GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return blocks > 0 && bytes > 0 ? (size_t)bytes / 4 * 4 : 0;
}

static void describe(struct gl *gl)
{
    struct aob_gpu_info *info = &gl->base.info;
    aob_gl_describe(gl->api.GetString, &gl->device);
    info->device = gl->device.name;
    info->driver = gl->device.driver;
    info->software = gl->device.software;
    info->device_class = gl->device.device_class;
    info->storage_bytes = storage_bytes(&gl->api);
}

static uint32_t limit(const struct gl *gl, GLenum name)
{
    GLint value = 0;
    gl->api.GetIntegerv(name, &value);
    return value > 0 ? (uint32_t)value : 0;
}

static uint32_t lower_limit(const struct gl *gl, GLenum a, GLenum b)
{
    uint32_t x = limit(gl, a), y = limit(gl, b);
    return x < y ? x : y;
}

static void read_limits(struct gl *gl)
{
    struct aob_gpu_limits *limits = &gl->base.limits;
    *limits = aob_gpu_no_limits;
    limits->side = limit(gl, GL_MAX_TEXTURE_SIZE);
    limits->targets = lower_limit(gl, GL_MAX_DRAW_BUFFERS, GL_MAX_COLOR_ATTACHMENTS);
    limits->sampled = limit(gl, GL_MAX_TEXTURE_IMAGE_UNITS);
    limits->storage = lower_limit(gl, GL_MAX_FRAGMENT_IMAGE_UNIFORMS, GL_MAX_COMBINED_IMAGE_UNIFORMS);
    limits->vertex_sampled = limit(gl, GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS);
    limits->vertex_storage = limit(gl, GL_MAX_VERTEX_IMAGE_UNIFORMS);
    limits->storage_bindings = limit(gl, GL_MAX_IMAGE_UNITS);
    limits->storage_and_targets = limit(gl, GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES);
}

static void create_stamps(struct gl *gl)
{
    gl->api.GetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &gl->stamp_bits);
    gl->api.GenQueries(AOB_COUNT(gl->stamps), gl->stamps);
    gl->base.info.timer = gl->stamp_bits > 0;
}

static void create_samplers(struct gl *gl)
{
    static const GLint filters[] = {[AOB_NEAREST] = GL_NEAREST, [AOB_BILINEAR] = GL_LINEAR};
    static const GLint minifying[] = {
        [AOB_NEAREST] = GL_NEAREST_MIPMAP_NEAREST, [AOB_BILINEAR] = GL_LINEAR_MIPMAP_NEAREST};
    gl->api.CreateSamplers(AOB_COUNT(gl->samplers), gl->samplers);
    for (size_t i = 0; i < AOB_COUNT(gl->samplers); i++) {
        gl->api.SamplerParameteri(gl->samplers[i], GL_TEXTURE_MIN_FILTER, minifying[i]);
        gl->api.SamplerParameteri(gl->samplers[i], GL_TEXTURE_MAG_FILTER, filters[i]);
        gl->api.SamplerParameteri(gl->samplers[i], GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl->api.SamplerParameteri(gl->samplers[i], GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
}

static bool create_triangle(struct gl *gl, struct aob_error *error)
{
    size_t count;
    uint32_t *words =
        aob_glsl_compile(aob_glsl_screen_triangle, AOB_GLSL_VERTEX, AOB_GLSL_OPENGL, &count, error);
    if (!words)
        return false;
    gl->triangle = aob_gl_shader_create(&gl->base, GL_VERTEX_SHADER, words, count, error);
    free(words);
    return gl->triangle;
}

static bool set_up(struct gl *gl, struct aob_error *error)
{
    if (!load_functions(gl, error))
        return false;
    describe(gl);
    if (!check_extension(gl, "GL_ARB_gl_spirv", error))
        return false;
    gl->api.Disable(GL_DITHER);
    gl->api.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    gl->api.DepthFunc(GL_GREATER);
    gl->api.BlendFunc(GL_ONE, GL_ONE);
    gl->api.PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl->api.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    create_stamps(gl);
    create_samplers(gl);
    read_limits(gl);
    gl->api.CreateVertexArrays(1, &gl->vertex_array);
    gl->api.BindVertexArray(gl->vertex_array);
    return create_triangle(gl, error) && aob_gl_ok(&gl->base, "set up the context", error);
}

struct aob_gpu *aob_gl_open(const struct aob_gpu_fns *fns, struct gl_context *context,
                            struct aob_error *error)
{
    if (!context)
        return NULL;
    struct gl *gl = AOB_NEW(struct gl);
    gl->base.fns = fns;
    gl->base.info.backend = fns->name;
    gl->context = context;
    if (set_up(gl, error))
        return &gl->base;
    aob_gl_close(&gl->base);
    return NULL;
}

/* What the device itself made dies with its context. */
void aob_gl_close(struct aob_gpu *gpu)
{
    struct gl *gl = (struct gl *)gpu;
    gl->context->fns->destroy(gl->context);
    free(gl);
}
