#include <stdlib.h>
#include "base/clock.h"
#include "base/memory.h"
#include "trace_draw.h"

/* A pass that draws every pixel once: rows in strips, as many as the buffer holds, gathered into bands. */
struct rows {
    struct aob_trace *trace;
    const struct aob_trace_pass *pass;
    int index;
    uint32_t slots;
    size_t row_words;
    int strip;      /* rows that the buffer holds */
    int first, end; /* that are in it */
};

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

static bool refuse(struct aob_trace *trace, const struct aob_trace_pass *pass, const char *what, size_t rows,
                   size_t words, size_t room, struct aob_error *error)
{
    trace->unfit = true;
    return aob_fail(
        error,
        "pass '%s': %zu %s of %d pixels take %zu bytes of trace, which does not fit into %s of %zu: "
        "use fewer samples, a smaller image or a higher ceiling",
        pass->name, rows, rows == 1 ? "row" : "rows", pass->width, 4 * words, what, 4 * room);
}

static bool rows_init(struct rows *rows, struct aob_trace *trace, int index, struct aob_error *error)
{
    const struct aob_trace_capture *capture = trace->capture;
    const struct aob_trace_pass *pass = &capture->planes.passes[index];
    uint32_t slots = capture->counts[index].slots;
    size_t row_words = (size_t)pass->width * slots, band = least((size_t)pass->height, AOB_TRACE_BAND_ROWS);
    *rows = (struct rows){trace, pass, index, slots, row_words, pass->height, 0, 0};
    if (row_words > capture->words)
        return refuse(trace, pass, "the device's buffer", 1, row_words, capture->words, error);
    if (band * row_words > capture->host_words)
        return refuse(trace, pass, "the memory", band, band * row_words, capture->host_words, error);
    if (row_words)
        rows->strip = (int)least(capture->words / row_words, (size_t)pass->height);
    return true;
}

static bool draw_strip(struct rows *rows, int first, struct aob_error *error)
{
    struct aob_trace_draw draw = {.slots = rows->slots};
    rows->first = first;
    rows->end = (int)least((size_t)first + (size_t)rows->strip, (size_t)rows->pass->height);
    draw.part = (struct aob_gpu_part){.row = first, .rows = rows->end - first};
    return aob_trace_draw(rows->trace, rows->index, &draw, error);
}

/* Rows first .. end - 1, drawn as they are needed. */
static bool read_rows(struct rows *rows, int first, int end, uint32_t *words, struct aob_error *error)
{
    const uint32_t *start = words;
    for (int row = first; row < end;) {
        if ((row < rows->first || row >= rows->end) && !draw_strip(rows, row, error))
            return false;
        int last = rows->end < end ? rows->end : end;
        size_t count = (size_t)(last - row) * rows->row_words;
        if (!aob_trace_read(rows->trace, (size_t)(row - rows->first) * rows->row_words, count, words, error))
            return false;
        words += count;
        row = last;
    }
    return aob_trace_check(rows->pass, start, (size_t)(words - start), error);
}

static uint32_t *band_words(const struct rows *rows)
{
    return AOB_NEW_ARRAY(uint32_t, least((size_t)rows->pass->height, AOB_TRACE_BAND_ROWS) * rows->row_words);
}

/* Twice: the first time all memory is new to the process, and its pages cost as much again. */
static bool time_rows(struct rows *rows, int first, int end, double *seconds, struct aob_error *error)
{
    uint32_t *words = band_words(rows);
    bool ok = true;
    for (int i = 0; ok && i < 2; i++) {
        int64_t start = aob_clock_wall_ns();
        rows->first = rows->end = 0;
        ok = read_rows(rows, first, end, words, error);
        *seconds = (double)(aob_clock_wall_ns() - start) * 1e-9;
    }
    free(words);
    return ok;
}

bool aob_trace_screen_cost(struct aob_trace *trace, int index, struct aob_error *error)
{
    struct rows rows;
    if (!rows_init(&rows, trace, index, error))
        return false;
    if (!rows.slots)
        return true;
    int height = rows.pass->height, some = (int)least((size_t)rows.strip, AOB_TRACE_BAND_ROWS);
    int first = (height - some) / 2; /* a sky lies above, and costs less */
    double seconds;
    rows.strip = some;
    if (!time_rows(&rows, first, first + some, &seconds, error))
        return false;
    trace->cost.seconds += seconds * height / some;
    trace->cost.words += (double)rows.row_words * height;
    trace->cost.strips +=
        ((size_t)height * rows.row_words + trace->capture->words - 1) / trace->capture->words;
    return true;
}

bool aob_trace_screen(struct aob_trace *trace, int index, const struct aob_trace_sink *sink,
                      struct aob_error *error)
{
    struct rows rows;
    if (!rows_init(&rows, trace, index, error))
        return false;
    uint32_t *words = band_words(&rows);
    bool ok = true;
    for (int row = 0; ok && row < rows.pass->height; row += AOB_TRACE_BAND_ROWS) {
        int count = (int)least(AOB_TRACE_BAND_ROWS, (size_t)(rows.pass->height - row));
        const struct aob_trace_band band = {.row = row,
                                            .rows = count,
                                            .count = (size_t)count * (size_t)rows.pass->width,
                                            .slots = (int)rows.slots,
                                            .words = words};
        ok = (!rows.slots || read_rows(&rows, row, row + count, words, error)) &&
             sink->band(sink->self, &band, error);
    }
    free(words);
    return ok;
}
