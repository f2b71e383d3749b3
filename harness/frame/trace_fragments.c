#include <stdlib.h>
#include "base/clock.h"
#include "base/memory.h"
#include "trace_draw.h"

/* A pass of triangles: fragments come in any order, so it is drawn in ranges of triangles whose fragments fit into the
 * buffer, and each range is sorted. A drawn triangle covers a pixel once at most. */
struct triangles {
    struct aob_trace *trace;
    const struct aob_trace_pass *pass;
    const struct aob_trace_sink *sink; /* NULL: only count */
    int index;
    uint32_t slots, all; /* words of a fragment; triangles that are drawn */
    size_t entry, room;  /* words of a fragment with its head; fragments that fit */
    uint32_t seen;       /* fragments of the last range */
    uint64_t read;       /* of all ranges */
};

enum { ENTRY_HEAD = 2 }; /* words: pixel, triangle */

struct fragment {
    uint64_t key; /* triangle, row, column */
    uint32_t number;
};

static bool triangles_init(struct triangles *triangles, struct aob_trace *trace, int index,
                           struct aob_error *error)
{
    const struct aob_trace_capture *capture = trace->capture;
    const struct aob_graph_pass *pass = &trace->frame.graph.passes[index];
    uint32_t slots = capture->counts[index].slots;
    size_t entry = ENTRY_HEAD + slots;
    size_t held = 2 * entry + sizeof(struct fragment) / 4; /* as they come, sorted, and by what */
    size_t device = capture->words / entry, host = capture->host_words / held;
    *triangles =
        (struct triangles){.trace = trace,
                           .pass = &capture->planes.passes[index],
                           .index = index,
                           .slots = slots,
                           .all = pass->per_triangle / 3 * (uint32_t)trace->frame.screen->geometry->count,
                           .entry = entry,
                           .room = device < host ? device : host};
    trace->unfit = !triangles->room;
    return triangles->room ||
           aob_fail(error,
                    "pass '%s': a fragment takes %zu bytes of trace on the device and %zu "
                    "here, which does not fit into %zu and %zu: use a higher ceiling",
                    pass->name, 4 * entry, 4 * held, 4 * capture->words, 4 * capture->host_words);
}

static int by_key(const void *a, const void *b)
{
    uint64_t x = ((const struct fragment *)a)->key, y = ((const struct fragment *)b)->key;
    return (x > y) - (x < y);
}

static struct fragment *sort(const struct triangles *triangles, const uint32_t *entries, size_t count)
{
    struct fragment *order = AOB_NEW_ARRAY(struct fragment, count);
    for (size_t i = 0; i < count; i++) {
        uint32_t pixel = entries[i * triangles->entry], triangle = entries[i * triangles->entry + 1];
        uint64_t place = (uint64_t)(pixel >> 16) << 16 | (pixel & 0xffff);
        order[i] = (struct fragment){(uint64_t)triangle << 32 | place, (uint32_t)i};
    }
    qsort(order, count, sizeof *order, by_key);
    return order;
}

/* Sorted, their heads apart from their words. */
static bool hand_on(const struct triangles *triangles, const uint32_t *entries, size_t count,
                    struct aob_error *error)
{
    struct fragment *order = sort(triangles, entries, count);
    uint32_t *pixels = AOB_NEW_ARRAY(uint32_t, count * (1 + triangles->slots)), *words = pixels + count;
    for (size_t i = 0; i < count; i++) {
        const uint32_t *entry = entries + order[i].number * triangles->entry;
        pixels[i] = entry[0];
        for (uint32_t s = 0; s < triangles->slots; s++)
            words[i * triangles->slots + s] = entry[ENTRY_HEAD + s];
    }
    const struct aob_trace_band band = {.rows = triangles->pass->height,
                                        .count = count,
                                        .pixels = pixels,
                                        .slots = (int)triangles->slots,
                                        .words = words};
    bool ok = aob_trace_check(triangles->pass, words, count * triangles->slots, error) &&
              (!triangles->sink || triangles->sink->band(triangles->sink->self, &band, error));
    free(pixels);
    free(order);
    return ok;
}

static bool read_range(struct triangles *triangles, struct aob_error *error)
{
    size_t count = triangles->seen;
    triangles->read += count;
    uint32_t *entries = AOB_NEW_ARRAY(uint32_t, count * triangles->entry);
    bool ok = aob_trace_read(triangles->trace, 0, count * triangles->entry, entries, error) &&
              hand_on(triangles, entries, count, error);
    free(entries);
    return ok;
}

