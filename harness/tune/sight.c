#include "sight.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "score/score.h"
#include "store/image.h"
#include "worker/worker.h"

static bool take_band(struct aob_tune_sight *sight, const float *truth)
{
    const struct aob_job_view *view = &sight->drawing.job->view;
    const struct aob_gbuffer *gbuffer = &sight->drawing.gbuffer;
    size_t width = (size_t)view->width, height = (size_t)view->height, guard = (size_t)view->guard,
           stride = (size_t)gbuffer->projection.width;
    sight->image = AOB_NEW_ARRAY(float, width *height);
    sight->pixels = AOB_NEW_ARRAY(struct aob_sight_pixel, width * height);
    for (size_t i = 0; i < width * height; i++) {
        float depth = gbuffer->depth[(i / width + guard) * stride + i % width + guard];
        if (depth < 0.5f * AOB_GBUFFER_SKY && (double)truth[i] < AOB_BAND_LIMIT)
            sight->pixels[sight->count++] = (struct aob_sight_pixel){i, truth[i]};
    }
    return true;
}

static bool read_truth(struct aob_tune_sight *sight, const char *path, struct aob_error *error)
{
    const struct aob_job_view *view = &sight->drawing.job->view;
    struct aob_image image = {0};
    if (!aob_image_read(&image, path, error))
        return false;
    const float *truth = aob_image_channel(&image, "AO");
    bool ok = truth && image.width == view->width && image.height == view->height
                  ? take_band(sight, truth)
                  : aob_fail(error, "%s: not a reference of %dx%d", path, view->width, view->height);
    aob_image_finish(&image);
    return ok;
}

bool aob_tune_sight_open(struct aob_tune_sight *sight, const struct aob_tune_view *view,
                         struct aob_error *error)
{
    *sight = (struct aob_tune_sight){.built = false};
    return aob_drawing_load(&sight->drawing, &view->drawing, error) &&
           aob_drawing_open(&sight->drawing, error) &&
           aob_drawing_set(&sight->drawing, &view->frame, &sight->part, error) &&
           read_truth(sight, view->truth, error);
}

static void drop_frame(struct aob_tune_sight *sight)
{
    if (sight->built)
        aob_frame_finish(&sight->frame);
    sight->built = false;
}

void aob_tune_sight_close(struct aob_tune_sight *sight)
{
    drop_frame(sight);
    aob_drawing_finish(&sight->drawing);
    free(sight->pixels);
    free(sight->image);
    *sight = (struct aob_tune_sight){.built = false};
}

/* A table keeps what it was filled with (frame/frame.h), so one that other values would fill otherwise needs another frame. */
static bool fills_the_same(const struct aob_frame *frame, const void *values)
{
    bool same = true;
    for (int i = 0; i < frame->graph.texture_count && same; i++) {
        const struct aob_graph_texture *table = &frame->graph.textures[i];
        if (!table->fill || !table->used)
            continue;
        size_t size = aob_gpu_texel_size(table->format) * (size_t)table->width * (size_t)table->height;
        char *before = AOB_NEW_ARRAY(char, size), *now = AOB_NEW_ARRAY(char, size);
        table->fill(frame->values, before);
        table->fill(values, now);
        same = memcmp(before, now, size) == 0;
        free(before);
        free(now);
    }
    return same;
}

/* What a set of values refuses for another frame's sake is no reason to stop. */
static bool set_values(struct aob_tune_sight *sight, const void *values, struct aob_error *error)
{
    if (sight->built && fills_the_same(&sight->frame, values) &&
        aob_frame_set(&sight->frame, 0, values, NULL))
        return true;
    const struct aob_frame_desc desc = {.technique = sight->part.technique,
                                        .values = values,
                                        .fetch = sight->part.fetch,
                                        .wanted = sight->part.wanted};
    drop_frame(sight);
    sight->built = aob_frame_init_desc(&sight->frame, sight->part.screen, &desc, error);
    return sight->built;
}

static bool judge(const struct aob_tune_sight *sight, struct aob_error *error)
{
    for (size_t i = 0; i < sight->count; i++) {
        float value = sight->image[sight->pixels[i].at];
        if (!(value >= 0 && value <= 1))
            return aob_fail(error, "its image holds %g, which is no visibility", (double)value);
    }
    return true;
}

bool aob_tune_sight_draw(struct aob_tune_sight *sight, const double *values, size_t count,
                         struct aob_error *error)
{
    unsigned char packed[4 * AOB_MAX_PARAM];
    return aob_worker_values(sight->part.technique, values, count, packed, error) &&
           set_values(sight, packed, error) && aob_frame_run(&sight->frame, 1, NULL, error) &&
           aob_frame_read(&sight->frame, AOB_OUT_VISIBILITY, 1, sight->image, error) && judge(sight, error);
}

double aob_tune_sight_error(const struct aob_tune_sight *sight)
{
    double sum = 0;
    for (size_t i = 0; i < sight->count; i++) {
        double e = (double)sight->image[sight->pixels[i].at] - (double)sight->pixels[i].truth;
        sum += e * e;
    }
    return sight->count ? sqrt(sum / (double)sight->count) : NAN;
}
