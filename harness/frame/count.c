#include "count.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "past.h"
#include "shader/blocks.h"
#include "shader/counters.h"
#include "shader/optimise.h"

enum { BUFFER_WORDS = 1 << 14, MOST_BLOCKS = BUFFER_WORDS - AOB_COUNTERS_BLOCKS };

struct counted_text { /* of a pass */
    struct aob_blocks blocks;
    bool unfit; /* after a refusal: it holds what cannot be counted */
};

struct aob_counting {
    struct aob_gpu *gpu;
    struct aob_gpu_buffer *buffer;
    struct aob_first first; /* where no past is given */
    uint64_t limit;
    struct counted_text texts[AOB_MAX_PASS]; /* by index in the graph, as the next */
    struct aob_gpu_rewrite rewrites[AOB_MAX_PASS];
};

static uint32_t *insert_counters(struct counted_text *text, const struct aob_spirv *spirv, uint32_t storage,
                                 size_t *count, struct aob_error *error)
{
    struct aob_blocks *blocks = &text->blocks;
    text->unfit = true;
    if (!aob_blocks_init(blocks, spirv, error))
        return NULL;
    if (blocks->count > MOST_BLOCKS) {
        aob_fail(error, "its %zu blocks cannot be counted: %d can", blocks->count, MOST_BLOCKS);
        return NULL;
    }
    text->unfit = false;
    return aob_counters_insert(spirv, storage, count);
}

/* struct aob_gpu_rewrite; `self` is the pass's counted_text. */
static uint32_t *count_words(void *self, const uint32_t *words, size_t *count, uint32_t storage,
                             struct aob_error *error)
{
    char why[256];
    struct aob_spirv spirv;
    uint32_t *made = NULL, *optimised = aob_shader_optimise(words, *count, count, why, sizeof why);
    if (!optimised) {
        aob_fail(error, "it cannot be optimised: %s", why);
        return NULL;
    }
    if (aob_spirv_init(&spirv, optimised, *count, error)) {
        made = insert_counters(self, &spirv, storage, count, error);
        aob_spirv_finish(&spirv);
    }
    free(optimised);
    return made;
}

static bool create_buffer(struct aob_count *count, struct aob_error *error)
{
    struct aob_counting *counting = count->counting;
    const char *lacks = aob_gpu_storage_lacks(counting->gpu);
    count->unfit = lacks;
    if (lacks)
        return aob_fail(error, "%s: operations are not counted: %s %s: use another device or backend",
                        counting->gpu->info.backend, counting->gpu->info.device, lacks);
    counting->buffer = aob_gpu_buffer_create(counting->gpu, 4 * BUFFER_WORDS, error);
    return counting->buffer;
}

static bool create_frame(struct aob_count *count, const struct aob_count_desc *desc, struct aob_error *error)
{
    struct aob_counting *counting = count->counting;
    for (int i = 0; i < AOB_MAX_PASS; i++)
        counting->rewrites[i] = (struct aob_gpu_rewrite){&counting->texts[i], count_words};
    struct aob_frame_desc frame = {.technique = desc->technique,
                                   .values = desc->values,
                                   .fetch = desc->fetch,
                                   .wanted = desc->wanted,
                                   .readable = true,
                                   .past = desc->past,
                                   .rewrites = counting->rewrites,
                                   .storage = counting->buffer};
    if (!frame.past && !aob_first_init(&counting->first, desc->screen, &frame, error)) {
        count->unfit = counting->first.unfit;
        return false;
    }
    frame.past = frame.past ? frame.past : aob_first_past(&counting->first);
    bool ok = aob_frame_init_desc(&count->frame, desc->screen, &frame, error);
    count->unfit = count->frame.unfit;
    for (int i = 0; i < AOB_MAX_PASS; i++)
        count->unfit = count->unfit || counting->texts[i].unfit;
    return ok;
}

bool aob_count_init(struct aob_count *count, const struct aob_count_desc *desc, struct aob_error *error)
{
    const uint64_t whole = (uint64_t)1 << 32;
    *count = (struct aob_count){.counting = AOB_NEW(struct aob_counting)};
    count->counting->gpu = desc->screen->gpu;
    count->counting->limit = desc->limit && desc->limit < whole ? desc->limit : whole;
    if (create_buffer(count, error) && create_frame(count, desc, error))
        return true;
    bool unfit = count->unfit;
    aob_count_finish(count);
    count->unfit = unfit;
    return false;
}

void aob_count_finish(struct aob_count *count)
{
    struct aob_counting *counting = count->counting;
    if (!counting)
        return;
    aob_frame_finish(&count->frame);
    aob_first_finish(&counting->first);
    aob_gpu_buffer_destroy(counting->gpu, counting->buffer);
    for (int i = 0; i < AOB_MAX_PASS; i++)
        aob_blocks_finish(&counting->texts[i].blocks);
    free(counting);
    *count = (struct aob_count){0};
}

