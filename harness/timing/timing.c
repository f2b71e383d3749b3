#include "timing.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/clock.h"
#include "base/memory.h"

enum { SLOT_FIXED, SLOT_CONTROL, SLOT_CASES, SLOT_MAX = SLOT_CASES + AOB_BLOCK_MAX };

/* One block while it is measured: rounds x slots of times. */
struct run {
    const struct aob_timing_desc *desc;
    const struct aob_timing_clock *clock;
    size_t slots, rounds;
    int repeats; /* frames a slot */
    double cpu[SLOT_MAX][AOB_ROUNDS_MAX], wall[SLOT_MAX][AOB_ROUNDS_MAX];
    bool clean[SLOT_MAX][AOB_ROUNDS_MAX];
    double pass_cpu[AOB_BLOCK_MAX][AOB_MAX_PASS][AOB_ROUNDS_MAX];
    uint64_t random;
    size_t order[SLOT_MAX];
};

static bool run_on_device(void *user, struct aob_frame *frame, int repeats, struct aob_frame_time *time,
                          struct aob_error *error)
{
    (void)user;
    return aob_frame_run(frame, repeats, time, error);
}

static int64_t machine_now(void *user)
{
    (void)user;
    return aob_clock_wall_ns();
}

static int64_t machine_preemptions(void *user)
{
    (void)user;
    return aob_clock_preemptions();
}

static const struct aob_timing_clock machine = {run_on_device, machine_now, machine_preemptions, NULL};

static int64_t now_ns(const struct run *run)
{
    return run->clock->now_ns(run->clock->user);
}

static int64_t preemptions(const struct run *run)
{
    return run->clock->preemptions(run->clock->user);
}

static struct aob_frame *slot_frame(const struct run *run, size_t slot)
{
    return slot < SLOT_CASES ? run->desc->fixed : run->desc->frames[slot - SLOT_CASES];
}

/* Of one frame of the slot's; positive, as ratios are taken of it. */
static double frame_ms(const struct run *run, int64_t ns)
{
    return fmax((double)ns * 1e-6 / run->repeats, 1e-9);
}

