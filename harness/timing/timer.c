#include "timer.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "base/memory.h"
#include "base/statistics.h"
#include "base/text.h"
#include "standing.h"

enum { SIDE = 1024, FIRST_TRIPS = 64, MOST_TRIPS = 1 << 20 };
static const int64_t enough_ns = 4000000, /* of the smallest pass: its begin and end are a few per cent */
    load_ns = 300000000;                  /* within which the frequency of a device rises */

/* The smallest pass draws a quarter of the target, the others twice and four times as much. */
enum { SMALL, TWICE, WHOLE, PASSES };
enum { ONE_SMALL, ONE_TWICE, ONE_WHOLE, SMALL_2, SMALL_4, LIST, WORKS };
static const struct {
    size_t passes[2], count;
    int repeats;
} works[WORKS] = {
    [ONE_SMALL] = {{SMALL}, 1, 1}, [ONE_TWICE] = {{TWICE}, 1, 1}, [ONE_WHOLE] = {{WHOLE}, 1, 1},
    [SMALL_2] = {{SMALL}, 1, 2},   [SMALL_4] = {{SMALL}, 1, 4},   [LIST] = {{SMALL, WHOLE}, 2, 1},
};

struct bench {
    struct aob_gpu *gpu;
    struct aob_gpu_texture *target;
    struct aob_gpu_program *program;
    struct aob_gpu_pass *passes[PASSES];
};
struct reading {
    struct aob_gpu_time whole, passes[2];
};

static void drop_passes(struct bench *bench)
{
    for (size_t i = 0; i < PASSES; i++)
        aob_gpu_pass_destroy(bench->gpu, bench->passes[i]);
    aob_gpu_program_destroy(bench->gpu, bench->program);
    memset(bench->passes, 0, sizeof bench->passes);
    bench->program = NULL;
}

/* Arithmetic that no compiler shortens, the same at each pixel. */
static bool make_passes(struct bench *bench, int trips, struct aob_error *error)
{
    struct aob_text text = {0};
    aob_text_add(&text,
                 "layout(location = 0) out float r;\nvoid main() {\n    float x = gl_FragCoord.x * 0.001;\n"
                 "    for (int i = 0; i < %d; i++) x = fract(x * 1.7 + 0.3);\n    r = x;\n}\n",
                 trips);
    drop_passes(bench);
    bench->program = aob_gpu_program_create(bench->gpu, text.data, error);
    aob_text_finish(&text);
    const struct aob_gpu_target target = {bench->target, 0};
    for (int i = 0; bench->program && i < PASSES; i++) {
        const struct aob_gpu_pass_desc desc = {
            .program = bench->program, .targets = &target, .target_count = 1, .height = SIDE / 4 << i};
        bench->passes[i] = aob_gpu_pass_create(bench->gpu, &desc, error);
        if (!bench->passes[i])
            return false;
    }
    return bench->program;
}

static bool run(struct bench *bench, size_t work, struct reading *reading, struct aob_error *error)
{
    struct aob_gpu_pass *list[2];
    for (size_t i = 0; i < works[work].count; i++)
        list[i] = bench->passes[works[work].passes[i]];
    const struct aob_gpu_run_desc desc = {list, works[work].count, works[work].repeats};
    return aob_gpu_run(bench->gpu, &desc, reading->passes, &reading->whole, error) &&
           aob_standing_check(&reading->whole, AOB_CLOCK_WALL, error);
}

/* As much arithmetic as makes the smallest pass long enough, from so many trips on. The second run counts: drivers compile at
 * the first. */
static bool choose_trips(struct bench *bench, int *trips, double *pass_ms, struct aob_error *error)
{
    for (;; *trips *= 4) {
        struct reading reading;
        if (!make_passes(bench, *trips, error) || !run(bench, ONE_SMALL, &reading, error) ||
            !run(bench, ONE_SMALL, &reading, error))
            return false;
        *pass_ms = (double)reading.whole.wall_ns * 1e-6;
        if (reading.whole.wall_ns >= enough_ns || *trips >= MOST_TRIPS)
            return true;
    }
}

static bool load(struct bench *bench, struct aob_error *error)
{
    struct reading reading;
    for (int64_t loaded_ns = 0; loaded_ns < load_ns; loaded_ns += reading.whole.wall_ns)
        if (!run(bench, ONE_SMALL, &reading, error))
            return false;
    return true;
}

/* On a device whose frequency rises while it is tested, what comes first takes longer than its share, and what was long
 * enough when it was idle is too short then. */
static bool warm_up(struct bench *bench, double *pass_ms, struct aob_error *error)
{
    int trips = FIRST_TRIPS;
    return choose_trips(bench, &trips, pass_ms, error) && load(bench, error) &&
           choose_trips(bench, &trips, pass_ms, error);
}

static double ratio(double a, double b)
{
    return b > 0 ? a / b : NAN;
}

/* What the device sees of a single pass, as a share of what the host sees of its submits. */
static double share(const struct reading *r)
{
    return ratio((double)r->passes[0].device_ns, (double)r->whole.wall_ns);
}