/* A pass that is drawn in parts until all of them have been counted. */
struct parts {
    struct aob_count *count;
    int index;
    struct aob_gpu_pass *pass;
    bool several;                 /* it was too much for one */
    uint32_t words[BUFFER_WORDS]; /* of the last part */
};

static bool draw(struct parts *parts, const struct aob_gpu_part *part, struct aob_error *error)
{
    const struct aob_counting *counting = parts->count->counting;
    struct aob_gpu *gpu = counting->gpu;
    size_t size = 4 * (AOB_COUNTERS_BLOCKS + counting->texts[parts->index].blocks.count);
    memset(parts->words, 0, size);
    return aob_gpu_buffer_write(gpu, counting->buffer, 0, size, parts->words, error) &&
           aob_gpu_pass_set_part(gpu, parts->pass, part, error) &&
           aob_gpu_run(gpu, &(struct aob_gpu_run_desc){&parts->pass, 1, 1}, NULL, NULL, error) &&
           aob_gpu_buffer_read(gpu, counting->buffer, 0, size, parts->words, error);
}

static uint64_t invocations(const struct parts *parts)
{
    return parts->words[AOB_COUNTERS_INVOCATIONS] | (uint64_t)parts->words[AOB_COUNTERS_INVOCATIONS_HIGH]
                                                        << 32;
}

/* Whether no counter can have gone beyond the limit, as each invocation ran `most` blocks at most. */
static bool has_room(const struct parts *parts)
{
    uint64_t most = parts->words[AOB_COUNTERS_MOST], limit = parts->count->counting->limit;
    return !most || invocations(parts) <= (limit - 1) / most;
}

static void add_part(struct parts *parts)
{
    const struct aob_blocks *blocks = &parts->count->counting->texts[parts->index].blocks;
    struct aob_count_pass *sum = &parts->count->passes[parts->index];
    sum->invocations += invocations(parts);
    for (size_t i = 0; i < blocks->count; i++) {
        double runs = parts->words[AOB_COUNTERS_BLOCKS + i];
        sum->whole.alu += runs * blocks->each[i].alu;
        sum->whole.special += runs * blocks->each[i].special;
        sum->whole.image += runs * blocks->each[i].image;
    }
}

/* Halves of a part: of its triangles, and of its rows where it has one or none. False: it is one row of one. */
static bool halve(const struct aob_gpu_part *part, struct aob_gpu_part halves[2])
{
    uint32_t triangles = part->vertex_count / 3;
    halves[0] = halves[1] = *part;
    if (triangles > 1) {
        halves[0].vertex_count = triangles / 2 * 3;
        halves[1].vertex_count -= halves[0].vertex_count;
        halves[1].first_vertex += halves[0].vertex_count;
        return true;
    }
    halves[0].rows = part->rows / 2;
    halves[1].rows -= halves[0].rows;
    halves[1].row += halves[0].rows;
    return halves[0].rows > 0;
}

static bool count_part(struct parts *parts, const struct aob_gpu_part *part, struct aob_error *error)
{
    struct aob_gpu_part halves[2];
    if (!draw(parts, part, error))
        return false;
    if (has_room(parts)) {
        add_part(parts);
        return true;
    }
    parts->several = true;
    if (halve(part, halves))
        return count_part(parts, &halves[0], error) && count_part(parts, &halves[1], error);
    parts->count->unfit = true;
    return aob_fail(
        error,
        "a row of %llu invocations of up to %u blocks each is too much to count: use a smaller image or "
        "fewer samples",
        (unsigned long long)invocations(parts), parts->words[AOB_COUNTERS_MOST]);
}

/* A pass of triangles adds to its targets, so a part of it leaves them unfinished. */
static bool restore(struct parts *parts, const struct aob_gpu_part *whole, struct aob_error *error)
{
    return (!parts->several || draw(parts, whole, error)) &&
           aob_gpu_pass_set_part(parts->count->counting->gpu, parts->pass, whole, error);
}

static bool count_pass(struct aob_count *count, int index, struct aob_error *error)
{
    struct parts *parts = AOB_NEW(struct parts);
    *parts = (struct parts){.count = count, .index = index, .pass = count->frame.passes[index]};
    const struct aob_gpu_part whole = {.rows = parts->pass->height,
                                       .vertex_count = parts->pass->vertex_count};
    count->passes[index] = (struct aob_count_pass){0};
    bool ok = count_part(parts, &whole, error) && restore(parts, &whole, error);
    free(parts);
    return ok || aob_fail_in(error, "pass '%s'", count->frame.graph.passes[index].name);
}

bool aob_count_run(struct aob_count *count, struct aob_error *error)
{
    count->unfit = false;
    for (int i = 0; i < count->frame.graph.pass_count; i++)
        if (count->frame.passes[i] && !count_pass(count, i, error))
            return aob_fail_in(error, "%s", count->frame.graph.technique->name);
    return true;
}
