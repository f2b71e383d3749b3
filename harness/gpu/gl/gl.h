/* The GL backends' own types: OpenGL 4.5 core with ARB_gl_spirv; egl.c and osmesa.c differ in how a context
 * comes to be and share the rest. Every GL call goes through a device's own table, so that two drivers can
 * live in one process. */
#ifndef AOB_GPU_GL_GL_H
#define AOB_GPU_GL_GL_H
#include <GL/glcorearb.h>
#include "gpu/gpu.h"

#define AOB_GL_FUNCTIONS(X)                                                                                  \
    X(PFNGLGETERRORPROC, GetError)                                                                           \
    X(PFNGLGETSTRINGPROC, GetString)                                                                         \
    X(PFNGLGETSTRINGIPROC, GetStringi)                                                                       \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                                     \
    X(PFNGLENABLEPROC, Enable)                                                                               \
    X(PFNGLDISABLEPROC, Disable)                                                                             \
    X(PFNGLFINISHPROC, Finish)                                                                               \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                                                                     \
    X(PFNGLVIEWPORTPROC, Viewport)                                                                           \
    X(PFNGLSCISSORPROC, Scissor)                                                                             \
    X(PFNGLCLIPCONTROLPROC, ClipControl)                                                                     \
    X(PFNGLCREATETEXTURESPROC, CreateTextures)                                                               \
    X(PFNGLGENTEXTURESPROC, GenTextures)                                                                     \
    X(PFNGLTEXTUREVIEWPROC, TextureView)                                                                     \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                                               \
    X(PFNGLTEXTURESTORAGE2DPROC, TextureStorage2D)                                                           \
    X(PFNGLTEXTURESUBIMAGE2DPROC, TextureSubImage2D)                                                         \
    X(PFNGLGETTEXTUREIMAGEPROC, GetTextureImage)                                                             \
    X(PFNGLBINDTEXTUREUNITPROC, BindTextureUnit)                                                             \
    X(PFNGLBINDIMAGETEXTUREPROC, BindImageTexture)                                                           \
    X(PFNGLCREATESAMPLERSPROC, CreateSamplers)                                                               \
    X(PFNGLSAMPLERPARAMETERIPROC, SamplerParameteri)                                                         \
    X(PFNGLBINDSAMPLERPROC, BindSampler)                                                                     \
    X(PFNGLCREATEBUFFERSPROC, CreateBuffers)                                                                 \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                                                 \
    X(PFNGLNAMEDBUFFERSTORAGEPROC, NamedBufferStorage)                                                       \
    X(PFNGLNAMEDBUFFERSUBDATAPROC, NamedBufferSubData)                                                       \
    X(PFNGLGETNAMEDBUFFERSUBDATAPROC, GetNamedBufferSubData)                                                 \
    X(PFNGLMEMORYBARRIERPROC, MemoryBarrier)                                                                 \
    X(PFNGLGETINTEGER64VPROC, GetInteger64v)                                                                 \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                                                               \
    X(PFNGLCREATESHADERPROC, CreateShader)                                                                   \
    X(PFNGLDELETESHADERPROC, DeleteShader)                                                                   \
    X(PFNGLSHADERBINARYPROC, ShaderBinary)                                                                   \
    X(PFNGLSPECIALIZESHADERPROC, SpecializeShaderARB)                                                        \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                                                                     \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                                                           \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                                                 \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                                                 \
    X(PFNGLATTACHSHADERPROC, AttachShader)                                                                   \
    X(PFNGLDETACHSHADERPROC, DetachShader)                                                                   \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                                     \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                                   \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                                                         \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                                                       \
    X(PFNGLCREATEFRAMEBUFFERSPROC, CreateFramebuffers)                                                       \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                                       \
    X(PFNGLNAMEDFRAMEBUFFERTEXTUREPROC, NamedFramebufferTexture)                                             \
    X(PFNGLNAMEDFRAMEBUFFERDRAWBUFFERSPROC, NamedFramebufferDrawBuffers)                                     \
    X(PFNGLCHECKNAMEDFRAMEBUFFERSTATUSPROC, CheckNamedFramebufferStatus)                                     \
    X(PFNGLCLEARNAMEDFRAMEBUFFERFVPROC, ClearNamedFramebufferfv)                                             \
    X(PFNGLCREATERENDERBUFFERSPROC, CreateRenderbuffers)                                                     \
    X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)                                                     \
    X(PFNGLNAMEDRENDERBUFFERSTORAGEPROC, NamedRenderbufferStorage)                                           \
    X(PFNGLNAMEDFRAMEBUFFERRENDERBUFFERPROC, NamedFramebufferRenderbuffer)                                   \
    X(PFNGLDEPTHFUNCPROC, DepthFunc)                                                                         \
    X(PFNGLBLENDFUNCPROC, BlendFunc)                                                                         \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                             \
    X(PFNGLCREATEVERTEXARRAYSPROC, CreateVertexArrays)                                                       \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                             \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                                                                       \
    X(PFNGLGENQUERIESPROC, GenQueries)                                                                       \
    X(PFNGLGETQUERYIVPROC, GetQueryiv)                                                                       \
    X(PFNGLQUERYCOUNTERPROC, QueryCounter)                                                                   \
    X(PFNGLGETQUERYOBJECTUI64VPROC, GetQueryObjectui64v)

struct gl_api {
#define X(type, name) type name;
    AOB_GL_FUNCTIONS(X)
#undef X
};

