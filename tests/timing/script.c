#include "script.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "check.h"

static double or_default(double value, double initial)
{
    return value > 0 ? value : initial;
}

/* Milliseconds of a frame of the next slot of that index; -1 is the fixed pass. */
static void next_cost(struct script *s, int index, double *cpu, double *wall)
{
    int round = index < 0 ? 0 : s->runs[index] - SCRIPT_WARM_UP;
    if (index < 0)
        *cpu = or_default(s->settling_ms[s->fixed_runs++], or_default(s->fixed_ms, 2));
    else
        *cpu = s->cpu_ms ? s->cpu_ms(s, index, round) : 4;
    *wall = index >= 0 && s->wall_ms ? s->wall_ms(s, index, round) : 2 * *cpu;
    if (index < 0 || !s->cause)
        return;
    struct aob_causes now = s->cause(s, index, round);
    s->causes.involuntary += now.involuntary;
    s->causes.minor_faults += now.minor_faults;
    s->causes.steal_ticks += now.steal_ticks;
}

static struct aob_gpu_time share_of(const struct script *s, double cpu, double wall, double share)
{
    return (struct aob_gpu_time){.cpu_ns = (int64_t)llround(cpu * 1e6 * share),
                                 .wall_ns = (int64_t)llround(wall * 1e6 * share),
                                 .device_ns = s->device ? (int64_t)llround(3 * cpu * 1e6 * share) : 0};
}

/* Passes are 1 : 2 : 3 ... of the whole. */
static bool run(void *user, struct aob_frame *frame, int repeats, struct aob_frame_time *time,
                struct aob_error *error)
{
    struct script *s = user;
    int index = -1, count = frame->graph.pass_count;
    double cpu, wall;
    (void)error;
    for (int i = 0; i < SCRIPT_CASES; i++)
        index = frame == s->frames[i] ? i : index;
    next_cost(s, index, &cpu, &wall);
    *time = (struct aob_frame_time){.whole = share_of(s, cpu, wall, repeats)};
    for (int p = 0; p < count; p++)
        time->passes[p] = share_of(s, cpu, wall, 2.0 * repeats * (p + 1) / (count * (count + 1)));
    if (index >= 0)
        s->runs[index]++;
    assert_true(s->count < SCRIPT_RUNS_MAX);
    s->repeats[s->count] = repeats;
    s->order[s->count++] = index;
    return true;
}

static struct aob_causes causes(void *user)
{
    return ((struct script *)user)->causes;
}

/* The passes only have to be there: they are not run. */
static struct aob_frame *create_frame(int passes)
{
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    frame->graph.pass_count = passes;
    for (int p = 0; p < passes; p++)
        frame->passes[p] = (struct aob_gpu_pass *)(void *)frame;
    return frame;
}

struct script *script_create(void)
{
    struct script *s = AOB_NEW(struct script);
    s->fixed = create_frame(1);
    for (int i = 0; i < SCRIPT_CASES; i++)
        s->frames[i] = create_frame(1 + i);
    return s;
}

void script_destroy(struct script *s)
{
    free(s->fixed);
    for (int i = 0; i < SCRIPT_CASES; i++)
        free(s->frames[i]);
    free(s);
}

struct aob_timing_source script_source(struct script *s)
{
    return (struct aob_timing_source){run, causes, s};
}

struct aob_round_list script_measure(struct script *s, struct aob_timing_desc desc)
{
    const struct aob_timing_source source = script_source(s);
    struct aob_round_list rounds = {0};
    desc.fixed = s->fixed;
    desc.frames = s->frames;
    desc.frame_count = desc.frame_count ? desc.frame_count : SCRIPT_CASES;
    desc.precision = desc.precision > 0 ? desc.precision : 0.03;
    desc.source = &source;
    assert_true(aob_timing_run(&desc, &rounds, NULL));
    return rounds;
}

size_t script_count_rounds(struct script *s, struct aob_timing_desc desc)
{
    struct aob_round_list rounds = script_measure(s, desc);
    size_t count = rounds.count;
    aob_rounds_finish(&rounds);
    return count;
}

bool script_process(void *user, const struct aob_process_desc *process, struct aob_round_list *rounds,
                    struct aob_error *error)
{
    struct script_processes *processes = user;
    struct script *s = script_create();
    struct aob_timing_source source = script_source(s);
    size_t count = processes->case_count ? processes->case_count : SCRIPT_CASES;
    bool known = processes->fate && process->index < (int)strlen(processes->fate);
    char fate = known ? processes->fate[process->index] : '.';
    s->process = process->index;
    s->cpu_ms = processes->cpu_ms;
    s->cause = processes->cause;
    processes->asked[processes->count++] = *process;
    const struct aob_timing_desc desc = {.fixed = s->fixed,
                                         .frames = s->frames,
                                         .frame_count = fate == '?' ? count - 1 : count,
                                         .seconds = process->seconds,
                                         .precision = processes->precision,
                                         .process = process->index,
                                         .seed = process->seed,
                                         .source = &source};
    if (fate != '0')
        assert_true(aob_timing_run(&desc, rounds, NULL));
    script_destroy(s);
    return fate != 'x' || aob_fail(error, "it crashed");
}

void script_lost(void *user, int index, const char *reason)
{
    struct script_processes *processes = user;
    size_t used = strlen(processes->told);
    snprintf(processes->told + used, sizeof processes->told - used, "%d: %s; ", index, reason);
}
