#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "block.h"
#include "time_record.h"

/* Cases of the block that are timed together, over their processes. */
struct group {
    struct aob_run_block *block;
    size_t places[AOB_BLOCK_MAX], count;
    struct aob_block_timed timed;      /* by its first good process */
    struct aob_run_block_reply *first; /* what the process that scored has measured of it; NULL: nothing */
    const char *lost;                  /* why that does not count */
};

struct aob_processes_desc aob_run_block_processes(const struct aob_run_block *block, size_t place,
                                                  size_t count)
{
    const struct aob_config *config = block->m->plan->config;
    return (struct aob_processes_desc){.case_count = count,
                                       .least = config->processes,
                                       .seconds = config->seconds,
                                       .precision = config->precision,
                                       .seed = aob_process_seed(block->m->seed, (int)block->indices[place])};
}

/* What the worker calls by its place in its job. */
static void keep_timed(struct group *group, struct aob_block_timed *timed)
{
    if (!group->timed.count) {
        group->timed = *timed;
        *timed = (struct aob_block_timed){0};
    }
    aob_block_timed_finish(timed);
}

static bool take_first(struct group *group, struct aob_round_list *rounds, struct aob_error *error)
{
    struct aob_round_list *own = group->first->rounds;
    if (group->lost)
        return aob_fail(error, "%s", group->lost);
    for (size_t r = 0; r < own->count; r++)
        *AOB_PUSH(rounds->items, rounds->count, rounds->capacity) = own->items[r];
    keep_timed(group, &group->first->timed);
    return true;
}

static bool measure_process(void *user, const struct aob_process_desc *process, struct aob_round_list *rounds,
                            struct aob_error *error)
{
    struct group *group = user;
    if (group->first && process->index == 0)
        return take_first(group, rounds, error);
    struct aob_run_block_reply reply = {.rounds = rounds};
    const struct aob_run_block_job job = {.places = group->places, .count = group->count, .process = process};
    bool ok = aob_run_block_send(group->block, &job, &reply, error);
    if (ok)
        keep_timed(group, &reply.timed);
    else
        aob_block_timed_finish(&reply.timed);
    return ok;
}

static void tell_lost(void *user, int index, const char *reason)
{
    struct group *group = user;
    const struct aob_run_block *block = group->block;
    struct aob_text text = {0};
    aob_case_describe(block->m->plan, aob_run_block_case(block, group->places[0]), &text);
    aob_warn("timing %s%s: process %d is lost: %s", text.data, group->count > 1 ? " and its block" : "",
             index, reason);
    aob_text_finish(&text);
}

/* Keys of the cases, in the order of their slots. */
static json_t *slot_keys(const struct group *group)
{
    json_t *keys = json_array();
    for (size_t i = 0; i < group->count; i++)
        json_array_append_new(keys, json_string(aob_run_block_case(group->block, group->places[i])->key));
    return keys;
}

/* "rounds/HASH.jsonl.zst" below the run's folder, a name that no other measurement has; NULL if it is not kept. free()
 * it. */
static char *keep_rounds(const struct group *group, const struct aob_processes_desc *asked,
                         const struct aob_processes *measured)
{
    const char *folder = group->block->m->folder;
    struct aob_text keys = {0}, name = {0};
    struct aob_error error = {{0}};
    char hash[AOB_KEY_SIZE];
    if (!folder)
        return NULL;
    for (size_t i = 0; i < group->count; i++)
        aob_text_add(&keys, "%s ", aob_run_block_case(group->block, group->places[i])->key);
    aob_text_add(&keys, "%u", (unsigned)asked->seed);
    aob_hash_text(keys.data, hash);
    aob_text_add(&name, "rounds/%s.jsonl.zst", hash);
    char *path = aob_path_join(folder, name.data);
    if (!aob_rounds_write(&measured->rounds, path, &error)) {
        aob_warn("%s", error.text);
        aob_text_finish(&name);
    }
    free(path);
    aob_text_finish(&keys);
    return name.data;
}

static void finish_group(struct group *group, const struct aob_processes_desc *asked,
                         const struct aob_processes *measured)
{
    json_t *slots = slot_keys(group);
    char *file = keep_rounds(group, asked, measured);
    for (size_t i = 0; i < group->count; i++) {
        const struct aob_time_record_desc desc = {.asked = asked,
                                                  .measured = measured,
                                                  .timed = &group->timed,
                                                  .at = i,
                                                  .slots = slots,
                                                  .rounds_file = file};
        json_object_set_new(group->block->held[group->places[i]], "time", aob_time_record_create(&desc));
        aob_run_block_finish_held(group->block, group->places[i]);
    }
    free(file);
    json_decref(slots);
}

static void time_group(struct group *group)
{
    struct aob_run_block *block = group->block;
    /* The seed is that of the first place, which the process that scored went by. */
    struct aob_processes_desc asked =
        aob_run_block_processes(block, group->first ? 0 : group->places[0], group->count);
    struct aob_processes measured;
    struct aob_error error = {{0}};
    asked.run = measure_process;
    asked.on_lost = tell_lost;
    asked.user = group;
    if (aob_processes_run(&asked, &measured, &error))
        finish_group(group, &asked, &measured);
    else
        snprintf(block->reason, sizeof block->reason, "%s", error.text);
    aob_processes_finish(&measured);
    aob_block_timed_finish(&group->timed);
}

static void add_place(struct group *group, size_t place)
{
    if (place < group->block->count && group->block->held[place])
        group->places[group->count++] = place;
}

/* What the process that scored has timed. */
static void choose_first(struct group *group)
{
    const struct aob_block_timed *timed = &group->first->timed;
    for (size_t i = 0; i < timed->count; i++)
        add_place(group, timed->cases[i].index);
}

/* It was lost before it could say which cases are timed together: each is timed apart, as cheap ones would lose their
 * rounds to a dear one. */
static void tell_lost_first(struct group *group, const char *reason)
{
    struct group all = {.block = group->block};
    for (size_t i = 0; i < group->block->count; i++)
        add_place(&all, i);
    if (all.count)
        tell_lost(&all, 0, reason);
}

void aob_run_block_time(struct aob_run_block *block, struct aob_run_block_reply *first, const char *lost)
{
    bool tried[AOB_BLOCK_MAX] = {false};
    struct group group = {.block = block, .first = first, .lost = lost};
    choose_first(&group);
    for (size_t i = 0; i < group.count; i++)
        tried[group.places[i]] = true;
    if (group.count)
        time_group(&group);
    else if (lost)
        tell_lost_first(&group, lost);
    for (size_t i = 0; i < block->count; i++) {
        struct group single = {.block = block, .places = {i}, .count = 1};
        if (block->held[i] && !tried[i])
            time_group(&single);
    }
}
