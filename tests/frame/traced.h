/* A technique on a device twice, plain and traced, for tests of the trace. */
#ifndef AOB_TESTS_FRAME_TRACED_H
#define AOB_TESTS_FRAME_TRACED_H
#include "check.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "frame/trace.h"
#include "rig.h"

struct traced {
    struct aob_gpu *gpu;
    struct aob_geometry geometry;
    struct aob_screen screen;
    struct aob_frame
        plain; /* has run, after its frame 0 where it keeps a history; all its textures can be read back */
    struct aob_trace trace;
};
struct traced_desc {
    const struct aob_technique *technique;
    const void *values;
    const struct aob_options *options;
    size_t device_bytes, host_bytes;
};

/* A technique with a history is traced where it has one. */
static inline bool traced_draw_plain(struct aob_frame *plain, const void *values, struct aob_error *error)
{
    return aob_frame_run(plain, 1, NULL, error) &&
           (!aob_graph_keeps_history(&plain->graph) ||
            (aob_frame_set(plain, 1, values, error) && aob_frame_run(plain, 1, NULL, error)));
}

static inline void traced_init(struct traced *traced, const struct aob_rig *rig, struct aob_gpu *gpu,
                               const struct traced_desc *desc)
{
    struct aob_error error = {""};
    enum aob_fetch fetch = (enum aob_fetch)desc->options->fetch;
    *traced = (struct traced){.gpu = gpu, .geometry = rig->geometry};
    bool ok = aob_geometry_upload(&traced->geometry, gpu, &error) &&
              aob_screen_init(&traced->screen, gpu, &rig->gbuffer, desc->options, &error);
    traced->screen.geometry = &traced->geometry;
    const struct aob_frame_desc plain = {
        .technique = desc->technique, .values = desc->values, .fetch = fetch, .readable = true};
    const struct aob_trace_desc trace = {.screen = &traced->screen,
                                         .technique = desc->technique,
                                         .values = desc->values,
                                         .fetch = fetch,
                                         .device_bytes = desc->device_bytes,
                                         .host_bytes = desc->host_bytes};
    if (!ok || !aob_frame_init_desc(&traced->plain, &traced->screen, &plain, &error) ||
        !traced_draw_plain(&traced->plain, desc->values, &error) ||
        !aob_trace_init(&traced->trace, &trace, &error))
        fail_msg("%s", error.text);
}

static inline void traced_finish(struct traced *traced)
{
    aob_trace_finish(&traced->trace);
    aob_frame_finish(&traced->plain);
    aob_screen_finish(&traced->screen);
    aob_gpu_texture_destroy(traced->gpu, traced->geometry.texture);
}

/* A whole capture in memory. */
struct taken_pass {
    struct aob_trace_pass pass;
    size_t count; /* invocations */
    size_t slots;
    uint32_t *pixels, *words;
    int bands, rows; /* rows: without fragments, that have come */
};
struct taken {
    struct aob_trace_frame frame;
    struct taken_pass passes[AOB_MAX_PASS];
    size_t pass_count, ended;
};

static inline bool taken_begin(void *self, const struct aob_trace_frame *frame,
                               const struct aob_trace_pass *pass, struct aob_error *error)
{
    (void)error;
    struct taken *taken = self;
    assert_int_equal(taken->ended, taken->pass_count);
    taken->frame = *frame;
    taken->passes[taken->pass_count++].pass = *pass;
    return true;
}

static inline bool taken_band(void *self, const struct aob_trace_band *band, struct aob_error *error)
{
    (void)error;
    struct taken *taken = self;
    struct taken_pass *pass = &taken->passes[taken->pass_count - 1];
    size_t slots = (size_t)band->slots;
    if (pass->pass.fragments) {
        assert_non_null(band->pixels);
        pass->pixels = aob_realloc(pass->pixels, pass->count + band->count + 1, 4);
        memcpy(pass->pixels + pass->count, band->pixels, 4 * band->count);
    } else {
        assert_null(band->pixels);
        assert_int_equal(band->row, pass->rows);
        assert_int_equal(band->row % AOB_TRACE_BAND_ROWS, 0);
        assert_true(band->rows == AOB_TRACE_BAND_ROWS || band->row + band->rows == pass->pass.height);
        assert_int_equal(band->count, band->rows * pass->pass.width);
        pass->rows += band->rows;
    }
    assert_true(!pass->bands++ || pass->slots == slots);
    pass->slots = slots;
    pass->words = aob_realloc(pass->words, (pass->count + band->count) * slots + 1, 4);
    memcpy(pass->words + pass->count * slots, band->words, 4 * band->count * slots);
    pass->count += band->count;
    return true;
}

static inline bool taken_end(void *self, struct aob_error *error)
{
    (void)error;
    struct taken *taken = self;
    const struct taken_pass *pass = &taken->passes[taken->ended++];
    assert_int_equal(taken->ended, taken->pass_count);
    assert_true(pass->pass.fragments || pass->rows == pass->pass.height);
    return true;
}

static inline void take(struct traced *traced, struct taken *taken)
{
    struct aob_error error = {""};
    *taken = (struct taken){0};
    const struct aob_trace_sink sink = {taken, taken_begin, taken_band, taken_end};
    if (!aob_trace_run(&traced->trace, &sink, &error))
        fail_msg("%s", error.text);
}

static inline void taken_finish(struct taken *taken)
{
    for (size_t i = 0; i < taken->pass_count; i++) {
        free(taken->passes[i].pixels);
        free(taken->passes[i].words);
    }
}

/* Both captures have the same words in the same places. */
static inline void assert_same_words(const struct taken *a, const struct taken *b)
{
    assert_int_equal(a->pass_count, b->pass_count);
    for (size_t i = 0; i < a->pass_count; i++) {
        const struct taken_pass *p = &a->passes[i], *q = &b->passes[i];
        assert_int_equal(p->count, q->count);
        assert_int_equal(p->slots, q->slots);
        assert_int_equal(memcmp(p->words, q->words, 4 * p->count * p->slots), 0);
        assert_true(!p->pixels || memcmp(p->pixels, q->pixels, 4 * p->count) == 0);
    }
}
#endif
