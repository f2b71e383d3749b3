/* What tests of devices make, or fail. */
#ifndef AOB_TESTS_GPU_MADE_H
#define AOB_TESTS_GPU_MADE_H
#include "check.h"
#include "base/memory.h"
#include "gpu/gpu.h"

enum { WIDTH = 37, HEIGHT = 11, TEXELS = WIDTH * HEIGHT };

enum { ALL_USES = AOB_GPU_USE_SAMPLED | AOB_GPU_USE_STORAGE | AOB_GPU_USE_TARGET | AOB_GPU_USE_READ_BACK };

static inline struct aob_gpu_texture *make(struct aob_gpu *gpu, struct aob_gpu_texture_desc desc)
{
    struct aob_error error = {""};
    struct aob_gpu_texture *made = aob_gpu_texture_create(gpu, &desc, &error);
    if (!made)
        fail_msg("%s", error.text);
    return made;
}

static inline struct aob_gpu_texture *texture(struct aob_gpu *gpu, enum aob_format format, const void *texels)
{
    return make(gpu,
                (struct aob_gpu_texture_desc){
                    .format = format, .width = WIDTH, .height = HEIGHT, .uses = ALL_USES, .texels = texels});
}

static inline struct aob_gpu_program *program(struct aob_gpu *gpu, const char *glsl)
{
    struct aob_error error = {""};
    struct aob_gpu_program *made = aob_gpu_program_create(gpu, glsl, &error);
    if (!made)
        fail_msg("%s", error.text);
    return made;
}

static inline bool draws(const struct aob_gpu *gpu)
{
    return !gpu->info.draws_nothing;
}

static inline void *read_back(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, int level)
{
    void *texels = aob_alloc(aob_gpu_level_bytes(texture, level), 1);
    struct aob_error error = {""};
    if (!aob_gpu_texture_read(gpu, texture, level, texels, &error))
        fail_msg("%s", error.text);
    return texels;
}

static inline bool run_once(struct aob_gpu *gpu, struct aob_gpu_pass *pass, struct aob_gpu_time *time,
                            struct aob_error *error)
{
    return aob_gpu_run(gpu, &(struct aob_gpu_run_desc){&pass, 1, 1}, NULL, time, error);
}

static inline void run_pass(struct aob_gpu *gpu, const struct aob_gpu_pass_desc *desc,
                            struct aob_gpu_time *time)
{
    struct aob_error error = {""};
    struct aob_gpu_pass *pass = aob_gpu_pass_create(gpu, desc, &error);
    if (!pass || !run_once(gpu, pass, time, &error))
        fail_msg("%s", error.text);
    aob_gpu_pass_destroy(gpu, pass);
}
#endif
