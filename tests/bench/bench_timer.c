/* How well devices' clocks agree with the host's: "name value unit" lines. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "base/clock.h"
#include "base/machine.h"
#include "base/memory.h"
#include "timing/timer.h"

static struct aob_gpu *open_as_gpu(const char *backend)
{
    struct aob_error error = {{0}};
    struct aob_gpu *gpu = aob_gpu_open(backend, &(struct aob_gpu_desc){.as_gpu = true}, &error);
    if (!gpu)
        fprintf(stderr, "bench_timer: %s\n", error.text);
    return gpu;
}

/* Quiet: all threads of a software driver run at once, so that wall time is processor time / threads within 10 %. */
static bool test_clock(const char *backend, struct aob_timer *timer, bool *quiet)
{
    struct aob_error error = {{0}};
    struct aob_gpu *gpu = open_as_gpu(backend);
    if (!gpu)
        return false;
    int64_t cpu = aob_clock_cpu_ns(), wall = aob_clock_wall_ns();
    bool ok = aob_timer_test(gpu, timer, &error);
    double share = (double)(aob_clock_wall_ns() - wall) / (double)(aob_clock_cpu_ns() - cpu);
    *quiet = !gpu->info.software || fabs(share * aob_machine_cores() - 1) <= 0.1;
    if (!ok)
        fprintf(stderr, "bench_timer: %s\n", error.text);
    aob_gpu_close(gpu);
    return ok;
}

int main(void)
{
    static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_timer timer;
        bool quiet;
        if (!test_clock(backends[b], &timer, &quiet))
            return EXIT_FAILURE;
        printf("%s_quiet %d bool\n", backends[b], quiet);
        printf("%s_trusted %d bool\n", backends[b], timer.trusted);
        printf("%s_missing_of_list %.3f %%\n", backends[b], 100 * (1 - timer.checks[4].measured));
        printf("%s_missing_of_pass %.3f %%\n", backends[b], 100 * (1 - timer.checks[5].measured));
        printf("%s_pass %.1f ms\n", backends[b], 4 * timer.pass_ms);
    }
    return EXIT_SUCCESS;
}
