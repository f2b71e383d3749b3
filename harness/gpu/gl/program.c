#include "gl.h"
#include "base/memory.h"
#include "gpu/backends.h"
#include <stdlib.h>
#include <string.h>

/* SPIR-V comes checked from glslang, so what fails here is the driver; its log's first line says how. */
static void fail_with_log(struct aob_gpu *gpu, const char *what, const char *log, struct aob_error *error)
{
    aob_fail(error, "%s: the driver refuses to %s: %.*s", gpu->info.backend, what, (int)strcspn(log, "\r\n"),
             *log ? log : "it gives no reason");
}

GLuint aob_gl_shader_create(struct aob_gpu *gpu, GLenum stage, const uint32_t *words, size_t word_count,
                            struct aob_error *error)
{
    const struct gl_api *api = aob_gl_use(gpu);
    GLuint shader = api->CreateShader(stage);
    api->ShaderBinary(1, &shader, GL_SHADER_BINARY_FORMAT_SPIR_V_ARB, words,
                      (GLsizei)(word_count * sizeof *words));
    api->SpecializeShaderARB(shader, "main", 0, NULL, NULL);
    GLint good = 0;
    char log[512] = "";
    api->GetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good && aob_gl_ok(gpu, "create a shader", error))
        return shader;
    if (!good) {
        api->GetShaderInfoLog(shader, sizeof log, NULL, log);
        fail_with_log(gpu, "compile", log, error);
    }
    api->DeleteShader(shader);
    return 0;
}

static bool link_program(struct aob_gpu *gpu, GLuint program, const GLuint shaders[2],
                         struct aob_error *error)
{
    const struct gl_api *api = &((struct gl *)gpu)->api;
    for (size_t i = 0; i < 2; i++)
        api->AttachShader(program, shaders[i]);
    api->LinkProgram(program);
    for (size_t i = 0; i < 2; i++)
        api->DetachShader(program, shaders[i]);
    GLint good = 0;
    char log[512] = "";
    api->GetProgramiv(program, GL_LINK_STATUS, &good);
    if (good)
        return aob_gl_ok(gpu, "link a program", error);
    api->GetProgramInfoLog(program, sizeof log, NULL, log);
    fail_with_log(gpu, "link", log, error);
    return false;
}

static bool compile(struct aob_gpu *gpu, const struct aob_gpu_program_desc *desc, enum aob_glsl_stage stage,
                    GLuint *shader, uint64_t *bindings, struct aob_error *error)
{
    static const GLenum stages[] = {
        [AOB_GLSL_VERTEX] = GL_VERTEX_SHADER, [AOB_GLSL_FRAGMENT] = GL_FRAGMENT_SHADER};
    size_t count;
    uint32_t *words = aob_gpu_program_words(desc, stage, AOB_GLSL_OPENGL, &count, bindings, error);
    if (!words)
        return aob_fail_in(error, "%s", gpu->info.backend);
    *shader = aob_gl_shader_create(gpu, stages[stage], words, count, error);
    free(words);
    return *shader;
}

bool aob_gl_program_create(struct aob_gpu *gpu, const struct aob_gpu_program_desc *desc,
                           struct aob_gpu_program **program, struct aob_error *error)
{
    const struct gl_api *api = aob_gl_use(gpu);
    GLuint own = 0, shaders[2] = {((struct gl *)gpu)->triangle, 0};
    struct gl_program *made = AOB_NEW(struct gl_program);
    made->name = api->CreateProgram();
    bool good = !desc->vertex || compile(gpu, desc, AOB_GLSL_VERTEX, &own, &made->base.bindings, error);
    good = good && compile(gpu, desc, AOB_GLSL_FRAGMENT, &shaders[1], &made->base.bindings, error);
    if (own)
        shaders[0] = own;
    good = good && link_program(gpu, made->name, shaders, error);
    api->DeleteShader(own);
    api->DeleteShader(shaders[1]);
    if (good)
        *program = &made->base;
    else
        aob_gl_program_destroy(gpu, &made->base);
    return good;
}

void aob_gl_program_destroy(struct aob_gpu *gpu, struct aob_gpu_program *program)
{
    struct gl_program *made = (struct gl_program *)program;
    aob_gl_use(gpu)->DeleteProgram(made->name);
    free(made);
}
