#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/sealed.h"
#include "gpu/gpu.h"
#include "job/block_job.h"
#include "measurement.h"
#include "record.h"

/* A block under way: what its worker has answered. */
struct block {
    struct aob_measurement *m;
    const size_t *indices;
    size_t count;
    const struct aob_view_files *files;   /* while its worker runs */
    char *truths[AOB_CONFIG_MAX_TARGETS]; /* "truths/HASH.exr" below the run's folder; NULL: it is not kept */
    bool answered[AOB_BLOCK_MAX];
};

static const struct aob_case *case_of(const struct block *block, size_t i)
{
    return &block->m->plan->cases[block->indices[i]];
}

/* "images/KEY.exr", below the run's folder. */
static void image_name(const struct aob_case *c, char name[AOB_KEY_SIZE + 16])
{
    snprintf(name, AOB_KEY_SIZE + 16, "images/%s.exr", c->key);
}

/* Where the worker is to write the case's image; NULL: nowhere. free() it. */
static char *image_path(const struct block *block, size_t i)
{
    char name[AOB_KEY_SIZE + 16];
    if (block->m->image)
        return aob_strdup(block->m->image);
    if (!block->m->folder || !block->m->plan->config->images)
        return NULL;
    image_name(case_of(block, i), name);
    return aob_path_join(block->m->folder, name);
}

static bool has_image(const struct block *block, const char *name)
{
    char *path = block->m->folder ? aob_path_join(block->m->folder, name) : NULL;
    bool exists = path && aob_file_exists(path);
    free(path);
    return exists;
}

/* The truths of the targets go into the run's folder once, whatever the number of cases: images hold that of one target
 * only. They are copied when the worker has read them, so that a damaged one is never kept. */
static void keep_truths(struct block *block)
{
    for (size_t t = 0; t < AOB_COUNT(block->truths) && block->truths[t]; t++) {
        struct aob_error error = {{0}};
        char *path = aob_path_join(block->m->folder, block->truths[t]);
        enum aob_sealed state = aob_sealed_judge(path, &error);
        bool lacks = state == AOB_SEALED_NONE || state == AOB_SEALED_WRONG;
        if (state == AOB_SEALED_SHUT || (lacks && !aob_sealed_copy(block->files->truth[t], path, &error)))
            aob_warn("%s", error.text);
        free(path);
    }
}

static void finish_case(struct block *block, size_t i, const char *status, const char *reason,
                        const json_t *answer)
{
    size_t index = block->indices[i];
    char name[AOB_KEY_SIZE + 16];
    if (json_object_get(answer, "errors"))
        keep_truths(block);
    image_name(case_of(block, i), name);
    json_t *record =
        aob_record_create(&(struct aob_record_desc){.config = block->m->plan->config,
                                                    .c = case_of(block, i),
                                                    .state = &block->m->states[index],
                                                    .status = status,
                                                    .reason = reason,
                                                    .answer = answer,
                                                    .target = aob_case_own_target(case_of(block, i)),
                                                    .truths = block->truths,
                                                    .image = answer && has_image(block, name) ? name : NULL});
    block->answered[i] = true;
    block->m->states[index].stage = AOB_DONE;
    block->m->on_record(block->m->user, index, record);
    json_decref(record);
}

static void take_answer(void *user, const json_t *answer)
{
    struct block *block = user;
    struct aob_block_shares shares;
    if (aob_block_shares_from_json(answer, &shares)) {
        block->m->shares.measured += shares.measured;
        block->m->shares.warmup += shares.warmup;
        block->m->shares.images += shares.images;
        return;
    }
    const json_t *index = json_object_get(answer, "index");
    size_t i = (size_t)json_integer_value(index);
    const char *status = json_string_value(json_object_get(answer, "status"));
    if (!index || i >= block->count || block->answered[i] || !status)
        return;
    if (block->count > 1 && strcmp(status, "failed") == 0)
        return; /* it may be a neighbour's fault: it is tried alone */
    finish_case(block, i, status, json_string_value(json_object_get(answer, "reason")), answer);
}

static struct aob_block_case describe_case(const struct block *block, size_t i, const char *image)
{
    const struct aob_case *c = case_of(block, i);
    struct aob_block_case described = {.technique = aob_technique_address(c->technique),
                                       .param_count = c->technique->param_count,
                                       .target = aob_case_own_target(c),
                                       .definition = block->files->definition[i],
                                       .screen = block->files->screen[i],
                                       .image = image};
    memcpy(described.params, c->params, c->technique->param_count * sizeof *c->params);
    memcpy(described.options, c->options, sizeof described.options);
    return described;
}

