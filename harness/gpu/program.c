#include <stdlib.h>
#include "backends.h"
#include "gpu.h"

/* What a rewrite made of the words, which it is done with. */
static uint32_t *rewrite(const struct aob_gpu_program_desc *desc, enum aob_glsl_client client,
                         uint32_t *words, size_t *count, struct aob_error *error)
{
    uint32_t storage = client == AOB_GLSL_VULKAN ? AOB_GLSL_STORAGE_BINDING : 0;
    uint32_t *made = desc->rewrite->words(desc->rewrite->self, words, count, storage, error);
    free(words);
    return made;
}

uint32_t *aob_gpu_program_words(const struct aob_gpu_program_desc *desc, enum aob_glsl_stage stage,
                                enum aob_glsl_client client, size_t *count, uint64_t *bindings,
                                struct aob_error *error)
{
    bool fragment = stage == AOB_GLSL_FRAGMENT;
    uint32_t *words = aob_glsl_compile(fragment ? desc->fragment : desc->vertex, stage, client, count, error);
    if (words && fragment && desc->rewrite)
        words = rewrite(desc, client, words, count, error);
    if (words)
        *bindings |= aob_glsl_bindings(words, *count);
    return words;
}

struct aob_gpu_program *aob_gpu_program_create_desc(struct aob_gpu *gpu,
                                                    const struct aob_gpu_program_desc *desc,
                                                    struct aob_error *error)
{
    struct aob_gpu_program *program = NULL;
    if (!gpu->fns->program_create(gpu, desc, &program, error))
        return NULL;
    program->geometry = desc->vertex;
    if (!((program->bindings & ~AOB_GPU_STORAGE_BIT) >> (AOB_GPU_MAX_BINDING + 1)))
        return program;
    aob_fail(error, "%s: program with a BIND beyond %d", gpu->info.backend, AOB_GPU_MAX_BINDING);
    gpu->fns->program_destroy(gpu, program);
    return NULL;
}

struct aob_gpu_program *aob_gpu_program_create(struct aob_gpu *gpu, const char *glsl, struct aob_error *error)
{
    return aob_gpu_program_create_desc(gpu, &(struct aob_gpu_program_desc){.fragment = glsl}, error);
}

struct aob_gpu_program *aob_gpu_program_create_geometry(struct aob_gpu *gpu, const char *vertex,
                                                        const char *fragment, struct aob_error *error)
{
    return aob_gpu_program_create_desc(
        gpu, &(struct aob_gpu_program_desc){.vertex = vertex, .fragment = fragment}, error);
}

void aob_gpu_program_destroy(struct aob_gpu *gpu, struct aob_gpu_program *program)
{
    if (program)
        gpu->fns->program_destroy(gpu, program);
}