typedef void (*gl_function)(void);

struct gl_context { /* first member of egl.c's and osmesa.c's own; one table each */
    const struct gl_context_fns *fns;
};
struct gl_context_fns {
    void (*destroy)(struct gl_context *context);
    bool (*make_current)(struct gl_context *context);
    gl_function (*find)(struct gl_context *context, const char *name);
};

struct gl {
    struct aob_gpu base;
    struct gl_context *context;
    struct gl_api api;
    GLuint samplers[2]; /* by enum aob_filter */
    GLuint vertex_array, triangle;
    GLint stamp_bits;                          /* valid bits of a timestamp; 0: the driver has no timer */
    GLuint stamps[2 * AOB_GPU_SUBMIT_MAX + 2]; /* before and behind each pass, and the whole */
    struct aob_gpu_device device;
};

struct gl_texture {
    struct aob_gpu_texture base;
    GLuint name;
};

struct gl_buffer {
    struct aob_gpu_buffer base;
    GLuint name;
};

struct gl_program {
    struct aob_gpu_program base;
    GLuint name;
};

/* device.c. Takes the context, which is current, also where it fails; NULL where that is NULL. */
struct aob_gpu *aob_gl_open(const struct aob_gpu_fns *fns, struct gl_context *context,
                            struct aob_error *error);

/* What a current context says of its device: name, driver, class, software. `get` is its glGetString. */
void aob_gl_describe(PFNGLGETSTRINGPROC get, struct aob_gpu_device *device);
void aob_gl_close(struct aob_gpu *gpu);

/* call.c. aob_gl_use makes the device's context current and gives its functions. */
const struct gl_api *aob_gl_use(struct aob_gpu *gpu);

/* True if GL reports no error; else one line: "gl-egl: cannot WHAT: why". */
bool aob_gl_ok(struct aob_gpu *gpu, const char *what, struct aob_error *error);

struct gl_format {
    GLenum internal, layout, type;
};
const struct gl_format *aob_gl_format(enum aob_format format);

/* program.c. A shader's name, or 0 after one line. */
GLuint aob_gl_shader_create(struct aob_gpu *gpu, GLenum stage, const uint32_t *words, size_t word_count,
                            struct aob_error *error);

/* The table's slots that both backends share. */
const char *aob_gl_lacks(const struct aob_gpu *gpu, enum aob_format format, uint32_t needs);
bool aob_gl_texture_create(struct aob_gpu *gpu, const struct aob_gpu_texture_desc *desc,
                           struct aob_gpu_texture **texture, struct aob_error *error);
void aob_gl_texture_destroy(struct aob_gpu *gpu, struct aob_gpu_texture *texture);
bool aob_gl_texture_read(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, int level, void *texels,
                         struct aob_error *error);
bool aob_gl_texture_write(struct aob_gpu *gpu, struct aob_gpu_texture *texture, const void *texels,
                          struct aob_error *error);
bool aob_gl_buffer_create(struct aob_gpu *gpu, size_t size, struct aob_gpu_buffer **buffer,
                          struct aob_error *error);
void aob_gl_buffer_destroy(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer);
bool aob_gl_buffer_write(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                         const void *bytes, struct aob_error *error);
bool aob_gl_buffer_read(struct aob_gpu *gpu, const struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                        void *bytes, struct aob_error *error);
bool aob_gl_program_create(struct aob_gpu *gpu, const struct aob_gpu_program_desc *desc,
                           struct aob_gpu_program **program, struct aob_error *error);
void aob_gl_program_destroy(struct aob_gpu *gpu, struct aob_gpu_program *program);
bool aob_gl_pass_create(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc, struct aob_gpu_pass **pass,
                        struct aob_error *error);
void aob_gl_pass_destroy(struct aob_gpu *gpu, struct aob_gpu_pass *pass);
bool aob_gl_pass_set_uniforms(struct aob_gpu *gpu, struct aob_gpu_pass *pass, const void *block,
                              struct aob_error *error);
void aob_gl_pass_set_part(struct aob_gpu_pass *pass, const struct aob_gpu_part *part);
bool aob_gl_run(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                struct aob_gpu_time *whole, struct aob_error *error);

/* pass.c, for run.c: bind comes before draw. */
void aob_gl_pass_bind(const struct gl *gl, const struct aob_gpu_pass *pass);
void aob_gl_pass_draw(const struct gl *gl, const struct aob_gpu_pass *pass);

#define AOB_GL_SLOTS                                                                                         \
    .environment = aob_gpu_driver_environment, .close = aob_gl_close, .format_lacks = aob_gl_lacks,          \
    .texture_create = aob_gl_texture_create, .texture_destroy = aob_gl_texture_destroy,                      \
    .texture_read = aob_gl_texture_read, .texture_write = aob_gl_texture_write,                              \
    .buffer_create = aob_gl_buffer_create, .buffer_destroy = aob_gl_buffer_destroy,                          \
    .buffer_write = aob_gl_buffer_write, .buffer_read = aob_gl_buffer_read,                                  \
    .program_create = aob_gl_program_create, .program_destroy = aob_gl_program_destroy,                      \
    .pass_create = aob_gl_pass_create, .pass_destroy = aob_gl_pass_destroy,                                  \
    .pass_set_uniforms = aob_gl_pass_set_uniforms, .pass_set_part = aob_gl_pass_set_part, .run = aob_gl_run
#endif
