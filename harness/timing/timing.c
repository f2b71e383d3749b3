#include "timing.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "estimate.h"
#include "standing.h"
#include "summary.h"

/* One block while one process measures it. */
struct run {
    const struct aob_timing_desc *desc;
    const struct aob_timing_source *source;
    size_t slots;
    double cost_ms[AOB_SLOT_MAX]; /* a frame, by the judged clock */
    int frames[AOB_SLOT_MAX];     /* a slot */
    struct aob_round_list *rounds;
    size_t first;      /* of this process in the list */
    double measured_s; /* wall time inside its slots */
    uint64_t random;
    size_t order[AOB_SLOT_MAX];
};

static bool run_on_device(void *user, struct aob_frame *frame, int repeats, struct aob_frame_time *time,
                          struct aob_error *error)
{
    (void)user;
    return aob_frame_run(frame, repeats, time, error);
}

static struct aob_causes causes_here(void *user)
{
    (void)user;
    return aob_causes_now();
}

static const struct aob_timing_source here = {run_on_device, causes_here, NULL};

static struct aob_frame *slot_frame(const struct run *run, size_t slot)
{
    return slot < AOB_SLOT_CASES ? run->desc->fixed : run->desc->frames[slot - AOB_SLOT_CASES];
}

/* A time that nobody took is 0 (gpu/gpu.h). */
static int64_t taken(int64_t ns)
{
    return ns > 0 ? ns : AOB_NO_TIME;
}

/* The host's clocks see the passes of one submit as a whole only, and the whole always. */
static struct aob_spent spent_in_pass(const struct aob_gpu_time *time)
{
    return (struct aob_spent){{[AOB_CLOCK_CPU] = taken(time->cpu_ns),
                               [AOB_CLOCK_WALL] = taken(time->wall_ns),
                               [AOB_CLOCK_DEVICE] = taken(time->device_ns)}};
}

static struct aob_spent spent_in_frame(const struct aob_gpu_time *time)
{
    struct aob_spent spent = spent_in_pass(time);
    spent.ns[AOB_CLOCK_CPU] = time->cpu_ns;
    spent.ns[AOB_CLOCK_WALL] = time->wall_ns;
    return spent;
}

static bool run_slot(const struct run *run, size_t slot, int frames, struct aob_slot *into,
                     struct aob_error *error)
{
    struct aob_frame *frame = slot_frame(run, slot);
    struct aob_frame_time time;
    struct aob_causes before = run->source->causes(run->source->user);
    if (!run->source->run(run->source->user, frame, frames, &time, error))
        return false;
    struct aob_causes after = run->source->causes(run->source->user);
    into->frames = frames;
    into->whole = spent_in_frame(&time.whole);
    into->causes = aob_causes_between(&before, &after);
    into->pass_count = 0;
    for (int p = 0; p < frame->graph.pass_count; p++)
        if (frame->passes[p])
            into->passes[into->pass_count++] = spent_in_pass(&time.passes[p]);
    return aob_standing_check(&time.whole, run->desc->clock, error);
}

/* Takes the slot's cost from so many of its frames. */
static bool probe_slot(struct run *run, size_t slot, int frames, struct aob_error *error)
{
    struct aob_slot probe;
    if (!run_slot(run, slot, frames, &probe, error))
        return false;
    run->cost_ms[slot] = aob_slot_ms(&probe, run->desc->clock);
    return true;
}

/* As many frames as take so long; a clock that stands still must not make them endless. */
static int frames_for(const struct run *run, size_t slot, double ms)
{
    const double most = 100000;
    return (int)fmax(fmin(round(ms / run->cost_ms[slot]), most), 1);
}

/* The fixed pass alone, until three successive slots of it agree within 10 %: on a processor ten at most. The clocks of
 * other devices rise with their load: they get a fifth of a second of it before their times count, and two seconds at
 * most. */
static bool settle(struct run *run, struct aob_error *error)
{
    const bool ramps = run->desc->clock != AOB_CLOCK_CPU;
    const double least_ms = ramps ? 200 : 0, most_ms = ramps ? 2000 : INFINITY;
    double loaded_ms = 0, older, old = INFINITY, now = INFINITY;
    for (int slots = 0; (ramps || slots < 10) && loaded_ms < most_ms; slots++) {
        int frames = frames_for(run, AOB_SLOT_FIXED, AOB_SLOT_LEAST_MS);
        if (!probe_slot(run, AOB_SLOT_FIXED, frames, error))
            return false;
        older = old;
        old = now;
        now = run->cost_ms[AOB_SLOT_FIXED];
        loaded_ms += now * frames;
        if (fabs(now - old) < 0.1 * now && fabs(old - older) < 0.1 * now && loaded_ms >= least_ms)
            break;
    }
    return true;
}

