#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "block.h"
#include "drawing.h"

/* Where the worker is to write the case's image; NULL: nowhere. free() it. */
static char *image_path(const struct aob_run_block *block, size_t i)
{
    char name[AOB_KEY_SIZE + 16];
    if (block->m->image)
        return aob_strdup(block->m->image);
    if (!block->m->folder || !block->m->plan->config->images)
        return NULL;
    aob_run_block_image(aob_run_block_case(block, i), name);
    return aob_path_join(block->m->folder, name);
}

static struct aob_block_case describe_case(const struct aob_run_block *block, size_t i, const char *image)
{
    const struct aob_case *c = aob_run_block_case(block, i);
    return (struct aob_block_case){.frame = aob_job_frame_of(c),
                                   .target = aob_case_own_target(c),
                                   .definition = block->files->definition[i],
                                   .screen = block->files->screen[i],
                                   .image = image};
}

static struct aob_block_target describe_target(const struct aob_run_block *block, size_t t)
{
    const struct aob_target *asked = &aob_run_block_case(block, 0)->scene->targets[t];
    struct aob_block_target target = {
        .radius = asked->radius, .uniform = asked->uniform, .bent = block->files->bent};
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        target.truth[which] = block->files->truth[t][which];
    return target;
}

static json_t *make_job(const struct aob_run_block *block, const struct aob_run_block_job *sent)
{
    const struct aob_view_files *files = block->files;
    const struct aob_case *c = aob_run_block_case(block, 0);
    const struct aob_config *config = block->m->plan->config;
    const struct aob_run_clock *clock = aob_run_clocks_find(&block->m->clocks, c->backend);
    struct aob_block_case cases[AOB_BLOCK_MAX];
    struct aob_block_target targets[AOB_CONFIG_MAX_TARGETS];
    char *images[AOB_BLOCK_MAX] = {NULL};
    struct aob_block_job job = {.drawing =
                                    aob_job_drawing_of(block->m, block->indices[sent->places[0]], files),
                                .score = sent->score,
                                .error = sent->score && config->measure_error,
                                .time = config->measure_time,
                                .process = sent->process->index,
                                .seed = sent->process->seed,
                                .seconds = sent->process->seconds,
                                .precision = config->precision,
                                .clock = clock ? aob_clock_name(clock->clock) : NULL,
                                .clock_reason = clock ? clock->reason : NULL,
                                .poses = aob_job_poses_of(files, files->target_count),
                                .pose_count = files->pose_count,
                                .targets = targets,
                                .target_count = files->target_count,
                                .cases = cases,
                                .case_count = sent->count};
    for (size_t t = 0; t < files->target_count; t++)
        targets[t] = describe_target(block, t);
    for (size_t i = 0; i < sent->count; i++) {
        size_t place = sent->places[i];
        images[i] = sent->score ? image_path(block, place) : NULL;
        cases[i] = describe_case(block, place, images[i]);
        job.drawing.triangles = job.drawing.triangles || block->m->states[block->indices[place]].triangles;
    }
    json_t *object = aob_block_job_to_json(&job);
    free(job.poses);
    for (size_t i = 0; i < sent->count; i++)
        free(images[i]);
    return object;
}

/* Ten times what timing may take, about six times what a pixel's score against a target takes (0.3 us), and for the frames
 * before the last that again and 10 us a pixel, which a dear technique takes on a slow core. */
static double time_limit(const struct aob_run_block *block, const struct aob_run_block_job *job)
{
    const struct aob_case *c = aob_run_block_case(block, 0);
    double pixels = (double)c->width * c->height, poses = (double)block->files->pose_count;
    double scores = job->score ? pixels * (double)block->files->target_count : 0;
    return 120 + (double)job->count *
                     (10 * job->process->seconds + 2e-6 * scores * (1 + poses) + 1e-5 * pixels * poses);
}

static bool run_worker(const struct aob_run_block *block, const struct aob_run_block_job *job,
                       struct aob_run_block_reply *reply, struct aob_error *error)
{
    struct aob_drawing_environment env;
    aob_drawing_environment_init(&env, block->m, aob_run_block_case(block, 0));
    struct aob_job_desc desc = {.job = make_job(block, job),
                                .env = (const char *const *)env.texts,
                                .timeout_s = time_limit(block, job),
                                .output_limit = (size_t)(64 * (1 + job->process->seconds)) << 20,
                                .on_answer = aob_run_block_take,
                                .user = reply};
    bool ok = aob_dispatch_job(block->m->dispatch, &desc, error) || reply->complete;
    aob_drawing_environment_finish(&env);
    return ok && (!*reply->garbled.text || aob_fail(error, "%s", reply->garbled.text));
}

bool aob_run_block_send(struct aob_run_block *block, const struct aob_run_block_job *job,
                        struct aob_run_block_reply *reply, struct aob_error *error)
{
    struct aob_measurement *m = block->m;
    reply->block = block;
    if (m->on_work)
        m->on_work(m->user, block->indices[job->places[0]], "compiling and measuring");
    if (m->plan->config->measure_time && !aob_measure_lock_take(&m->lock, error))
        return false;
    bool ok = run_worker(block, job, reply, error);
    aob_measure_lock_release(&m->lock);
    return ok;
}
