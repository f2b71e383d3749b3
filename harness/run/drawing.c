#include "drawing.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "gpu/gpu.h"

struct aob_job_drawing aob_job_drawing_of(const struct aob_measurement *m, size_t index,
                                          const struct aob_view_files *files)
{
    const struct aob_case *c = &m->plan->cases[index];
    return (struct aob_job_drawing){.view = aob_job_view_of(c, files),
                                    .backend = c->backend,
                                    .device = m->dispatch->device,
                                    .validate = m->dispatch->validate,
                                    .raster = aob_case_options(c).gbuffer == AOB_GBUFFER_RASTER,
                                    .triangles = m->states[index].triangles};
}

struct aob_job_pose *aob_job_poses_of(const struct aob_view_files *files, size_t target_count)
{
    struct aob_job_pose *poses = AOB_NEW_ARRAY(struct aob_job_pose, files->pose_count);
    for (size_t p = 0; p < files->pose_count; p++) {
        const struct aob_view_pose *from = &files->poses[p];
        poses[p] = (struct aob_job_pose){
            .camera = from->camera, .frame = from->frame, .seed = from->seed, .gbuffer = from->gbuffer};
        for (size_t t = 0; t < target_count; t++)
            poses[p].truth[t] = from->truth[t];
    }
    return poses;
}

struct aob_job_frame aob_job_frame_of(const struct aob_case *c)
{
    struct aob_job_frame frame = {.technique = aob_technique_address(c->technique),
                                  .param_count = c->technique->param_count};
    memcpy(frame.params, c->params, frame.param_count * sizeof *c->params);
    memcpy(frame.options, c->options, sizeof frame.options);
    return frame;
}

/* Mesa compiles a block's shaders anew in each process, which takes longer than its timing (docs/measuring.md); so the
 * processes of a run share what it has compiled, in a folder that no other run has. */
void aob_drawing_environment_init(struct aob_drawing_environment *env, const struct aob_measurement *m,
                                  const struct aob_case *c)
{
    int threads = (int)aob_case_options(c).threads;
    struct aob_text text = {0};
    size_t used = 0;
    *env = (struct aob_drawing_environment){{NULL}};
    for (const char *const *e = aob_gpu_find(c->backend)->environment; *e && used < AOB_COUNT(env->texts) - 3;
         e++)
        if (!m->shaders || strcmp(*e, "MESA_SHADER_CACHE_DISABLE=true") != 0)
            env->texts[used++] = aob_strdup(*e);
    if (threads) {
        aob_text_add(&text, "LP_NUM_THREADS=%d", threads);
        env->texts[used++] = text.data;
    }
    if (!m->shaders)
        return;
    char *folder = aob_path_absolute(m->shaders);
    text = (struct aob_text){0};
    aob_text_add(&text, "MESA_SHADER_CACHE_DIR=%s", folder);
    env->texts[used++] = text.data;
    free(folder);
}

void aob_drawing_environment_finish(struct aob_drawing_environment *env)
{
    for (char **e = env->texts; *e; e++)
        free(*e);
    *env = (struct aob_drawing_environment){{NULL}};
}
