#include "score/score.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/clock.h"
#include "base/json.h"
#include "base/memory.h"
#include "block.h"
#include "case_image.h"
#include "score/flip.h"
#include "score/oracle_score.h"
#include "score/split.h"
#include "score/ssim.h"
#include "store/image.h"

bool aob_block_drop_damaged(const char *path, struct aob_error *error)
{
    unlink(path);
    return aob_fail_in(error, "the cached file was damaged and is removed; run again");
}

static size_t pixels_of(const struct aob_block *block)
{
    return (size_t)block->job.view.width * (size_t)block->job.view.height;
}

static float *copy_channel(const struct aob_image *image, const char *name, size_t count)
{
    const float *channel = aob_image_channel(image, name);
    float *pixels = channel ? AOB_NEW_ARRAY(float, count) : NULL;
    if (channel)
        memcpy(pixels, channel, count * sizeof *pixels);
    return pixels;
}

/* A traced file's visibility and, if `se` is not NULL, its standard error. */
static bool load_traced(const char *path, const struct aob_block *block, float **ao, float **se,
                        struct aob_error *error)
{
    struct aob_image image = {0};
    if (!aob_image_read(&image, path, error))
        return aob_block_drop_damaged(path, error);
    bool fits = image.width == block->job.view.width && image.height == block->job.view.height;
    *ao = fits ? copy_channel(&image, "AO", pixels_of(block)) : NULL;
    if (se)
        *se = fits ? copy_channel(&image, "SE", pixels_of(block)) : NULL;
    aob_image_finish(&image);
    return (*ao && (!se || *se)) || aob_fail(error, "%s: not a reference of %dx%d", path,
                                             block->job.view.width, block->job.view.height);
}

/* All are tried, so that one run removes all that are damaged. */
static bool load_claims(const struct aob_block *block, const struct aob_block_case *c,
                        struct aob_case_image *image, struct aob_error *error)
{
    bool ok = !c->definition || load_traced(c->definition, block, &image->definition, NULL, error);
    return (!c->screen || load_traced(c->screen, block, &image->screen, NULL, error)) && ok;
}

static void map_claims(const struct aob_technique *technique, const struct aob_block_case *c, size_t count,
                       struct aob_case_image *image)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    if (!image->definition || !technique->definition.map ||
        !aob_worker_values(technique, c->params, c->param_count, values, NULL))
        return;
    for (size_t i = 0; i < count; i++) {
        image->definition[i] = technique->definition.map(values, image->definition[i]);
        if (image->screen)
            image->screen[i] = technique->definition.map(values, image->screen[i]);
    }
}

/* What `truth` itself is off tells what a difference can mean. NULL where no pixel has a closed form; the closed forms
 * are cosine-weighted. */
static json_t *oracle_to_json(const struct aob_block *block, const struct aob_block_target *target,
                              const float *ao, const float *truth)
{
    const char *scene = block->job.view.scene;
    struct aob_oracle_desc desc = {.oracle = scene && !target->uniform ? aob_oracle_find(scene) : NULL,
                                   .camera = &block->job.view.camera,
                                   .gbuffer = &block->gbuffer,
                                   .radius = target->radius};
    struct aob_oracle_score score, reference;
    if (!desc.oracle)
        return NULL;
    aob_oracle_score(&desc, ao, &score);
    aob_oracle_score(&desc, truth, &reference);
    if (!score.pixels)
        return NULL;
    return json_pack("{s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:I, s:I}", "name", desc.oracle->name, "claim",
                     desc.oracle->claim, "rmse", aob_json_number(score.rmse), "band_rmse",
                     aob_json_number(score.band_rmse), "bias", aob_json_number(score.bias), "reference_rmse",
                     aob_json_number(reference.rmse), "reference_band_rmse",
                     aob_json_number(reference.band_rmse), "pixels", (json_int_t)score.pixels, "band_pixels",
                     (json_int_t)score.band_pixels);
}

static struct aob_score_desc describe(const struct aob_block *block, const struct aob_case_image *image,
                                      const float *truth, const float *se, double radius)
{
    const struct aob_projection *view = &block->gbuffer.projection;
    return (struct aob_score_desc){.width = block->job.view.width,
                                   .height = block->job.view.height,
                                   .image = image->ao,
                                   .truth = truth,
                                   .truth_se = se,
                                   .depth = image->depth,
                                   .sky_depth = 0.5f * AOB_GBUFFER_SKY,
                                   .radius = radius,
                                   .pixel_scale = view->sy,
                                   .perspective = view->perspective};
}

