#include "trial.h"
#include <math.h>
#include <stdlib.h>
#include "base/clock.h"
#include "base/memory.h"

enum { FIXED, CONTROL, CASE, SLOTS };
static const double least_ms = 2, most_ms = 100; /* of a slot */

struct run {
    const struct aob_trial_desc *desc;
    int frames[SLOTS];
    size_t rounds;
    int64_t end_ns;
    double ms[SLOTS][AOB_TRIAL_ROUNDS], passes[AOB_MAX_PASS][AOB_TRIAL_ROUNDS], share[AOB_TRIAL_ROUNDS];
};

static int64_t ns_of(const struct run *run, const struct aob_gpu_time *time)
{
    const int64_t ns[] = {[AOB_CLOCK_CPU] = time->cpu_ns,
                          [AOB_CLOCK_WALL] = time->wall_ns,
                          [AOB_CLOCK_DEVICE] = time->device_ns};
    return ns[run->desc->clock];
}

/* Milliseconds of one of so many frames; positive, as ratios are taken of it. */
static double ms_of(const struct run *run, const struct aob_gpu_time *time, int frames)
{
    return fmax((double)ns_of(run, time) * 1e-6 / frames, 1e-9);
}

static struct aob_frame *frame_of(const struct run *run, int slot)
{
    return slot == CASE ? run->desc->frame : run->desc->fixed;
}

static bool probe(const struct run *run, int slot, int frames, double *ms, struct aob_error *error)
{
    struct aob_frame_time time;
    if (!aob_frame_run(frame_of(run, slot), frames, &time, error))
        return false;
    *ms = ms_of(run, &time.whole, frames);
    return true;
}

static int frames_for(double slot_ms, double frame_ms)
{
    return (int)fmin(fmax(round(slot_ms / frame_ms), 1), 100000);
}

static bool ramp_up(const struct run *run, struct aob_error *error)
{
    const int64_t end_ns = aob_clock_wall_ns() + 200000000;
    double ms;
    while (run->desc->ramps && aob_clock_wall_ns() < end_ns)
        if (!probe(run, FIXED, 100, &ms, error))
            return false;
    return true;
}

/* Drivers compile at the first draw, so a second and some more say what a frame takes; one that takes longer than a slot
 * may needs no more. */
static bool probe_slot(const struct run *run, int slot, double *ms, struct aob_error *error)
{
    if (!probe(run, slot, 1, ms, error))
        return false;
    if (*ms > most_ms)
        return true;
    return probe(run, slot, 1, ms, error) && ramp_up(run, error) &&
           probe(run, slot, frames_for(least_ms, *ms), ms, error);
}

static bool choose_frames(struct run *run, struct aob_error *error)
{
    double ms[SLOTS], slot_ms = least_ms;
    for (int s = 0; s < SLOTS; s++) {
        if (!probe_slot(run, s, &ms[s], error))
            return false;
        slot_ms = fmin(fmax(slot_ms, ms[s]), most_ms);
    }
    for (int s = 0; s < SLOTS; s++)
        run->frames[s] = frames_for(slot_ms, ms[s]);
    return true;
}

static bool run_slot(struct run *run, int slot, struct aob_error *error)
{
    struct aob_frame *frame = frame_of(run, slot);
    struct aob_frame_time time;
    int64_t sum = 0;
    if (!aob_frame_run(frame, run->frames[slot], &time, error))
        return false;
    run->ms[slot][run->rounds] = ms_of(run, &time.whole, run->frames[slot]);
    for (int p = 0; slot == CASE && p < frame->graph.pass_count; p++) {
        run->passes[p][run->rounds] = ms_of(run, &time.passes[p], run->frames[slot]);
        sum += ns_of(run, &time.passes[p]);
    }
    if (slot == CASE)
        run->share[run->rounds] = sum ? (double)sum / (double)ns_of(run, &time.whole) : NAN;
    return true;
}

static bool is_narrow(const struct run *run)
{
    struct aob_ratio r = aob_paired_ratio(run->ms[CASE], run->ms[FIXED], run->rounds);
    return run->rounds >= 20 && r.high <= 1.01 * r.ratio && r.low >= r.ratio / 1.01;
}

static bool run_rounds(struct run *run, struct aob_error *error)
{
    do {
        for (int i = 0; i < SLOTS; i++)
            if (!run_slot(run, (int)((run->rounds + (size_t)i) % SLOTS), error))
                return false;
        run->rounds++;
    } while (run->rounds < AOB_TRIAL_ROUNDS && aob_clock_wall_ns() < run->end_ns && !is_narrow(run));
    return true;
}

static struct aob_trial_time summarise(const double *ms, size_t rounds)
{
    struct aob_trial_time time = {aob_median(ms, rounds), NAN, NAN};
    if (!aob_median_interval(ms, rounds, &time.low, &time.high))
        time.low = time.high = NAN;
    return time;
}

bool aob_trial_run(const struct aob_trial_desc *desc, struct aob_trial *trial, struct aob_error *error)
{
    struct run *run = AOB_NEW(struct run);
    run->desc = desc;
    run->end_ns = aob_clock_wall_ns() + (int64_t)(desc->seconds * 1e9);
    bool ok = choose_frames(run, error) && run_rounds(run, error);
    if (ok) {
        *trial =
            (struct aob_trial){.rounds = run->rounds,
                               .frames = run->frames[CASE],
                               .whole = summarise(run->ms[CASE], run->rounds),
                               .fixed = summarise(run->ms[FIXED], run->rounds),
                               .passes_share = aob_median(run->share, run->rounds),
                               .to_fixed = aob_paired_ratio(run->ms[CASE], run->ms[FIXED], run->rounds),
                               .control = aob_paired_ratio(run->ms[CONTROL], run->ms[FIXED], run->rounds)};
        for (int p = 0; p < desc->frame->graph.pass_count; p++)
            trial->passes[p] = summarise(run->passes[p], run->rounds);
    }
    free(run);
    return ok;
}