/* What does not fit is counted all the same. */
static bool draw_range(struct triangles *triangles, uint32_t first, uint32_t count, int row, int rows,
                       struct aob_error *error)
{
    struct aob_trace_draw draw = {.slots = triangles->slots,
                                  .room = (uint32_t)triangles->room,
                                  .part = {row, rows, 3 * first, 3 * count}};
    if (!aob_trace_draw(triangles->trace, triangles->index, &draw, error))
        return false;
    triangles->seen = draw.saw.fragments;
    return true;
}

static bool fits(const struct triangles *triangles)
{
    return triangles->seen <= triangles->room;
}

/* One triangle that alone has too many fragments: by rows, in which its pixels are in order as well. */
static bool capture_large(struct triangles *triangles, uint32_t number, struct aob_error *error)
{
    int rows = triangles->pass->height;
    for (int row = 0; row < triangles->pass->height; row += rows) {
        int left = triangles->pass->height - row;
        rows = rows < left ? rows : left;
        if (!draw_range(triangles, number, 1, row, rows, error))
            return false;
        for (; !fits(triangles) && rows > 1; rows = (rows + 1) / 2)
            if (!draw_range(triangles, number, 1, row, (rows + 1) / 2, error))
                return false;
        if (!fits(triangles)) {
            triangles->trace->unfit = true;
            return aob_fail(
                error,
                "pass '%s': the %u fragments of a row of one triangle take %zu bytes of trace each, "
                "and %zu of them fit: use a smaller image or a higher ceiling",
                triangles->pass->name, triangles->seen, 4 * triangles->entry, triangles->room);
        }
        if (!read_range(triangles, error))
            return false;
    }
    return true;
}

/* Triangles first .. first + *count - 1, fewer where they do not fit; *count says how many it were. */
static bool capture_range(struct triangles *triangles, uint32_t first, uint32_t *count,
                          struct aob_error *error)
{
    if (!draw_range(triangles, first, *count, 0, 0, error))
        return false;
    while (!fits(triangles) && *count > 1) {
        *count = (*count + 1) / 2;
        if (!draw_range(triangles, first, *count, 0, 0, error))
            return false;
    }
    return fits(triangles) ? read_range(triangles, error) : capture_large(triangles, first, error);
}

/* As many triangles as fit if all were alike, with something to spare. */
static uint32_t range_size(const struct triangles *triangles)
{
    double fragments = 1.0 + triangles->trace->capture->counts[triangles->index].fragments;
    double size = 0.8 * (double)triangles->room / fragments * triangles->all;
    return size < 1 ? 1 : size < triangles->all ? (uint32_t)size : triangles->all;
}

/* By what a range in the middle takes, for its share of the fragments. */
bool aob_trace_fragments_cost(struct aob_trace *trace, int index, struct aob_error *error)
{
    struct triangles triangles;
    const struct aob_trace_counts *counts = &trace->capture->counts[index];
    if (!triangles_init(&triangles, trace, index, error))
        return false;
    uint32_t count = range_size(&triangles);
    int64_t start = aob_clock_wall_ns();
    if (!capture_range(&triangles, (triangles.all - count) / 2, &count, error))
        return false;
    double seconds = (double)(aob_clock_wall_ns() - start) * 1e-9;
    trace->cost.seconds +=
        triangles.read ? seconds * counts->fragments / (double)triangles.read : counts->seconds;
    trace->cost.words += (double)counts->fragments * triangles.slots;
    trace->cost.strips += 1 + counts->fragments / triangles.room;
    return true;
}

bool aob_trace_fragments(struct aob_trace *trace, int index, const struct aob_trace_sink *sink,
                         struct aob_error *error)
{
    struct triangles triangles;
    if (!triangles_init(&triangles, trace, index, error))
        return false;
    triangles.sink = sink;
    uint32_t wanted = range_size(&triangles), count;
    for (uint32_t first = 0; first < triangles.all; first += count) {
        count = wanted < triangles.all - first ? wanted : triangles.all - first;
        if (!capture_range(&triangles, first, &count, error))
            return false;
    }
    return triangles.read == trace->capture->counts[index].fragments ||
           aob_fail(
               error,
               "pass '%s' drew %llu fragments where it had drawn %u: the device gives other results from "
               "run to run",
               triangles.pass->name, (unsigned long long)triangles.read,
               trace->capture->counts[index].fragments);
}
