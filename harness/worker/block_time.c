#include <stdlib.h>
#include "base/machine.h"
#include "block.h"
#include "timing/fixed_pass.h"
#include "timing/timer.h"
#include "timing/timing.h"

/* Whose time this device's costs are: never the processor's where it only waits for another. The processes after the first
 * are told, so that they cannot differ. */
static bool choose_clock(const struct aob_block *block, enum aob_clock *clock, struct aob_error *error)
{
    struct aob_timer timer = {.trusted = false};
    if (block->job.clock)
        return aob_clock_find(block->job.clock, clock) ||
               aob_fail(error, "a block job has an unknown clock '%s'", block->job.clock);
    if (!block->gpu->info.software && !aob_timer_test(block->gpu, &timer, error))
        return false;
    *clock = block->gpu->info.software ? AOB_CLOCK_CPU : timer.trusted ? AOB_CLOCK_DEVICE : AOB_CLOCK_WALL;
    return true;
}

static int64_t time_by(enum aob_clock clock, const struct aob_gpu_time *time)
{
    return clock == AOB_CLOCK_CPU ? time->cpu_ns : clock == AOB_CLOCK_WALL ? time->wall_ns : time->device_ns;
}

/* A frame that the driver has compiled. */
static bool probe_cost(struct aob_block *block, size_t f, enum aob_clock clock, double *ms,
                       struct aob_error *error)
{
    struct aob_frame_time time;
    if (!aob_frame_run(&block->frames[f], 1, &time, error))
        return false;
    *ms = 1e-6 * (double)time_by(clock, &time.whole);
    return true;
}

/* The frames that are timed together. A case dearer than the longest slot would take the rounds of its neighbours: it is
 * left for a process of its own, unless there is nothing else to time. */
static bool choose_frames(struct aob_block *block, enum aob_clock clock, size_t *which, size_t *count,
                          struct aob_error *error)
{
    size_t dear = block->frame_count;
    double ms;
    *count = 0;
    for (size_t f = 0; f < block->frame_count; f++) {
        if (block->job.score && !block->good[f])
            continue;
        if (block->job.score && !probe_cost(block, f, clock, &ms, error))
            return false;
        if (!block->job.score || ms <= AOB_SLOT_MOST_MS)
            which[(*count)++] = f;
        else if (dear == block->frame_count)
            dear = f;
    }
    if (!*count && dear < block->frame_count)
        which[(*count)++] = dear;
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

static void reply_timed(struct aob_worker *worker, const struct aob_block *block, enum aob_clock clock,
                        const size_t *which, size_t count)
{
    const char *threads = getenv("LP_NUM_THREADS");
    struct aob_block_timed timed = {
        .clock = clock, .threads = threads ? atoi(threads) : aob_machine_cores(), .count = count};
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
    return aob_frame_init(&block->fixed, &block->screens[0], &aob_technique_fixed_pass, &(int32_t){0},
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

bool aob_block_measure(struct aob_worker *worker, struct aob_block *block, struct aob_error *error)
{
    struct aob_round_list rounds = {0};
    size_t which[AOB_BLOCK_MAX], count;
    enum aob_clock clock;
    if (!choose_clock(block, &clock, error) || !choose_frames(block, clock, which, &count, error))
        return false;
    if (!count)
        return true;
    reply_timed(worker, block, clock, which, count);
    bool ok = time_frames(block, clock, which, count, &rounds, error);
    if (ok)
        reply_rounds(worker, block, &rounds);
    aob_rounds_finish(&rounds);
    return ok;
}
