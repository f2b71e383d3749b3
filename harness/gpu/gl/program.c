#include "gl.h"
#include "base/memory.h"
#include "gpu/glsl.h"
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

static bool link_program(struct aob_gpu *gpu, GLuint program, GLuint fragment, struct aob_error *error)
{
    const struct gl_api *api = &((struct gl *)gpu)->api;
    const GLuint shaders[] = {((struct gl *)gpu)->triangle, fragment};
    for (size_t i = 0; i < AOB_COUNT(shaders); i++)
        api->AttachShader(program, shaders[i]);
    api->LinkProgram(program);
    for (size_t i = 0; i < AOB_COUNT(shaders); i++)
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

bool aob_gl_program_create(struct aob_gpu *gpu, const char *glsl, struct aob_gpu_program **program,
                           struct aob_error *error)
{
    const struct gl_api *api = aob_gl_use(gpu);
    size_t count;
    uint32_t *words = aob_glsl_compile(glsl, AOB_GLSL_FRAGMENT, AOB_GLSL_OPENGL, &count, error);
    if (!words)
        return aob_fail_in(error, "%s", gpu->info.backend);
    GLuint fragment = aob_gl_shader_create(gpu, GL_FRAGMENT_SHADER, words, count, error);
    uint32_t bindings = aob_glsl_bindings(words, count);
    free(words);
    if (!fragment)
        return false;
    struct gl_program *made = AOB_NEW(struct gl_program);
    made->base.bindings = bindings;
    made->name = api->CreateProgram();
    bool good = link_program(gpu, made->name, fragment, error);
    api->DeleteShader(fragment);
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