static json_t *make_job(const struct block *block)
{
    const struct aob_view_files *files = block->files;
    const struct aob_case *c = case_of(block, 0);
    const struct aob_config *config = block->m->plan->config;
    struct aob_block_case cases[AOB_BLOCK_MAX];
    struct aob_block_target targets[AOB_CONFIG_MAX_TARGETS];
    char *images[AOB_BLOCK_MAX];
    struct aob_block_job job = {.view = aob_job_view_of(c, files),
                                .backend = c->backend,
                                .validate = block->m->dispatch->validate,
                                .raster = aob_case_options(c).gbuffer == AOB_GBUFFER_RASTER,
                                .time = config->measure_time,
                                .error = config->measure_error,
                                .seconds = config->seconds,
                                .narrow = config->narrow,
                                .targets = targets,
                                .target_count = files->target_count,
                                .cases = cases,
                                .case_count = block->count};
    for (size_t t = 0; t < files->target_count; t++)
        targets[t] = (struct aob_block_target){c->scene->targets[t].radius, c->scene->targets[t].uniform,
                                               files->truth[t], files->bent};
    for (size_t i = 0; i < block->count; i++) {
        images[i] = image_path(block, i);
        cases[i] = describe_case(block, i, images[i]);
        job.triangles = job.triangles || block->m->states[block->indices[i]].triangles;
    }
    json_t *object = aob_block_job_to_json(&job);
    for (size_t i = 0; i < block->count; i++)
        free(images[i]);
    return object;
}

/* "truths/HASH.exr" below the run's folder for each target, named as in the cache by what it depends on. */
static void name_truths(struct block *block)
{
    for (size_t t = 0; t < block->files->target_count; t++) {
        struct aob_text name = {0};
        aob_text_add(&name, "truths/%s", strrchr(block->files->truth[t], '-') + 1);
        block->truths[t] = name.data;
    }
}

static void free_truths(struct block *block)
{
    for (size_t t = 0; t < AOB_COUNT(block->truths); t++)
        free(block->truths[t]);
}

/* Ten times what timing may take, and about six times what a pixel's score against a target takes (0.3 us). */
static double time_limit(const struct block *block)
{
    const struct aob_case *c = case_of(block, 0);
    double scores = (double)c->width * c->height * (double)block->files->target_count;
    return 120 + (double)block->count * (10 * block->m->plan->config->seconds + 2e-6 * scores);
}

static bool run_worker(struct block *block, struct aob_error *error)
{
    enum { ROOM = 32 };
    const struct aob_case *c = case_of(block, 0);
    const char *env[ROOM] = {0};
    if (block->m->on_work)
        block->m->on_work(block->m->user, block->indices[0], "compiling and measuring");
    char threads[40];
    size_t used = 0;
    for (const char *const *e = aob_gpu_find(c->backend)->environment; *e && used < ROOM - 2; e++)
        env[used++] = *e;
    snprintf(threads, sizeof threads, "LP_NUM_THREADS=%d", (int)aob_case_options(c).threads);
    if (aob_case_options(c).threads)
        env[used++] = threads;
    struct aob_job_desc desc = {.job = make_job(block),
                                .env = env,
                                .timeout_s = time_limit(block),
                                .on_answer = take_answer,
                                .user = block};
    return aob_dispatch_job(block->m->dispatch, &desc, error);
}

static void fail_rest(struct block *block, const char *reason)
{
    for (size_t i = 0; i < block->count; i++)
        if (!block->answered[i])
            finish_case(block, i, "failed", reason, NULL);
}

/* In a worker of its own, where no other case can have done it harm. */
static void retry_alone(struct block *block)
{
    for (size_t i = 0; i < block->count; i++)
        if (!block->answered[i])
            aob_measurement_block(block->m, &block->indices[i], 1);
}

void aob_measurement_block(struct aob_measurement *m, const size_t *indices, size_t count)
{
    struct aob_view_files files = {0};
    struct block block = {.m = m, .indices = indices, .count = count, .files = &files};
    struct aob_error error = {{0}};
    if (!aob_view_prepare(m, indices, count, &files, &error)) {
        fail_rest(&block, error.text);
        return;
    }
    if (m->folder && m->plan->config->images)
        name_truths(&block);
    bool ok = run_worker(&block, &error);
    aob_view_files_finish(&files);
    if (count > 1)
        retry_alone(&block);
    else
        fail_rest(&block, ok ? "the worker gave no answer for this case" : error.text);
    free_truths(&block);
}
