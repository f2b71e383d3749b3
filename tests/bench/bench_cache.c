/* bench_cache FOLDER: how fast caches are simulated, those of some profiles in FOLDER too: "name value unit" lines, in
 * accesses a second of this thread's processor time, the best of three. The traces are 720p x 12 texels of a disc about
 * each pixel, as a technique of random samples fetches them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "base/memory.h"
#include "profile/layout.h"
#include "profile/reuse.h"
#include "profile/simulate.h"
#include "profile/stack.h"
#include "profile/tags.h"

enum { WIDTH = 1280, HEIGHT = 720, SAMPLES = 12, COUNT = WIDTH * HEIGHT * SAMPLES, TRIES = 3, LINES = 60000 };

struct trace {
    uint32_t *words; /* of the capture: by pixel and sample */
    uint32_t *lines; /* in the order of the profile generic */
};

static double thread_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static uint64_t mix(uint64_t x)
{
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
}

static int clamp(double value, int size)
{
    return value < 0 ? 0 : value > size - 1 ? size - 1 : (int)lrint(value);
}

static void fetch_disc(uint32_t *words, double radius)
{
    for (size_t i = 0; i < COUNT; i++) {
        uint64_t hash = mix(i * 0x9e3779b97f4a7c15u + 1);
        double r = radius * sqrt((double)(hash >> 40) / 0x1p24),
               angle = (double)(hash & 0xffffff) * 6.28318530718 / 0x1p24;
        size_t pixel = i / SAMPLES;
        words[i] = (uint32_t)clamp((double)(pixel / WIDTH) + r * sin(angle), HEIGHT) * WIDTH +
                   (uint32_t)clamp((double)(pixel % WIDTH) + r * cos(angle), WIDTH);
    }
}

/* Warps of 8 x 4 in tiles of 8 x 8, sample by sample: written out, so that the engines are timed without the ordering. */
static void order_lines(const struct aob_profile *profile, struct trace *trace)
{
    struct aob_placed placed = aob_layout_level(profile, 4, WIDTH, HEIGHT, 0);
    size_t at = 0;
    for (int warp = 0; warp < WIDTH * HEIGHT / 32; warp++)
        for (int s = 0; s < SAMPLES; s++)
            for (int lane = 0; lane < 32; lane++) {
                int tile = warp / 2, x = tile % (WIDTH / 8) * 8 + lane / 4 % 4 * 2 + lane % 2;
                int y = tile / (WIDTH / 8) * 8 + warp % 2 * 4 + lane / 16 * 2 + lane / 2 % 2;
                uint32_t word = trace->words[(size_t)(y * WIDTH + x) * SAMPLES + (size_t)s];
                trace->lines[at++] = (uint32_t)(aob_layout_address(&placed, word % WIDTH, word / WIDTH) / 64);
            }
}

static void time_tags(const char *name, int radius, const struct trace *trace, struct aob_tags_desc desc)
{
    double best = HUGE_VAL;
    if (!aob_tags_can(&desc))
        return;
    uint32_t *missed = AOB_NEW_ARRAY(uint32_t, COUNT);
    for (int i = 0; i < TRIES; i++) {
        struct aob_tags *tags = aob_tags_create(&desc);
        double start = thread_seconds();
        aob_tags_access(tags, trace->lines, COUNT, missed);
        best = fmin(best, thread_seconds() - start);
        aob_tags_destroy(tags);
    }
    printf("%s_%dpx %.0f M/s\n", name, radius, COUNT / best * 1e-6);
    free(missed);
}

static void time_curves(int radius, const struct trace *trace)
{
    uint32_t sizes[17];
    double powers = HUGE_VAL, every = HUGE_VAL;
    for (int i = 0; i < 17; i++)
        sizes[i] = 1u << i;
    for (int i = 0; i < TRIES; i++) {
        struct aob_stack *stack = aob_stack_create(&(struct aob_stack_desc){LINES, 1, sizes, 17});
        struct aob_reuse *reuse = aob_reuse_create(LINES, 1);
        double start = thread_seconds();
        aob_stack_access(stack, trace->lines, COUNT);
        double between = thread_seconds();
        aob_reuse_access(reuse, trace->lines, COUNT);
        powers = fmin(powers, between - start);
        every = fmin(every, thread_seconds() - between);
        aob_stack_destroy(stack);
        aob_reuse_destroy(reuse);
    }
    printf("powers_%dpx %.0f M/s\nevery_%dpx %.0f M/s\n", radius, COUNT / powers * 1e-6, radius,
           COUNT / every * 1e-6);
}