/* An entry of `errors`. The reference is scored too: its own error shows how small a difference is still meaningful. */
static json_t *score_target(const struct aob_block *block, const struct aob_block_target *target,
                            const struct aob_case_image *image, const float *truth, const float *se)
{
    struct aob_score_desc desc = describe(block, image, truth, se, target->radius);
    struct aob_metrics metrics;
    aob_score(&desc, &metrics);
    metrics.flip = aob_flip(&desc);
    metrics.ssim = aob_ssim(&desc);
    if (image->definition && image->screen)
        aob_split(&desc, image->definition, image->screen, &metrics);
    json_t *entry = json_pack("{s:{s:o, s:s}, s:s}", "target", "radius", aob_json_number(target->radius),
                              "weighting", target->uniform ? "uniform" : "cosine", "reference",
                              block->job.view.captured ? "screen" : "ray-traced");
    aob_metrics_to_json(&metrics, 1u << AOB_OUT_VISIBILITY, entry);
    json_t *oracle = oracle_to_json(block, target, image->ao, truth);
    if (oracle)
        json_object_set_new(entry, "oracle", oracle);
    return entry;
}

/* `none` claims nothing, and draws it; the null backend draws nothing of any. */
static bool judge_drawn(const struct aob_block *block, const struct aob_block_case *c,
                        const struct aob_case_image *image, struct aob_error *error)
{
    struct aob_score_desc desc = describe(block, image, image->truth, NULL, 1);
    return !c->definition || block->gpu->info.draws_nothing || aob_score_judge_drawn(&desc, error);
}

static bool score_case(const struct aob_block *block, const struct aob_block_case *c,
                       struct aob_case_image *image, json_t *answer, struct aob_error *error)
{
    json_t *errors = json_array();
    bool ok = true;
    for (size_t t = 0; t < block->job.target_count; t++) {
        const struct aob_block_target *target = &block->job.targets[t];
        float *truth = NULL, *se = NULL;
        if (!target->truth)
            continue;
        bool loaded = load_traced(target->truth, block, &truth, &se, error);
        if (loaded)
            json_array_append_new(errors, score_target(block, target, image, truth, se));
        ok = ok && loaded;
        if (t == c->target) {
            image->truth = truth;
            image->se = se;
        } else {
            free(truth);
            free(se);
        }
    }
    if (json_array_size(errors))
        json_object_set(answer, "errors", errors);
    json_decref(errors);
    return ok;
}

/* True: the image is a visibility, and everything that it is to be compared with was there. */
static bool judge_and_score(const struct aob_block *block, size_t f, struct aob_case_image *image,
                            json_t *answer, struct aob_error *error)
{
    const struct aob_block_case *c = &block->job.cases[block->case_of_frame[f]];
    struct aob_score_desc desc = describe(block, image, image->ao, NULL, 1);
    if (!load_claims(block, c, image, error))
        return false;
    map_claims(block->frames[f].graph.technique, c, pixels_of(block), image);
    if (!aob_score_judge(&desc, error)) {
        json_object_set_new(answer, "status", json_string("invalid"));
        return false;
    }
    if (!score_case(block, c, image, answer, error))
        return false;
    if (image->truth && !judge_drawn(block, c, image, error)) {
        json_object_set_new(answer, "status", json_string("invalid"));
        json_object_del(answer, "errors");
        return false;
    }
    return true;
}

bool aob_block_score(struct aob_block *block, size_t f, json_t *answer, struct aob_error *error)
{
    const struct aob_block_case *c = &block->job.cases[block->case_of_frame[f]];
    struct aob_case_image image = {.ao = AOB_NEW_ARRAY(float, pixels_of(block)),
                                   .depth = AOB_NEW_ARRAY(float, pixels_of(block))};
    int64_t start = aob_clock_wall_ns();
    bool drawn = aob_frame_run(&block->frames[f], NULL, error) &&
                 aob_frame_read(&block->frames[f], AOB_OUT_VISIBILITY, 1, image.ao, error);
    aob_case_image_crop(block, block->gbuffer.depth, 1, image.depth);
    bool ok = drawn && judge_and_score(block, f, &image, answer, error);
    /* What is refused is worth a look too. */
    if (drawn && c->image && !aob_case_image_write(block, c, &image, ok ? error : NULL))
        ok = false;
    block->shares.images += (double)(aob_clock_wall_ns() - start) * 1e-9;
    aob_case_image_finish(&image);
    return ok;
}
