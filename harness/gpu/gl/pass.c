#include "gl.h"
#include "base/memory.h"
#include "gpu/backends.h"
#include <stdlib.h>
#include <string.h>

struct gl_pass {
    struct aob_gpu_pass base;
    GLuint framebuffer, uniforms, storage, program, depth; /* depth 0: no test */
    struct aob_gpu_bind *binds;
    GLuint *views; /* by bind: of the levels that a sampled one shows, else 0 */
    size_t bind_count;
    GLint width, height;
    GLint row, rows; /* that are drawn */
    bool part;       /* the area is less than its targets, or may be drawn in parts */
    GLint first_vertex;
    GLsizei vertices;
    bool add;
    GLint clears; /* targets */
};

static void create_framebuffer(const struct gl_api *api, const struct aob_gpu_pass_desc *desc,
                               struct gl_pass *pass)
{
    GLenum buffers[AOB_MAX_OUT];
    const struct aob_gpu_target *first = &desc->targets[0];
    api->CreateFramebuffers(1, &pass->framebuffer);
    for (size_t i = 0; i < desc->target_count; i++) {
        const struct gl_texture *texture = (const struct gl_texture *)desc->targets[i].texture;
        buffers[i] = GL_COLOR_ATTACHMENT0 + (GLenum)i;
        api->NamedFramebufferTexture(pass->framebuffer, buffers[i], texture->name, desc->targets[i].level);
    }
    api->NamedFramebufferDrawBuffers(pass->framebuffer, (GLsizei)desc->target_count, buffers);
    pass->width = desc->width;
    pass->height = pass->rows = desc->height;
    pass->part = desc->in_parts || desc->width < aob_gpu_level_side(first->texture->width, first->level) ||
                 desc->height < aob_gpu_level_side(first->texture->height, first->level);
}

/* A view, not the texture's own range of levels: two passes may bind one texture, each with a range of its own, and
 * a range that changes between them would be work for the driver within the time of a run. */
static void create_views(const struct gl_api *api, struct gl_pass *pass)
{
    for (size_t i = 0; i < pass->bind_count; i++) {
        const struct aob_gpu_bind *bind = &pass->binds[i];
        if (bind->kind != AOB_GPU_SAMPLED)
            continue;
        api->GenTextures(1, &pass->views[i]);
        api->TextureView(pass->views[i], GL_TEXTURE_2D, ((const struct gl_texture *)bind->texture)->name,
                         aob_gl_format(bind->texture->format)->internal, (GLuint)bind->first_level,
                         (GLuint)aob_gpu_bind_levels(bind), 0, 1);
    }
}

static void create_depth(const struct gl_api *api, struct gl_pass *pass)
{
    api->CreateRenderbuffers(1, &pass->depth);
    api->NamedRenderbufferStorage(pass->depth, GL_DEPTH_COMPONENT32F, pass->width, pass->height);
    api->NamedFramebufferRenderbuffer(pass->framebuffer, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, pass->depth);
}

static void create_uniforms(const struct gl_api *api, const struct aob_gpu_pass_desc *desc,
                            struct gl_pass *pass)
{
    /* std140 rounds a block up to 16 bytes, and its reader may not. */
    size_t size = (desc->uniform_size + 15) / 16 * 16;
    unsigned char *block = aob_alloc(size, 1);
    memcpy(block, desc->uniforms, desc->uniform_size);
    api->CreateBuffers(1, &pass->uniforms);
    api->NamedBufferStorage(pass->uniforms, (GLsizeiptr)size, block, GL_DYNAMIC_STORAGE_BIT);
    free(block);
}

static struct gl_pass *describe_pass(const struct aob_gpu_pass_desc *desc)
{
    struct gl_pass *made = AOB_NEW(struct gl_pass);
    made->program = ((const struct gl_program *)desc->program)->name;
    made->bind_count = desc->bind_count;
    made->binds = AOB_NEW_ARRAY(struct aob_gpu_bind, desc->bind_count);
    made->views = AOB_NEW_ARRAY(GLuint, desc->bind_count);
    for (size_t i = 0; i < desc->bind_count; i++)
        made->binds[i] = desc->binds[i];
    made->vertices = desc->vertex_count ? (GLsizei)desc->vertex_count : 3;
    made->storage = desc->storage ? ((const struct gl_buffer *)desc->storage)->name : 0;
    made->add = desc->blend == AOB_GPU_ADD;
    made->clears = desc->program->geometry ? (GLint)desc->target_count : 0;
    return made;
}

