#include "block.h"
#include <stdlib.h>
#include "base/clock.h"
#include "base/memory.h"
#include "block_sequence.h"

static double seconds_since(int64_t start)
{
    return (double)(aob_clock_wall_ns() - start) * 1e-9;
}

static void reply_failure(struct aob_worker *worker, size_t index, const char *status, const char *reason)
{
    aob_worker_reply(worker,
                     json_pack("{s:i, s:s, s:s}", "index", (int)index, "status", status, "reason", reason));
}

static void reply_all(struct aob_worker *worker, const struct aob_block *block, const char *status,
                      const char *reason)
{
    for (size_t i = 0; i < block->job.case_count; i++)
        reply_failure(worker, i, status, reason);
}

/* False: its status and reason are in the two last. */
static bool init_frame(struct aob_block *block, size_t index, const char **status, struct aob_error *error)
{
    struct aob_frame *frame = &block->frames[block->frame_count];
    struct aob_drawing_part part;
    *status = "failed";
    if (!aob_drawing_set(&block->drawing, &block->job.cases[index].frame, &part, error)) {
        *status = part.unfit ? "unsupported" : "failed";
        return false;
    }
    int64_t start = aob_clock_wall_ns();
    const struct aob_frame_desc desc = {
        .technique = part.technique, .values = part.values, .fetch = part.fetch, .wanted = part.wanted};
    if (!aob_frame_init_desc(frame, part.screen, &desc, error)) {
        *status = frame->unfit ? "unsupported" : "failed";
        return false;
    }
    block->setup_ms[block->frame_count] = seconds_since(start) * 1e3;
    block->case_of_frame[block->frame_count++] = index;
    return true;
}

/* A case that has no frame is told where cases are judged; a process that only times has failed then. */
static bool init_frames(struct aob_worker *worker, struct aob_block *block, struct aob_error *error)
{
    for (size_t i = 0; i < block->job.case_count; i++) {
        struct aob_error why = {{0}};
        const char *status;
        if (init_frame(block, i, &status, &why))
            continue;
        if (!block->job.score)
            return aob_fail(error, "%s", why.text);
        reply_failure(worker, i, status, why.text);
    }
    return true;
}

static void reply_case(struct aob_worker *worker, struct aob_block *block, size_t f)
{
    struct aob_error error = {{0}};
    json_t *answer = json_pack("{s:i, s:s, s:I, s:o}", "index", (int)block->case_of_frame[f], "status",
                               "failed", "memory_bytes", (json_int_t)block->frames[f].memory_bytes,
                               "fingerprint", aob_drawing_fingerprint(&block->drawing));
    if (block->drawing.difference)
        json_object_set(answer, "gbuffer", block->drawing.difference);
    block->good[f] = aob_block_score(block, f, answer, &error);
    if (block->good[f])
        json_object_set_new(answer, "status", json_string("ok"));
    else
        json_object_set_new(answer, "reason", json_string(error.text));
    aob_worker_reply(worker, answer);
}

/* Images come first, so that only what is worth it is timed. */
static bool run_cases(struct aob_worker *worker, struct aob_block *block, struct aob_error *error)
{
    int64_t start = aob_clock_wall_ns();
    if (!init_frames(worker, block, error))
        return false;
    int64_t begun = aob_clock_wall_ns();
    if (!aob_block_sequence_draw(block, error))
        return false;
    block->shares.images += seconds_since(begun);
    for (size_t f = 0; block->job.score && f < block->frame_count; f++)
        reply_case(worker, block, f);
    if (block->job.time && !aob_block_measure(worker, block, error))
        return false;
    /* compiling, probing, warming up */
    block->shares.warmup = seconds_since(start) - block->shares.measured - block->shares.images;
    aob_worker_reply(worker, aob_block_shares_to_json(&block->shares));
    return true;
}

static void finish_block(struct aob_block *block)
{
    for (size_t f = 0; f < block->frame_count; f++)
        aob_frame_finish(&block->frames[f]);
    aob_frame_finish(&block->fixed);
    aob_drawing_finish(&block->drawing);
    aob_block_sequence_destroy(block->sequence);
    aob_block_job_finish(&block->job);
    free(block);
}

static bool run_block(struct aob_worker *worker, struct aob_error *error)
{
    struct aob_block *block = AOB_NEW(struct aob_block);
    bool ok = aob_block_job_from_json(worker->job, &block->job, error) &&
              aob_drawing_load(&block->drawing, &block->job.drawing, error);
    bool opened = ok && aob_drawing_open(&block->drawing, error);
    if (opened)
        ok = run_cases(worker, block, error);
    else if (ok && block->job.score)
        reply_all(worker, block, "unsupported", error->text);
    else
        ok = false;
    finish_block(block);
    return ok;
}

const struct aob_worker_job aob_worker_block = {"block", run_block};