static bool warm_up(struct run *run, struct aob_error *error)
{
    for (int turn = 0; turn < 2; turn++)
        for (size_t s = 0; s < run->slots; s++)
            if (!probe_slot(run, s, 1, error))
                return false;
    return settle(run, error);
}

/* From as many frames as can be measured well. */
static bool choose_frames(struct run *run, struct aob_error *error)
{
    double dearest = 0;
    for (size_t s = 0; s < run->slots; s++) {
        if (!probe_slot(run, s, frames_for(run, s, AOB_SLOT_LEAST_MS), error))
            return false;
        dearest = fmax(dearest, run->cost_ms[s]);
    }
    double slot_ms = fmin(fmax(dearest, AOB_SLOT_LEAST_MS), AOB_SLOT_MOST_MS);
    for (size_t s = 0; s < run->slots; s++)
        run->frames[s] = frames_for(run, s, slot_ms);
    return true;
}

static size_t random_below(struct run *run, size_t n)
{
    run->random = run->random * 6364136223846793005u + 1442695040888963407u;
    return (size_t)(run->random >> 33) % n;
}

/* A new cyclic Latin square every `slots` rounds: a shuffled row, then rotated by one a round. */
static void order_round(struct run *run, size_t round)
{
    if (round % run->slots == 0) {
        for (size_t i = 0; i < run->slots; i++)
            run->order[i] = i;
        for (size_t i = run->slots - 1; i > 0; i--) {
            size_t j = random_below(run, i + 1), moved = run->order[i];
            run->order[i] = run->order[j];
            run->order[j] = moved;
        }
        return;
    }
    size_t first = run->order[0];
    memmove(run->order, run->order + 1, (run->slots - 1) * sizeof *run->order);
    run->order[run->slots - 1] = first;
}

static bool run_round(struct run *run, size_t number, struct aob_error *error)
{
    struct aob_round *round = AOB_PUSH(run->rounds->items, run->rounds->count, run->rounds->capacity);
    *round = (struct aob_round){.process = run->desc->process,
                                .number = (int)number,
                                .seed = run->desc->seed,
                                .clock = run->desc->clock,
                                .slot_count = run->slots};
    order_round(run, number);
    for (size_t i = 0; i < run->slots; i++) {
        size_t slot = run->order[i];
        round->slots[slot].place = (int)i;
        if (!run_slot(run, slot, run->frames[slot], &round->slots[slot], error))
            return false;
    }
    run->measured_s += aob_round_seconds(round);
    return true;
}

size_t aob_timing_check_point(size_t rounds)
{
    double n = 20;
    while ((size_t)n < rounds)
        n *= 1.5;
    return (size_t)n;
}

static bool is_narrow(const struct aob_timing_desc *desc, const struct aob_round_list *own)
{
    for (size_t i = 0; i < desc->frame_count; i++) {
        struct aob_ratio ratio = aob_rounds_ratio(own, AOB_SLOT_CASES + i);
        if (aob_estimate_half_width(&ratio) > desc->precision)
            return false;
    }
    return true;
}

bool aob_timing_is_over(const struct aob_timing_desc *desc, const struct aob_round_list *rounds, size_t first,
                        double measured_s)
{
    const struct aob_round_list own = {.items = rounds->items + first, .count = rounds->count - first};
    if (own.count >= AOB_ROUNDS_LEAST && measured_s >= desc->seconds * (double)desc->frame_count)
        return true;
    return own.count == aob_timing_check_point(own.count) && is_narrow(desc, &own);
}

static bool measure(struct run *run, struct aob_error *error)
{
    for (size_t count = 0; !aob_timing_is_over(run->desc, run->rounds, run->first, run->measured_s); count++)
        if (!run_round(run, count, error))
            return false;
    return true;
}

bool aob_timing_run(const struct aob_timing_desc *desc, struct aob_round_list *rounds,
                    struct aob_error *error)
{
    struct run run = {.desc = desc,
                      .source = desc->source ? desc->source : &here,
                      .slots = AOB_SLOT_CASES + desc->frame_count,
                      .rounds = rounds,
                      .first = rounds->count,
                      .random = desc->seed};
    return warm_up(&run, error) && choose_frames(&run, error) && measure(&run, error);
}