/* Of two works in turn. What load makes of their true ratio is in both clocks. */
static double growth(const struct reading *less, const struct reading *more, double work)
{
    return work * ratio(share(more), share(less));
}

static void take_round(const struct reading r[WORKS], double values[AOB_TIMER_CHECKS])
{
    const struct aob_gpu_time *list = r[LIST].passes;
    double sum = (double)(list[0].device_ns + list[1].device_ns);
    const double taken[AOB_TIMER_CHECKS] = {
        growth(&r[ONE_SMALL], &r[ONE_TWICE], 2),
        growth(&r[ONE_SMALL], &r[ONE_WHOLE], 4),
        growth(&r[SMALL_2], &r[SMALL_4], 2),
        ratio((double)list[1].device_ns, (double)list[0].device_ns),
        ratio(sum, (double)r[LIST].whole.device_ns),
        share(&r[ONE_WHOLE]),
        share(&r[SMALL_4]),
    };
    memcpy(values, taken, sizeof taken);
}

static const struct aob_timer_check expected[AOB_TIMER_CHECKS] = {
    {"twice the area", NAN, 2, 2 / 1.25, 2 * 1.25},
    {"four times the area", NAN, 4, 4 / 1.25, 4 * 1.25},
    {"twice as many repeats", NAN, 2, 2 / 1.25, 2 * 1.25},
    {"four times the area, within one list", NAN, 4, 4 / 2.5, 4 * 2.5},
    {"the passes of a list, as a share of the list", NAN, 1, 0.9, 1.02},
    {"a pass, as a share of the host's time", NAN, 1, 0.8, 1.02},
    {"repeats of a pass, as a share of the host's time", NAN, 1, 0.8, 1.02},
};

/* NAN where a round has no value. */
static double median_of(double rounds[AOB_TIMER_ROUNDS][AOB_TIMER_CHECKS], size_t check)
{
    double values[AOB_TIMER_ROUNDS];
    for (size_t r = 0; r < AOB_TIMER_ROUNDS; r++) {
        values[r] = rounds[r][check];
        if (!isfinite(values[r]))
            return NAN;
    }
    return aob_median(values, AOB_TIMER_ROUNDS);
}

static void judge(double rounds[AOB_TIMER_ROUNDS][AOB_TIMER_CHECKS], struct aob_timer *timer)
{
    timer->trusted = true;
    for (size_t i = 0; i < AOB_TIMER_CHECKS; i++) {
        struct aob_timer_check *c = &timer->checks[i];
        *c = expected[i];
        c->measured = median_of(rounds, i);
        bool good = c->measured >= c->low && c->measured <= c->high;
        if (!good && timer->trusted)
            snprintf(timer->why_not, sizeof timer->why_not,
                     "its clock says %.3g of %s, which is %g and may read %.3g to %.3g", c->measured, c->what,
                     c->expected, c->low, c->high);
        timer->trusted = timer->trusted && good;
    }
}

/* The works are interleaved, so that load and the device's own frequency fall on all of them. */
static bool measure(struct bench *bench, struct aob_timer *timer, struct aob_error *error)
{
    double rounds[AOB_TIMER_ROUNDS][AOB_TIMER_CHECKS];
    struct reading readings[WORKS];
    for (int round = -1; round < AOB_TIMER_ROUNDS; round++) { /* the first one warms up */
        for (size_t work = 0; work < WORKS; work++)
            if (!run(bench, work, &readings[work], error))
                return false;
        if (round >= 0)
            take_round(readings, rounds[round]);
    }
    judge(rounds, timer);
    return true;
}

bool aob_timer_test(struct aob_gpu *gpu, struct aob_timer *timer, struct aob_error *error)
{
    struct bench bench = {.gpu = gpu};
    *timer = (struct aob_timer){0};
    if (!gpu->lists)
        return aob_fail(error, "%s: the test of a clock needs a device that runs lists", gpu->info.backend);
    if (!gpu->info.timer) {
        snprintf(timer->why_not, sizeof timer->why_not, "it has no clock that programs can read");
        return true;
    }
    const struct aob_gpu_texture_desc target = {
        .format = AOB_R32F, .width = SIDE, .height = SIDE, .uses = AOB_GPU_USE_TARGET};
    bench.target = aob_gpu_texture_create(gpu, &target, error);
    bool ok = bench.target && warm_up(&bench, &timer->pass_ms, error) && measure(&bench, timer, error);
    drop_passes(&bench);
    aob_gpu_texture_destroy(gpu, bench.target);
    return ok || aob_fail_in(error, "test of the device's clock");
}

bool aob_timer_choose(struct aob_gpu *gpu, struct aob_timer_choice *choice, struct aob_error *error)
{
    struct aob_timer timer;
    *choice = (struct aob_timer_choice){.clock = AOB_CLOCK_CPU};
    if (gpu->info.software)
        return true;
    if (!aob_timer_test(gpu, &timer, error))
        return false;
    choice->clock = timer.trusted ? AOB_CLOCK_DEVICE : AOB_CLOCK_WALL;
    memcpy(choice->reason, timer.why_not, sizeof choice->reason);
    return true;
}
