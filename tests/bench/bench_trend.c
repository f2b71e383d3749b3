/* The trend page of a long history: lines ROW VALUE UNIT for ./dev bench. `bench_trend FOLDER LINES NIGHTS` makes as many
 * series of as many nights, with noise, shifts, missing nights and verdicts, and writes their page into FOLDER. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "base/clock.h"
#include "base/file.h"
#include "base/memory.h"
#include "random.h"
#include "reports/trend/trend.h"

#define MACHINES 2 /* classes of machine */
#define VIEWS    8

static char *made(const char *format, ...) __attribute__((format(printf, 1, 2)));
static char *made(const char *format, ...)
{
    char line[256];
    va_list args;
    va_start(args, format);
    vsnprintf(line, sizeof line, format, args);
    va_end(args);
    return aob_strdup(line);
}

static void make_nights(struct aob_nights *nights, size_t count)
{
    nights->items = AOB_NEW_ARRAY(struct aob_night, count);
    nights->count = count;
    for (size_t i = 0; i < count; i++) {
        time_t began = 1788400800 + (time_t)i * 86400;
        char date[32];
        strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", gmtime(&began));
        nights->items[i] = (struct aob_night){
            .id = (int64_t)i + 1, .date = aob_strdup(date), .name = "nightly", .whole = true};
    }
}

/* A third of the series shift once; a few of those are told of. */
static void make_point(struct aob_point *point, int64_t night, size_t line, size_t shift, uint32_t *state)
{
    double base = 1 + (double)(line % 37) / 20, late = night >= (int64_t)shift ? 1.06 : 1;
    double ratio = base * late * exp(.004 * random_normal(state));
    *point = (struct aob_point){.night = night,
                                .status = "ok",
                                .reason = "",
                                .module = "",
                                .said = "",
                                .ratio = ratio,
                                .low = ratio * .993,
                                .high = ratio * 1.007,
                                .cost_ms = ratio * 3,
                                .ref_ms = 3,
                                .memory_bytes = 1048576. * (double)(1 + line % 5),
                                .rmse = .04,
                                .band_rmse = .06 + (line % 11 ? 0 : .001 * random_unit(state))};
    snprintf(point->image, sizeof point->image, "%032zx", line * 3 + (line % 11 == 0 && late > 1));
    if (night == (int64_t)shift && line % 2 == 0) {
        point->verdict = line % 11 ? AOB_NIGHT_SLOWER : AOB_NIGHT_MOVED;
        point->since = night;
        point->said = "6.0 % [5.1 %, 7.0 %] dearer than the module of the night before, in 40 rounds.";
    }
}

static void make_line(struct aob_line *line, size_t index, size_t nights, uint32_t *state)
{
    static const char *const techniques[] = {"gtao", "ssao", "hbao", "crytek", "volume", "alchemy"};
    const char *technique = techniques[index % AOB_COUNT(techniques)];
    size_t view = index / AOB_COUNT(techniques) % VIEWS;
    size_t shift = index % 3 ? nights + 9 : 2 + random_below(state, nights);
    *line = (struct aob_line){
        .id = (int64_t)index + 1,
        .class_name = made("cpu, 2 x AMD EPYC 7B13 %zu, llvmpipe, Mesa 22.3.6, 4 threads", index % MACHINES),
        .config = "nightly",
        .scene = "corner",
        .view = made("view%zu", view),
        .technique = aob_strdup(technique),
        .backend = "vulkan",
        .size = "480x270",
        .text = made("corner/view%zu %s radius=%g vulkan 480x270", view, technique, .1 * (double)index),
        .points = AOB_NEW_ARRAY(struct aob_point, nights)};
    for (size_t night = 1; night <= nights; night++)
        if (random_below(state, 40)) /* one night in forty is missing */
            make_point(&line->points[line->count++], (int64_t)night, index, shift, state);
}

static void free_all(struct aob_lines *lines, struct aob_nights *nights)
{
    for (size_t i = 0; i < lines->count; i++) {
        free(lines->items[i].class_name);
        free(lines->items[i].view);
        free(lines->items[i].technique);
        free(lines->items[i].text);
        free(lines->items[i].points);
    }
    for (size_t i = 0; i < nights->count; i++)
        free(nights->items[i].date);
    free(lines->items);
    free(nights->items);
}

int main(int argc, char **argv)
{
    size_t count = argc == 4 ? (size_t)atoi(argv[2]) : 0, of = argc == 4 ? (size_t)atoi(argv[3]) : 0,
           points = 0;
    struct aob_lines lines = {AOB_NEW_ARRAY(struct aob_line, count), count};
    struct aob_nights nights = {0};
    struct aob_error error = {{0}};
    uint32_t state = 1;
    make_nights(&nights, of);
    for (size_t i = 0; i < count; i++) {
        make_line(&lines.items[i], i, of, &state);
        points += lines.items[i].count;
    }
    int64_t start = aob_clock_wall_ns();
    bool ok =
        argc == 4 && aob_trend_write(&(struct aob_trend_desc){&lines, &nights, argv[1], "Nightly"}, &error);
    double seconds = (double)(aob_clock_wall_ns() - start) * 1e-9;
    char *path = ok ? aob_path_join(argv[1], "index.html") : NULL;
    if (ok)
        printf("points %zu nights\nseconds %.2f s\nsize %.2f MB\n", points, seconds,
               (double)aob_file_size(path) / 1e6);
    else
        aob_error_print(&error);
    free(path);
    free_all(&lines, &nights);
    return !ok;
}