/* Ordering and simulation of the frame, as a capture would give it. */
static bool time_frame(const char *path, int radius, const struct trace *trace, enum aob_curve_kind curve)
{
    struct aob_error error = {{0}};
    struct aob_profile profile;
    struct aob_trace_frame frame = {.textures = {{"depth", AOB_R32F, WIDTH, HEIGHT, 1, AOB_TRACE_ROLE_DEPTH}},
                                    .texture_count = 1};
    struct aob_trace_pass pass = {.name = "ao",
                                  .width = WIDTH,
                                  .height = HEIGHT,
                                  .planes = {{0, WIDTH, HEIGHT, 0, 0}},
                                  .plane_count = 1};
    double best = HUGE_VAL;
    bool ok = aob_profile_read(&profile, path, &error);
    for (int i = 0; ok && i < TRIES; i++) {
        struct aob_simulation *simulation =
            aob_simulation_create(&(struct aob_simulation_desc){.profile = &profile, .curve = curve});
        struct aob_trace_sink sink = aob_simulation_sink(simulation);
        double start = thread_seconds();
        ok = sink.begin(sink.self, &frame, &pass, &error);
        for (int row = 0; ok && row < HEIGHT; row += AOB_TRACE_BAND_ROWS) {
            int rows = HEIGHT - row < AOB_TRACE_BAND_ROWS ? HEIGHT - row : AOB_TRACE_BAND_ROWS;
            struct aob_trace_band band = {row,  rows,    (size_t)rows * WIDTH,
                                          NULL, SAMPLES, trace->words + (size_t)row * WIDTH * SAMPLES};
            ok = sink.band(sink.self, &band, &error);
        }
        ok = ok && sink.end(sink.self, &error);
        best = fmin(best, thread_seconds() - start);
        aob_simulation_destroy(simulation);
    }
    if (ok)
        printf("frame%s_%s_%dpx %.3f s\n", curve == AOB_CURVE_NONE ? "" : "_curve", profile.name, radius,
               best);
    else
        fprintf(stderr, "bench_cache: %s\n", error.text);
    aob_profile_finish(&profile);
    return ok;
}

static struct aob_tags_desc cache_of(uint32_t ways, enum aob_tags_path path)
{
    return (struct aob_tags_desc){
        .sets = 256 / ways, .ways = ways, .index = AOB_INDEX_XOR, .numbers = LINES, .path = path};
}

static bool time_profiles(const char *folder, int radius, const struct trace *trace)
{
    static const char *const names[] = {"generic", "ps4", "gtx580", "turing", "ps5", "llvmpipe"};
    bool ok = true;
    char path[1024];
    for (size_t p = 0; ok && p < AOB_COUNT(names); p++) {
        snprintf(path, sizeof path, "%s/%s.yaml", folder, names[p]);
        ok = time_frame(path, radius, trace, AOB_CURVE_NONE) &&
             (p > 1 || time_frame(path, radius, trace, AOB_CURVE_POWERS));
    }
    return ok;
}

int main(int argc, char **argv)
{
    static const int radii[] = {8, 48, 192};
    struct trace trace = {AOB_NEW_ARRAY(uint32_t, COUNT), AOB_NEW_ARRAY(uint32_t, COUNT)};
    struct aob_profile morton = {.layout = AOB_LAYOUT_MORTON};
    bool ok = argc == 2;
    for (size_t r = 0; ok && r < AOB_COUNT(radii); r++) {
        fetch_disc(trace.words, radii[r]);
        order_lines(&morton, &trace);
        time_tags("4way_best", radii[r], &trace, cache_of(4, AOB_TAGS_BEST));
        time_tags("4way_portable", radii[r], &trace, cache_of(4, AOB_TAGS_PORTABLE));
        time_tags("8way_best", radii[r], &trace, cache_of(8, AOB_TAGS_BEST));
        time_tags("16way_avx2", radii[r], &trace, cache_of(16, AOB_TAGS_AVX2));
        time_tags("16way_avx512", radii[r], &trace, cache_of(16, AOB_TAGS_AVX512));
        time_tags("64way_list", radii[r], &trace, cache_of(64, AOB_TAGS_LIST));
        time_curves(radii[r], &trace);
        ok = time_profiles(argv[1], radii[r], &trace);
    }
    free(trace.words);
    free(trace.lines);
    return ok ? 0 : 2;
}
