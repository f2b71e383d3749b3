/* A trace of a frame that does not fit into memory: 3840 x 2160 pixels of Alchemy with 64 samples, in strips. What it was
 * said to take, what it took, and the memory that it added to that of the frame itself; and what the count of its operations
 * takes. Prints `name value unit` lines. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include "base/clock.h"
#include "base/memory.h"
#include "frame/count.h"
#include "frame/trace.h"
#include "rig.h"
#include "technique/registry.h"

enum { WIDTH = 3840, HEIGHT = 2160 };

static double peak_mib(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return (double)usage.ru_maxrss / 1024;
}

static bool begin(void *self, const struct aob_trace_frame *frame, const struct aob_trace_pass *pass,
                  struct aob_error *error)
{
    (void)self;
    (void)frame;
    (void)pass;
    (void)error;
    return true;
}

static bool count_band(void *self, const struct aob_trace_band *band, struct aob_error *error)
{
    (void)error;
    *(double *)self += (double)band->count * band->slots;
    return true;
}

static bool end(void *self, struct aob_error *error)
{
    (void)self;
    (void)error;
    return true;
}

static bool measure(struct aob_trace *trace, struct aob_error *error)
{
    double words = 0, before = peak_mib();
    const struct aob_trace_sink sink = {&words, begin, count_band, end};
    printf("words %.0f million\nstrips %zu\nforetold %.2f s\n", trace->cost.words * 1e-6, trace->cost.strips,
           trace->cost.seconds);
    int64_t start = aob_clock_wall_ns();
    if (!aob_trace_run(trace, &sink, error))
        return false;
    double seconds = (double)(aob_clock_wall_ns() - start) * 1e-9;
    printf("captured %.2f s\nforetold_over_captured %.2f ratio\n", seconds, trace->cost.seconds / seconds);
    printf("words_missing %.0f words\nlater_peak %.0f MiB\n", trace->cost.words - words, peak_mib() - before);
    return true;
}

/* Of the operations of the same frame. */
static bool count(const struct aob_count_desc *desc, struct aob_error *error)
{
    struct aob_count *count = AOB_NEW(struct aob_count);
    int64_t start = aob_clock_wall_ns();
    bool ok = aob_count_init(count, desc, error) && aob_count_run(count, error);
    if (ok)
        printf("counted %.2f s\n", (double)(aob_clock_wall_ns() - start) * 1e-9);
    aob_count_finish(count);
    free(count);
    return ok;
}

static const struct aob_technique *find(const char *name)
{
    const struct aob_technique *const *t = aob_builtin_techniques;
    while (*t && strcmp((*t)->name, name) != 0)
        t++;
    return *t;
}

int main(void)
{
    struct aob_rig rig;
    struct aob_error error = {""};
    struct aob_screen screen;
    struct aob_options options;
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_trace *trace = AOB_NEW(struct aob_trace);
    const struct aob_technique *alchemy = find("alchemy");
    aob_rig_params(alchemy, "samples=64", values, &options);
    aob_rig_scene(&rig, "cornell", "blocks", WIDTH, HEIGHT, 0);
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    if (!aob_screen_init(&screen, gpu, &rig.gbuffer, &options, &error)) {
        aob_error_print(&error);
        return 1;
    }
    double before = peak_mib();
    const struct aob_trace_desc desc = {.screen = &screen, .technique = alchemy, .values = values};
    bool ok = aob_trace_init(trace, &desc, &error) && measure(trace, &error);
    const struct aob_count_desc counted = {.screen = &screen, .technique = alchemy, .values = values};
    if (ok)
        printf("added_peak %.0f MiB\n", peak_mib() - before);
    aob_trace_finish(trace);
    ok = ok && count(&counted, &error);
    if (!ok)
        aob_error_print(&error);
    aob_screen_finish(&screen);
    aob_gpu_close(gpu);
    aob_rig_finish(&rig);
    free(trace);
    return ok ? 0 : 1;
}
