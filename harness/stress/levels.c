#include <math.h>
#include <stdlib.h>
#include "frame/trace.h"
#include "base/memory.h"
#include "resolution.h"
#include "sets.h"
#include "technique/graph.h"

static bool pass_reads_levels(const struct aob_graph_pass *pass)
{
    bool reads = pass->live && pass->depth_levels > 1;
    for (int i = 0; i < pass->in_count; i++)
        reads = reads || (pass->live && pass->in[i].level_count > 1);
    return reads;
}

const char *aob_excuse_one_level(const struct aob_subject *subject)
{
    struct aob_pass_graph *graph = aob_subject_lay(subject, 0);
    bool reads = false;
    for (int i = 0; graph && i < graph->pass_count; i++)
        reads = reads || pass_reads_levels(&graph->passes[i]);
    free(graph);
    return reads ? NULL : "it reads one level of each texture";
}

/* Reads of the textures of which a pass may read several levels: of the finest, and of all. */
struct tally {
    const struct aob_trace_pass *pass;
    double finest, all;
};

static bool begin(void *self, const struct aob_trace_frame *frame, const struct aob_trace_pass *pass,
                  struct aob_error *error)
{
    (void)frame;
    (void)error;
    ((struct tally *)self)->pass = pass;
    return true;
}

/* The plane of a texel that has finer or coarser ones beside it; NULL: it has none. `finest`: it has no finer one. */
static const struct aob_trace_plane *find_plane(const struct aob_trace_pass *pass, uint32_t texel,
                                                bool *finest)
{
    const struct aob_trace_plane *own = NULL;
    int levels = 0;
    *finest = true;
    for (int i = 0; i < pass->plane_count && pass->planes[i].first <= texel; i++)
        own = &pass->planes[i];
    for (int i = 0; own && i < pass->plane_count; i++) {
        bool same = pass->planes[i].texture == own->texture;
        levels += same;
        *finest = *finest && !(same && pass->planes[i].level < own->level);
    }
    return levels > 1 ? own : NULL;
}

static bool band(void *self, const struct aob_trace_band *band, struct aob_error *error)
{
    struct tally *tally = self;
    (void)error;
    for (size_t i = 0; i < band->count * (size_t)band->slots; i++) {
        bool finest;
        if (band->words[i] == AOB_TRACE_NONE ||
            !find_plane(tally->pass, aob_trace_texel(band->words[i]), &finest))
            continue;
        tally->all++;
        tally->finest += finest;
    }
    return true;
}

static bool end(void *self, struct aob_error *error)
{
    (void)self;
    (void)error;
    return true;
}

static bool run_trace(struct aob_subject *subject, const struct aob_shot *shot, struct aob_screen *screen,
                      const struct aob_options *options, const void *values, struct tally *tally, bool *unfit,
                      struct aob_error *error)
{
    struct aob_trace *trace = AOB_NEW(struct aob_trace);
    struct aob_geometry geometry = shot->exhibit->geometry;
    bool triangles = aob_subject_draws_triangles(subject);
    bool ok = !triangles || aob_geometry_upload(&geometry, subject->gpu, error);
    screen->geometry = triangles ? &geometry : NULL;
    const struct aob_trace_desc desc = {.screen = screen,
                                        .technique = subject->technique,
                                        .values = values,
                                        .fetch = (enum aob_fetch)options->fetch,
                                        .wanted = aob_options_wanted(options)};
    const struct aob_trace_sink sink = {.self = tally, .begin = begin, .band = band, .end = end};
    bool made = ok && aob_trace_init(trace, &desc, error);
    *unfit = trace->unfit;
    ok = made && aob_trace_run(trace, &sink, error);
    if (made)
        aob_trace_finish(trace);
    aob_gpu_texture_destroy(subject->gpu, geometry.texture);
    free(trace);
    return ok;
}

/* The share of the finest level in what a frame reads of textures of several; NAN after an error or an excuse. */
static double share_of_finest(struct aob_trial *trial, const struct aob_shot *shot)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    struct aob_screen screen;
    struct tally tally = {0};
    struct aob_error error = {{0}};
    bool unfit = false;
    if (!shot->exhibit || *trial->error.text || *trial->excuse.text)
        return NAN;
    bool ok = aob_subject_values(trial->subject, shot, values, &options, &error);
    bool made =
        ok && aob_screen_init(&screen, trial->subject->gpu, &shot->exhibit->gbuffer, &options, &error);
    unfit = ok && !made && screen.unfit;
    ok = made && run_trace(trial->subject, shot, &screen, &options, values, &tally, &unfit, &error);
    if (made)
        aob_screen_finish(&screen);
    if (!ok)
        *(unfit ? &trial->excuse : &trial->error) = error;
    return ok ? tally.finest / tally.all : NAN;
}

/* A disc of 96 pixels has nearly all of its area, and all but the first few steps of a row, farther out than any offset from
 * which the finest level is wanted. */
void aob_ask_levels_in_pixels(struct aob_trial *trial)
{
    struct aob_plane_desc plane = {.width = 96, .height = 64, .fov_deg = aob_resolution_camera(64).fov_deg};
    struct aob_shot shot = {.exhibit = aob_set_plane(trial, &plane)};
    const double pixel = 2 * 3 * tan(30 * M_PI / 180) / 64;
    double shares[2];
    for (int k = 0; k < 2; k++) {
        shot.radius = (k ? 96 : 3) * pixel;
        shares[k] = share_of_finest(trial, &shot);
    }
    aob_trial_take(trial, shares[1] / shares[0], &(struct aob_seen){&shot, NULL, NULL},
                   "of reads %.3f are of the finest level at a radius of 3 pixels, %.3f at 96", shares[0],
                   shares[1]);
}
