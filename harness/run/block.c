#include "block.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/sealed.h"
#include "cache_case.h"
#include "record.h"

const struct aob_case *aob_run_block_case(const struct aob_run_block *block, size_t place)
{
    return &block->m->plan->cases[block->indices[place]];
}

void aob_run_block_image(const struct aob_case *c, char name[AOB_KEY_SIZE + 16])
{
    snprintf(name, AOB_KEY_SIZE + 16, "images/%s.exr", c->key);
}

static bool has_image(const struct aob_run_block *block, const char *name)
{
    char *path = block->m->folder ? aob_path_join(block->m->folder, name) : NULL;
    bool exists = path && aob_file_exists(path);
    free(path);
    return exists;
}

/* The truths of the targets go into the run's folder once, whatever the number of cases: images hold that of one target
 * only. They are copied when the worker has read them, so that a damaged one is never kept. */
static void keep_truths(struct aob_run_block *block)
{
    for (size_t t = 0; t < AOB_COUNT(block->truths) && block->truths[t]; t++) {
        struct aob_error error = {{0}};
        char *path = aob_path_join(block->m->folder, block->truths[t]);
        enum aob_sealed state = aob_sealed_judge(path, &error);
        bool lacks = state == AOB_SEALED_NONE || state == AOB_SEALED_WRONG;
        if (state == AOB_SEALED_SHUT ||
            (lacks && !aob_sealed_copy(block->files->truth[t][AOB_OUT_VISIBILITY], path, &error)))
            aob_warn("%s", error.text);
        free(path);
    }
}

void aob_run_block_finish_case(struct aob_run_block *block, size_t i, const char *status, const char *reason,
                               const json_t *answer)
{
    size_t index = block->indices[i];
    char name[AOB_KEY_SIZE + 16];
    if (json_object_get(answer, "errors"))
        keep_truths(block);
    aob_run_block_image(aob_run_block_case(block, i), name);
    json_t *record = aob_record_create(
        &(struct aob_record_desc){.config = block->m->plan->config,
                                  .c = aob_run_block_case(block, i),
                                  .state = &block->m->states[index],
                                  .status = status,
                                  .reason = reason,
                                  .answer = answer,
                                  .target = aob_case_own_target(aob_run_block_case(block, i)),
                                  .truths = block->truths,
                                  .image = answer && has_image(block, name) ? name : NULL});
    block->answered[i] = true;
    block->m->states[index].stage = AOB_DONE;
    block->m->on_record(block->m->user, index, record);
    json_decref(record);
}

void aob_run_block_finish_held(struct aob_run_block *block, size_t i)
{
    json_t *answer = block->held[i];
    if (block->m->plan->profile_count)
        json_object_set_new(answer, "cache", aob_cache_case(block->m, block->indices[i], block->files));
    aob_run_block_finish_case(block, i, "ok", NULL, answer);
}

/* Of the process that scores. */
static void take_case(struct aob_run_block *block, const json_t *answer)
{
    const json_t *index = json_object_get(answer, "index");
    size_t i = (size_t)json_integer_value(index);
    const char *status = json_string_value(json_object_get(answer, "status"));
    if (!index || i >= block->count || block->answered[i] || block->held[i] || !status)
        return;
    if (block->count > 1 && strcmp(status, "failed") == 0)
        return; /* it may be a neighbour's fault: it is tried alone */
    bool lacks = block->m->plan->config->measure_time || block->m->plan->profile_count;
    if (lacks && strcmp(status, "ok") == 0)
        block->held[i] = json_deep_copy(answer);
    else
        aob_run_block_finish_case(block, i, status, json_string_value(json_object_get(answer, "reason")),
                                  answer);
}

static void take_timed(struct aob_run_block_reply *reply, const json_t *answer)
{
    struct aob_run_block *block = reply->block;
    if (aob_block_timed_from_json(answer, block->count, &reply->timed))
        aob_run_clocks_keep(&block->m->clocks, aob_run_block_case(block, 0)->backend, reply->timed.clock,
                            reply->timed.clock_reason);
}

