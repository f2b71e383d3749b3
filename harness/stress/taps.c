#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "frame/trace.h"
#include "numbers.h"
#include "sets.h"

/* Texels of the depth that the invocations of a pass read, by how far they lie from their own: SIDE x SIDE of them, the own
 * one in the middle, in rings about it. Only invocations count whose reads cannot meet the image's edge. */
enum { SIZE = 96, REACH = 36, SIDE = 2 * REACH + 1, RINGS = 52 };

struct taps {
    struct aob_trial *trial;
    const struct aob_shot *shot;
    const struct aob_pass_graph *graph;
    struct aob_trace_pass pass;
    double texels[RINGS];                      /* that a ring holds */
    double counts[AOB_TRACE_MAX_PLANE][RINGS]; /* taps, of all invocations */
    double invocations, distinct, all;
};

/* Whether a plane holds the depth that the pass reads; false of tables and of images between passes. */
static bool is_depth(const struct taps *taps, const struct aob_trace_frame *frame, int texture)
{
    int own = taps->graph->passes[taps->pass.index].depth;
    return frame->textures[texture].role == AOB_TRACE_ROLE_DEPTH ||
           (own >= 0 && strcmp(frame->textures[texture].name, taps->graph->textures[own].name) == 0);
}

static bool begin(void *self, const struct aob_trace_frame *frame, const struct aob_trace_pass *pass,
                  struct aob_error *error)
{
    struct taps *taps = self;
    (void)error;
    taps->pass = *pass;
    taps->pass.plane_count = 0;
    for (int i = 0; i < pass->plane_count; i++)
        if (is_depth(taps, frame, pass->planes[i].texture))
            taps->pass.planes[taps->pass.plane_count++] = pass->planes[i];
    memset(taps->counts, 0, sizeof taps->counts);
    taps->invocations = taps->distinct = taps->all = 0;
    return true;
}

/* Of a place of SIDE x SIDE. */
static int ring_of(int place)
{
    return (int)lround(hypot(place % SIDE - REACH, place / SIDE - REACH));
}

/* Place of a word of the invocation at (x, y), of SIDE x SIDE for each plane; -1: none of them, or its own. */
static int place_of(const struct taps *taps, uint32_t word, int x, int y)
{
    for (int i = 0; word != AOB_TRACE_NONE && i < taps->pass.plane_count; i++) {
        const struct aob_trace_plane *plane = &taps->pass.planes[i];
        uint32_t texel = aob_trace_texel(word) - plane->first;
        if (texel >= (uint32_t)(plane->width * plane->height))
            continue;
        int dx = (int)texel % plane->width - x * plane->width / taps->pass.width,
            dy = (int)texel / plane->width - y * plane->height / taps->pass.height;
        bool counts = (dx || dy) && abs(dx) <= REACH && abs(dy) <= REACH;
        return counts ? (i * SIDE + dy + REACH) * SIDE + dx + REACH : -1;
    }
    return -1;
}

static void count_invocation(struct taps *taps, const uint32_t *words, int slots, int x, int y)
{
    static const int none = -1;
    int *seen = AOB_NEW_ARRAY(int, (size_t)slots + 1);
    int count = 0;
    for (int s = 0; s < slots; s++) {
        int place = place_of(taps, words[s], x, y);
        if (place == none)
            continue;
        bool again = false;
        for (int k = 0; k < count && !again; k++)
            again = seen[k] == place;
        taps->counts[place / (SIDE * SIDE)][ring_of(place % (SIDE * SIDE))]++;
        taps->all++;
        if (!again)
            seen[count++] = place;
    }
    taps->invocations++;
    taps->distinct += count;
    free(seen);
}

static bool band(void *self, const struct aob_trace_band *band, struct aob_error *error)
{
    struct taps *taps = self;
    int width = taps->pass.width, height = taps->pass.height, edge = width * REACH / SIZE;
    (void)error;
    for (size_t i = 0; !taps->pass.fragments && i < band->count; i++) {
        int x = (int)(i % (size_t)width), y = band->row + (int)(i / (size_t)width);
        if (x >= edge && y >= edge && x < width - edge && y < height - edge)
            count_invocation(taps, band->words + i * (size_t)band->slots, band->slots, x, y);
    }
    return true;
}

/* As many taps at the same distances, each in a direction by lot, would be of so many texels on average. So what steps along
 * rays may read the few texels next to its own as often as it likes, and what reads few texels many times is found out. */
static double distinct_by_chance(const struct taps *taps)
{
    double sum = 0;
    for (int plane = 0; plane < taps->pass.plane_count; plane++)
        for (int r = 1; r < RINGS; r++)
            sum += taps->texels[r] *
                   (1 - pow(1 - 1 / taps->texels[r], taps->counts[plane][r] / taps->invocations));
    return sum;
}

static bool end(void *self, struct aob_error *error)
{
    struct taps *taps = self;
    (void)error;
    if (taps->all == 0)
        return true;
    double chance = distinct_by_chance(taps), distinct = taps->distinct / taps->invocations,
           taken = taps->all / taps->invocations;
    aob_trial_take(taps->trial, aob_over(1 - distinct / chance), &(struct aob_seen){taps->shot, NULL, NULL},
                   "pass %s: %.1f taps of %.1f texels, %.1f by chance", taps->pass.name, taken, distinct,
                   chance);
    return true;
}

static bool trace(struct taps *taps, const struct aob_shot *shot, bool *unfit, struct aob_error *error)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    struct aob_screen screen;
    const struct aob_subject *subject = taps->trial->subject;
    if (!aob_subject_values(subject, shot, values, &options, error))
        return false;
    if (!aob_screen_init(&screen, subject->gpu, &shot->exhibit->gbuffer, &options, error)) {
        *unfit = screen.unfit;
        return false;
    }
    struct aob_trace *trace = AOB_NEW(struct aob_trace);
    const struct aob_trace_sink sink = {taps, begin, band, end};
    bool ok = aob_trace_init(trace,
                             &(struct aob_trace_desc){.screen = &screen,
                                                      .technique = subject->technique,
                                                      .values = values,
                                                      .fetch = (enum aob_fetch)options.fetch,
                                                      .wanted = aob_options_wanted(&options)},
                             error);
    *unfit = trace->unfit;
    taps->graph = &trace->frame.graph;
    ok = ok && aob_trace_run(trace, &sink, error);
    aob_trace_finish(trace);
    aob_screen_finish(&screen);
    free(trace);
    return ok;
}

/* Pixels of 1/32 unit at distance 3, so that a radius of 1 takes in 32 of them. */
void aob_ask_distinct_taps(struct aob_trial *trial)
{
    if (aob_subject_draws_triangles(trial->subject)) {
        aob_trial_excuse(trial, "it reads the scene's triangles, not pixels about its own");
        return;
    }
    const struct aob_shot shot = {
        .exhibit =
            aob_set_plane(trial, &(struct aob_plane_desc){.fov_deg = 53.13, .width = SIZE, .height = SIZE}),
        .radius = 1};
    struct aob_error error = {{0}};
    bool unfit = false;
    struct taps *taps = AOB_NEW(struct taps);
    taps->trial = trial;
    taps->shot = &shot;
    for (int place = 0; place < SIDE * SIDE; place++)
        taps->texels[ring_of(place)]++;
    if (shot.exhibit && !trace(taps, &shot, &unfit, &error))
        *(unfit ? &trial->excuse : &trial->error) = error;
    else if (trial->asked == 0)
        aob_trial_excuse(trial, "no pass of it reads another pixel than its own");
    free(taps);
}
