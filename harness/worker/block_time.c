#include <stdlib.h>
#include "base/clock.h"
#include "base/json.h"
#include "base/machine.h"
#include "block.h"

/* One timing run of some of the block's frames; its results go to their places. */
static bool time_frames(struct aob_block *block, const size_t *which, size_t count, struct aob_error *error)
{
    struct aob_frame *frames[AOB_BLOCK_MAX];
    struct aob_block_timing timing;
    for (size_t i = 0; i < count; i++)
        frames[i] = &block->frames[which[i]];
    if (!aob_timing_run(&(struct aob_timing_desc){.fixed = &block->fixed,
                                                  .frames = frames,
                                                  .frame_count = count,
                                                  .seconds = block->job.seconds,
                                                  .narrow = block->job.narrow,
                                                  .seed = 1,
                                                  .wall = !block->gpu->info.software},
                        &timing, error))
        return false;
    for (size_t i = 0; i < count; i++) {
        block->timing[which[i]] = timing;
        block->timing[which[i]].cases[0] = timing.cases[i];
        block->shares.measured += timing.cases[i].measured_s;
    }
    block->shares.measured += timing.fixed_s;
    return true;
}

/* A frame in milliseconds of this process, after the driver has compiled it. */
static bool probe_cost(struct aob_block *block, size_t f, double *ms, struct aob_error *error)
{
    int64_t start = 0;
    for (int i = 0; i < 2; i++) {
        start = aob_clock_cpu_ns();
        if (!aob_frame_run(&block->frames[f], 1, NULL, error))
            return false;
    }
    *ms = (double)(aob_clock_cpu_ns() - start) * 1e-6;
    return true;
}

/* A case dearer than 100 ms a frame is timed by itself: it would take the rounds of its neighbours. */
bool aob_block_measure(struct aob_block *block, struct aob_error *error)
{
    size_t cheap[AOB_BLOCK_MAX], cheap_count = 0;
    double ms;
    for (size_t f = 0; f < block->frame_count; f++) {
        if (!probe_cost(block, f, &ms, error))
            return false;
        if (ms <= 100)
            cheap[cheap_count++] = f;
        else if (!time_frames(block, &f, 1, error))
            return false;
    }
    return !cheap_count || time_frames(block, cheap, cheap_count, error);
}

/* The interval is null where there are too few rounds for one. */
static json_t *bound_to_json(const struct aob_ratio *ratio, double bound)
{
    return ratio->bounded ? json_real(bound) : json_null();
}

static json_t *passes_to_json(const struct aob_frame *frame, const struct aob_timing *t)
{
    json_t *passes = json_array();
    for (int p = 0; p < frame->graph.pass_count; p++) {
        const struct aob_ratio *ratio = &t->pass_to_fixed[p];
        if (frame->passes[p])
            json_array_append_new(passes,
                                  json_pack("{s:s, s:f, s:f, s:o, s:o}", "name", frame->graph.passes[p].name,
                                            "cpu_ms", t->pass_cpu_ms[p], "ratio_to_ref", ratio->ratio,
                                            "ci_low", bound_to_json(ratio, ratio->low), "ci_high",
                                            bound_to_json(ratio, ratio->high)));
    }
    return passes;
}

json_t *aob_block_time_to_json(const struct aob_block *block, size_t f)
{
    const struct aob_block_timing *run = &block->timing[f];
    const struct aob_timing *t = &run->cases[0];
    const char *threads = getenv("LP_NUM_THREADS");
    return json_pack("{s:s, s:f, s:o, s:f, s:o, s:o, s:i, s:i, s:i, s:f, s:f, s:f, s:f, s:o}", "clock",
                     block->gpu->info.software ? "cpu" : "wall", "cpu_ms", t->cpu_ms, "wall_ms",
                     aob_json_number(t->wall_ms), "ratio_to_ref", t->to_fixed.ratio, "ci_low",
                     bound_to_json(&t->to_fixed, t->to_fixed.low), "ci_high",
                     bound_to_json(&t->to_fixed, t->to_fixed.high), "rounds", (int)t->rounds, "clean_rounds",
                     (int)t->clean_rounds, "threads", threads ? atoi(threads) : aob_machine_cores(),
                     "setup_ms", block->setup_ms[f], "ref_cpu_ms", run->fixed_cpu_ms, "control_low",
                     run->control.low, "control_high", run->control.high, "passes",
                     passes_to_json(&block->frames[f], t));
}