static void take_round(struct aob_run_block_reply *reply, const json_t *round)
{
    struct aob_round_list *rounds = reply->rounds;
    if (!*reply->garbled.text)
        aob_round_from_json(round, AOB_PUSH(rounds->items, rounds->count, rounds->capacity), &reply->garbled);
}

void aob_run_block_take(void *user, const json_t *answer)
{
    struct aob_run_block_reply *reply = user;
    struct aob_shares *sum = &reply->block->m->shares;
    struct aob_block_shares shares;
    if (aob_block_shares_from_json(answer, &shares)) {
        sum->measured += shares.measured;
        sum->warmup += shares.warmup;
        sum->images += shares.images;
        reply->complete = true;
    } else if (json_object_get(answer, "round"))
        take_round(reply, json_object_get(answer, "round"));
    else if (json_object_get(answer, "timed") && !reply->timed.count)
        take_timed(reply, answer);
    else
        take_case(reply->block, answer);
}

/* "truths/HASH.exr" below the run's folder for each target, named as in the cache by what it depends on. */
static void name_truths(struct aob_run_block *block)
{
    for (size_t t = 0; t < block->files->target_count; t++) {
        struct aob_text name = {0};
        aob_text_add(&name, "truths/%s", strrchr(block->files->truth[t][AOB_OUT_VISIBILITY], '-') + 1);
        block->truths[t] = name.data;
    }
}

static void free_truths(struct aob_run_block *block)
{
    for (size_t t = 0; t < AOB_COUNT(block->truths); t++)
        free(block->truths[t]);
}

static void fail_rest(struct aob_run_block *block)
{
    const char *reason = *block->reason ? block->reason : "the worker gave no answer for this case";
    for (size_t i = 0; i < block->count; i++)
        if (!block->answered[i])
            aob_run_block_finish_case(block, i, "failed", reason, NULL);
}

/* In a worker of its own, where no other case can have done it harm. */
static void retry_alone(struct aob_run_block *block)
{
    for (size_t i = 0; i < block->count; i++)
        if (!block->answered[i])
            aob_measurement_block(block->m, &block->indices[i], 1);
}

/* All cases are scored in one process, which times what it can; the times of the others follow. */
static void measure(struct aob_run_block *block)
{
    static const size_t places[AOB_BLOCK_MAX] = {0, 1, 2, 3, 4, 5};
    struct aob_round_list rounds = {0};
    struct aob_run_block_reply reply = {.rounds = &rounds};
    struct aob_error error = {{0}};
    const struct aob_processes_desc processes = aob_run_block_processes(block, 0, block->count);
    const struct aob_process_desc first = aob_process_describe(&processes, 0);
    bool ok =
        aob_run_block_send(block,
                           &(struct aob_run_block_job){
                               .places = places, .count = block->count, .score = true, .process = &first},
                           &reply, &error);
    snprintf(block->reason, sizeof block->reason, "%s", error.text);
    if (block->m->plan->config->measure_time)
        aob_run_block_time(block, &reply, ok ? NULL : error.text);
    for (size_t i = 0; !block->m->plan->config->measure_time && i < block->count; i++)
        if (block->held[i])
            aob_run_block_finish_held(block, i);
    aob_block_timed_finish(&reply.timed);
    aob_rounds_finish(&rounds);
}

static void finish(struct aob_run_block *block)
{
    for (size_t i = 0; i < block->count; i++)
        json_decref(block->held[i]);
    free_truths(block);
}

void aob_measurement_block(struct aob_measurement *m, const size_t *indices, size_t count)
{
    struct aob_view_files files = {0};
    struct aob_run_block block = {.m = m, .indices = indices, .count = count, .files = &files};
    struct aob_error error = {{0}};
    if (!aob_view_prepare(m, indices, count, &files, &error)) {
        snprintf(block.reason, sizeof block.reason, "%s", error.text);
        fail_rest(&block);
        return;
    }
    if (m->folder && m->plan->config->images)
        name_truths(&block);
    measure(&block);
    aob_view_files_finish(&files);
    if (count > 1)
        retry_alone(&block);
    else
        fail_rest(&block);
    finish(&block);
}
