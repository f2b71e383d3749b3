#include "probe.h"
#include <math.h>
#include "standing.h"

static int64_t time_by(enum aob_clock clock, const struct aob_gpu_time *time)
{
    return clock == AOB_CLOCK_CPU ? time->cpu_ns : clock == AOB_CLOCK_WALL ? time->wall_ns : time->device_ns;
}

/* Adds to `loaded_ms` what the frames took. */
static bool probe(const struct aob_timing_desc *desc, size_t at, int frames, double *cost_ms,
                  double *loaded_ms, struct aob_error *error)
{
    const struct aob_timing_source *source = desc->source;
    struct aob_frame_time time;
    bool ok = source ? source->run(source->user, desc->frames[at], frames, &time, error)
                     : aob_frame_run(desc->frames[at], frames, &time, error);
    if (!ok || !aob_standing_check(&time.whole, desc->clock, error))
        return false;
    *cost_ms = 1e-6 * (double)time_by(desc->clock, &time.whole) / frames;
    *loaded_ms += 1e-6 * (double)time.whole.wall_ns;
    return true;
}

/* A submit for each frame would leave a device idle in between; a clock that stands still must not make them endless. */
static int frames_of(double cost_ms)
{
    return (int)fmax(fmin(AOB_SLOT_LEAST_MS / fmax(cost_ms, 1e-9), 100000), 1);
}

bool aob_probe_costs(const struct aob_timing_desc *desc, double cost_ms[AOB_BLOCK_MAX],
                     struct aob_error *error)
{
    const double least_ms = desc->clock == AOB_CLOCK_CPU ? 0 : AOB_PROBE_LOAD_MS;
    double loaded_ms = 0;
    for (size_t i = 0; i < desc->frame_count; i++)
        if (!probe(desc, i, 1, &cost_ms[i], &loaded_ms, error))
            return false;
    while (loaded_ms < least_ms)
        for (size_t i = 0; i < desc->frame_count; i++)
            if (!probe(desc, i, frames_of(cost_ms[i]), &cost_ms[i], &loaded_ms, error))
                return false;
    return true;
}
