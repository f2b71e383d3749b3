#include "script.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "check.h"

static double or_default(double value, double initial)
{
    return value > 0 ? value : initial;
}

/* Milliseconds of the next frame of that index; -1 is the fixed pass. */
static void next_cost(struct script *s, int index, double *cpu, double *wall)
{
    int round = index < 0 ? 0 : s->runs[index]++ - SCRIPT_WARM_UP;
    if (index < 0)
        *cpu = or_default(s->fixed_ms[s->fixed_runs++], 2);
    else
        *cpu = s->cpu_ms ? s->cpu_ms(index, round) : 4;
    *wall = index >= 0 && s->wall_ms ? s->wall_ms(index, round) : 2 * *cpu;
    s->preemptions += index >= 0 && s->preempted && s->preempted(index, round);
}

/* Adds a share of a cost in milliseconds. */
static void add_share(struct aob_gpu_time *time, double cpu, double wall, double share)
{
    time->cpu_ns += (int64_t)llround(cpu * 1e6 * share);
    time->wall_ns += (int64_t)llround(wall * 1e6 * share);
}

/* One frame a slot and round, where each takes more than the 2 ms that are enough. Passes are 1 : 2 : 3 ... of the
 * whole. */
static bool run(void *user, struct aob_frame *frame, int repeats, struct aob_frame_time *time,
                struct aob_error *error)
{
    struct script *s = user;
    int index = -1, count = frame->graph.pass_count;
    (void)error;
    *time = (struct aob_frame_time){0};
    for (int i = 0; i < SCRIPT_CASES; i++)
        index = frame == s->frames[i] ? i : index;
    for (int r = 0; r < repeats; r++) {
        double cpu, wall;
        next_cost(s, index, &cpu, &wall);
        add_share(&time->whole, cpu, wall, 1);
        for (int p = 0; p < count; p++)
            add_share(&time->passes[p], cpu, wall, 2.0 * (p + 1) / (count * (count + 1)));
        s->now += (int64_t)llround(wall * 1e6);
        assert_true(s->count < SCRIPT_RUNS_MAX);
        s->order[s->count++] = index;
    }
    return true;
}

static int64_t now_ns(void *user)
{
    return ((struct script *)user)->now;
}

static int64_t preemptions(void *user)
{
    return ((struct script *)user)->preemptions;
}

struct script *script_create(void)
{
    struct script *s = AOB_NEW(struct script);
    s->fixed = AOB_NEW(struct aob_frame);
    s->fixed->graph.pass_count = 1;
    for (int i = 0; i < SCRIPT_CASES; i++) {
        s->frames[i] = AOB_NEW(struct aob_frame);
        s->frames[i]->graph.pass_count = 1 + i;
    }
    return s;
}

void script_destroy(struct script *s)
{
    free(s->fixed);
    for (int i = 0; i < SCRIPT_CASES; i++)
        free(s->frames[i]);
    free(s);
}

struct aob_timing_clock script_clock(struct script *s)
{
    return (struct aob_timing_clock){run, now_ns, preemptions, s};
}