static bool run_slot(struct run *run, size_t slot, size_t round, struct aob_error *error)
{
    struct aob_frame *frame = slot_frame(run, slot);
    struct aob_frame_time time;
    int64_t preempted = preemptions(run);
    if (!run->clock->run(run->clock->user, frame, run->repeats, &time, error))
        return false;
    run->clean[slot][round] = preemptions(run) == preempted;
    run->cpu[slot][round] = frame_ms(run, time.whole.cpu_ns);
    run->wall[slot][round] = frame_ms(run, time.whole.wall_ns);
    for (int p = 0; slot >= SLOT_CASES && p < frame->graph.pass_count; p++)
        run->pass_cpu[slot - SLOT_CASES][p][round] = frame_ms(run, time.passes[p].cpu_ns);
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

static bool run_round(struct run *run, size_t round, struct aob_error *error)
{
    order_round(run, round);
    for (size_t i = 0; i < run->slots; i++)
        if (!run_slot(run, run->order[i], round, error))
            return false;
    return true;
}

/* Two whole rounds (drivers compile at the first draw), then the fixed pass alone until three successive ones
 * agree within 10 %, ten at most. */
static bool warm_up(struct run *run, struct aob_error *error)
{
    for (size_t round = 0; round < 2; round++)
        if (!run_round(run, round, error))
            return false;
    for (size_t round = 2; round < 12; round++) {
        const double *cpu = &run->cpu[SLOT_FIXED][round];
        if (!run_slot(run, SLOT_FIXED, round, error))
            return false;
        if (round >= 4 && fabs(cpu[0] - cpu[-1]) < 0.1 * cpu[0] && fabs(cpu[-1] - cpu[-2]) < 0.1 * cpu[0])
            break;
    }
    return true;
}

/* A slot has as many frames as make the cheapest take 2 ms, as long as the dearest stays within 100 ms. */
static void choose_repeats(struct run *run)
{
    double cheapest = INFINITY, dearest = 0;
    for (size_t s = 0; s < run->slots; s++) {
        cheapest = fmin(cheapest, run->cpu[s][1]);
        dearest = fmax(dearest, run->cpu[s][1]);
    }
    double wanted = fmin(ceil(2 / cheapest), floor(100 / dearest));
    run->repeats = wanted < 1 ? 1 : wanted > 16 ? 16 : (int)wanted;
}

static const double *judged(const struct run *run, size_t slot)
{
    return run->desc->wall ? run->wall[slot] : run->cpu[slot];
}

static bool is_check_point(size_t rounds)
{
    for (double n = 20; n < AOB_ROUNDS_MAX; n *= 1.5)
        if ((size_t)n == rounds)
            return true;
    return false;
}

static bool narrow_enough(const struct run *run)
{
    double factor = 1 + (run->desc->narrow > 0 ? run->desc->narrow : 0.03);
    for (size_t s = SLOT_CASES; s < run->slots; s++) {
        struct aob_ratio r = aob_paired_ratio(judged(run, s), judged(run, SLOT_FIXED), run->rounds);
        if (!r.bounded || r.high > r.ratio * factor || r.low < r.ratio / factor)
            return false;
    }
    return true;
}

static bool measure(struct run *run, struct aob_error *error)
{
    int64_t limit = now_ns(run) + (int64_t)(run->desc->seconds * (double)run->desc->frame_count * 1e9);
    for (run->rounds = 0; run->rounds < AOB_ROUNDS_MAX;) {
        if (!run_round(run, run->rounds, error))
            return false;
        run->rounds++;
        if (is_check_point(run->rounds) && narrow_enough(run))
            break;
        if (run->rounds >= 6 && now_ns(run) > limit) /* six: the fewest that have an interval */
            break;
    }
    return true;
}

static double total_seconds(const struct run *run, size_t slot)
{
    double sum = 0;
    for (size_t r = 0; r < run->rounds; r++)
        sum += run->wall[slot][r] * run->repeats * 1e-3;
    return sum;
}

static void summarise(const struct run *run, size_t index, struct aob_timing *timing)
{
    size_t slot = SLOT_CASES + index;
    double clean[AOB_ROUNDS_MAX];
    *timing = (struct aob_timing){.rounds = run->rounds};
    for (size_t r = 0; r < run->rounds; r++)
        if (run->clean[slot][r])
            clean[timing->clean_rounds++] = run->wall[slot][r];
    timing->cpu_ms = aob_median(run->cpu[slot], run->rounds);
    timing->wall_ms = timing->clean_rounds ? aob_median(clean, timing->clean_rounds) : NAN;
    timing->to_fixed = aob_paired_ratio(judged(run, slot), judged(run, SLOT_FIXED), run->rounds);
    timing->measured_s = total_seconds(run, slot);
    for (int p = 0; p < run->desc->frames[index]->graph.pass_count; p++) {
        timing->pass_cpu_ms[p] = aob_median(run->pass_cpu[index][p], run->rounds);
        timing->pass_to_fixed[p] =
            aob_paired_ratio(run->pass_cpu[index][p], run->cpu[SLOT_FIXED], run->rounds);
    }
}

bool aob_timing_run(const struct aob_timing_desc *desc, struct aob_block_timing *result,
                    struct aob_error *error)
{
    struct run *run = AOB_NEW(struct run);
    *run = (struct run){.desc = desc,
                        .clock = desc->clock ? desc->clock : &machine,
                        .slots = SLOT_CASES + desc->frame_count,
                        .repeats = 1,
                        .random = desc->seed};
    bool ok = warm_up(run, error);
    if (ok)
        choose_repeats(run);
    ok = ok && measure(run, error);
    for (size_t i = 0; ok && i < desc->frame_count; i++)
        summarise(run, i, &result->cases[i]);
    if (ok) {
        result->control = aob_paired_ratio(judged(run, SLOT_CONTROL), judged(run, SLOT_FIXED), run->rounds);
        result->fixed_cpu_ms = aob_median(run->cpu[SLOT_FIXED], run->rounds);
        result->fixed_s = total_seconds(run, SLOT_FIXED) + total_seconds(run, SLOT_CONTROL);
    }
    free(run);
    return ok;
}
