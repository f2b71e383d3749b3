#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/machine.h"
#include "block.h"
#include "timing/fixed_pass.h"
#include "timing/probe.h"
#include "timing/timer.h"
#include "timing/timing.h"

/* One clock for all processes of a run: those after the first are told. */
static bool choose_clock(const struct aob_block *block, struct aob_timer_choice *choice,
                         struct aob_error *error)
{
    const struct aob_block_job *job = &block->job;
    if (!job->clock)
        return aob_timer_choose(block->drawing.gpu, choice, error);
    *choice = (struct aob_timer_choice){0};
    snprintf(choice->reason, sizeof choice->reason, "%s", job->clock_reason);
    return aob_clock_find(job->clock, &choice->clock) ||
           aob_fail(error, "a block job has an unknown clock '%s'", job->clock);
}

/* What is worth timing. */
static size_t list_good(const struct aob_block *block, size_t which[AOB_BLOCK_MAX])
{
    size_t count = 0;
    for (size_t f = 0; f < block->frame_count; f++)
        if (!block->job.score || block->good[f])
            which[count++] = f;
    return count;
}

/* A case dearer than the longest slot would take the rounds of its neighbours: it is left for a process of its own, unless
 * there is nothing else to time; then the first of them stays. */
static size_t leave_dear(const double *cost_ms, size_t which[AOB_BLOCK_MAX], size_t count)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; i++)
        if (cost_ms[i] <= AOB_SLOT_MOST_MS)
            which[kept++] = which[i];
    return kept || !count ? kept : 1;
}

/* The frames that are timed together. Processes after the first are told. */
static bool choose_frames(struct aob_block *block, enum aob_clock clock, size_t which[AOB_BLOCK_MAX],
                          size_t *count, struct aob_error *error)
{
    struct aob_frame *frames[AOB_BLOCK_MAX];
    double cost_ms[AOB_BLOCK_MAX];
    *count = list_good(block, which);
    for (size_t i = 0; i < *count; i++)
        frames[i] = &block->frames[which[i]];
    if (!block->job.score || !*count)
        return true;
    const struct aob_timing_desc desc = {.frames = frames, .frame_count = *count, .clock = clock};
    if (!aob_probe_costs(&desc, cost_ms, error))
        return false;
    *count = leave_dear(cost_ms, which, *count);
    return true;
}

static json_t *pass_names(const struct aob_frame *frame)
{
    json_t *names = json_array();
    for (int p = 0; p < frame->graph.pass_count; p++)
        if (frame->passes[p])
            json_array_append_new(names, json_string(frame->graph.passes[p].name));
    return names;
}

static void reply_timed(struct aob_worker *worker, const struct aob_block *block,
                        const struct aob_timer_choice *choice, const size_t *which, size_t count)
{
    const char *threads = getenv("LP_NUM_THREADS");
    struct aob_block_timed timed = {
        .clock = choice->clock, .threads = threads ? atoi(threads) : aob_machine_cores(), .count = count};
    snprintf(timed.clock_reason, sizeof timed.clock_reason, "%s", choice->reason);
    for (size_t i = 0; i < count; i++)
        timed.cases[i] = (struct aob_block_timed_case){
            block->case_of_frame[which[i]], block->setup_ms[which[i]], pass_names(&block->frames[which[i]])};
    aob_worker_reply(worker, aob_block_timed_to_json(&timed));
    aob_block_timed_finish(&timed);
}

static bool time_frames(struct aob_block *block, enum aob_clock clock, const size_t *which, size_t count,
                        struct aob_round_list *rounds, struct aob_error *error)
{
    struct aob_frame *frames[AOB_BLOCK_MAX];
    for (size_t i = 0; i < count; i++)
        frames[i] = &block->frames[which[i]];
    return aob_frame_init(&block->fixed, &block->drawing.screens[0], &aob_technique_fixed_pass, &(int32_t){0},
                          AOB_FETCH_SAMPLED, error) &&
           aob_timing_run(&(struct aob_timing_desc){.fixed = &block->fixed,
                                                    .frames = frames,
                                                    .frame_count = count,
                                                    .seconds = block->job.seconds,
                                                    .precision = block->job.precision,
                                                    .process = block->job.process,
                                                    .seed = block->job.seed,
                                                    .clock = clock},
                          rounds, error);
}

static void reply_rounds(struct aob_worker *worker, struct aob_block *block,
                         const struct aob_round_list *rounds)
{
    for (size_t r = 0; r < rounds->count; r++) {
        block->shares.measured += aob_round_seconds(&rounds->items[r]);
        aob_worker_reply(worker, json_pack("{s:o}", "round", aob_round_to_json(&rounds->items[r])));
    }
}

/* What a frame costs that has others before it: the first of a history, which a still view shows, finds nothing to read. */
static bool begin_history(struct aob_block *block, struct aob_error *error)
{
    for (size_t f = 0; f < block->frame_count; f++) {
        struct aob_frame *frame = &block->frames[f];
        unsigned char values[sizeof frame->values];
        if (frame->number || !aob_graph_keeps_history(&frame->graph))
            continue;
        memcpy(values, frame->values, sizeof values);
        if (!aob_frame_set(frame, 1, values, error))
            return false;
    }
    return true;
}

bool aob_block_measure(struct aob_worker *worker, struct aob_block *block, struct aob_error *error)
{
    struct aob_round_list rounds = {0};
    size_t which[AOB_BLOCK_MAX], count;
    struct aob_timer_choice choice;
    if (!choose_clock(block, &choice, error) || !begin_history(block, error) ||
        !choose_frames(block, choice.clock, which, &count, error))
        return false;
    if (!count)
        return true;
    reply_timed(worker, block, &choice, which, count);
    bool ok = time_frames(block, choice.clock, which, count, &rounds, error);
    if (ok)
        reply_rounds(worker, block, &rounds);
    aob_rounds_finish(&rounds);
    return ok;
}