bool aob_gl_pass_create(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc, struct aob_gpu_pass **pass,
                        struct aob_error *error)
{
    const struct gl_api *api = aob_gl_use(gpu);
    struct gl_pass *made = describe_pass(desc);
    create_framebuffer(api, desc, made);
    create_views(api, made);
    if (desc->depth_test)
        create_depth(api, made);
    if (desc->uniforms)
        create_uniforms(api, desc, made);
    if (api->CheckNamedFramebufferStatus(made->framebuffer, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        aob_fail(error, "%s: the driver cannot draw to these targets together", gpu->info.backend);
    else if (aob_gl_ok(gpu, "create a pass", error)) {
        *pass = &made->base;
        return true;
    }
    aob_gl_pass_destroy(gpu, &made->base);
    return false;
}

void aob_gl_pass_destroy(struct aob_gpu *gpu, struct aob_gpu_pass *pass)
{
    const struct gl_api *api = aob_gl_use(gpu);
    struct gl_pass *made = (struct gl_pass *)pass;
    api->DeleteFramebuffers(1, &made->framebuffer);
    api->DeleteRenderbuffers(1, &made->depth);
    api->DeleteBuffers(1, &made->uniforms);
    api->DeleteTextures((GLsizei)made->bind_count, made->views);
    free(made->views);
    free(made->binds);
    free(made);
}

bool aob_gl_pass_set_uniforms(struct aob_gpu *gpu, struct aob_gpu_pass *pass, const void *block,
                              struct aob_error *error)
{
    struct gl_pass *made = (struct gl_pass *)pass;
    aob_gl_use(gpu)->NamedBufferSubData(made->uniforms, 0, (GLsizeiptr)pass->uniform_size, block);
    return aob_gl_ok(gpu, "set a pass's uniforms", error);
}

static void bind_texture(const struct gl *gl, const struct aob_gpu_bind *bind, GLuint view)
{
    if (bind->kind == AOB_GPU_STORAGE) {
        gl->api.BindImageTexture(bind->binding, ((const struct gl_texture *)bind->texture)->name,
                                 bind->first_level, GL_FALSE, 0, GL_READ_ONLY,
                                 aob_gl_format(bind->texture->format)->internal);
    } else {
        gl->api.BindTextureUnit(bind->binding, view);
        gl->api.BindSampler(bind->binding, gl->samplers[bind->filter]);
    }
}

static void set_switch(const struct gl_api *api, GLenum what, bool on)
{
    if (on)
        api->Enable(what);
    else
        api->Disable(what);
}

static void clear_targets(const struct gl_api *api, const struct gl_pass *pass)
{
    static const GLfloat zero[4];
    for (GLint i = 0; i < pass->clears; i++)
        api->ClearNamedFramebufferfv(pass->framebuffer, GL_COLOR, i, zero);
    if (pass->depth)
        api->ClearNamedFramebufferfv(pass->framebuffer, GL_DEPTH, 0, zero);
}

void aob_gl_pass_bind(const struct gl *gl, const struct aob_gpu_pass *base)
{
    const struct gl_pass *pass = (const struct gl_pass *)base;
    gl->api.BindFramebuffer(GL_DRAW_FRAMEBUFFER, pass->framebuffer);
    gl->api.Viewport(0, 0, pass->width, pass->height);
    gl->api.Scissor(0, pass->row, pass->width, pass->rows);
    set_switch(&gl->api, GL_SCISSOR_TEST, pass->part); /* clearing knows no viewport */
    gl->api.UseProgram(pass->program);
    set_switch(&gl->api, GL_DEPTH_TEST, pass->depth);
    set_switch(&gl->api, GL_BLEND, pass->add);
    if (pass->uniforms)
        gl->api.BindBufferBase(GL_UNIFORM_BUFFER, 0, pass->uniforms);
    if (pass->storage)
        gl->api.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, pass->storage);
    for (size_t i = 0; i < pass->bind_count; i++)
        bind_texture(gl, &pass->binds[i], pass->views[i]);
}

void aob_gl_pass_draw(const struct gl *gl, const struct aob_gpu_pass *base)
{
    const struct gl_pass *pass = (const struct gl_pass *)base;
    clear_targets(&gl->api, pass);
    gl->api.DrawArrays(GL_TRIANGLES, pass->first_vertex, pass->vertices);
}

void aob_gl_pass_set_part(struct aob_gpu_pass *base, const struct aob_gpu_part *part)
{
    struct gl_pass *pass = (struct gl_pass *)base;
    pass->row = part->row;
    pass->rows = part->rows;
    pass->first_vertex = (GLint)part->first_vertex;
    pass->vertices = part->vertex_count ? (GLsizei)part->vertex_count : 3;
}
