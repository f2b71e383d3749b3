#include "score/score.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/clock.h"
#include "base/json.h"
#include "base/memory.h"
#include "blank.h"
#include "block.h"
#include "case_image.h"
#include "effects.h"
#include "frame/left_out.h"
#include "score/bent.h"
#include "score/flip.h"
#include "score/oracle_score.h"
#include "score/split.h"
#include "score/ssim.h"
#include "block_sequence.h"
#include "traced.h"

static size_t pixels_of(const struct aob_block *block)
{
    return (size_t)block->job.drawing.view.width * (size_t)block->job.drawing.view.height;
}

/* Only the visibility of a claim is compared. */
static bool load_claim(const char *path, const struct aob_block *block, float **ao, struct aob_error *error)
{
    struct aob_traced traced = {0};
    bool ok = !path || aob_traced_load(path, block, false, &traced, error);
    *ao = traced.ao;
    traced.ao = NULL;
    aob_traced_finish(&traced);
    return ok;
}

static bool load_claims(const struct aob_block *block, const struct aob_block_case *c,
                        struct aob_case_image *image, struct aob_error *error)
{
    if (!load_claim(c->definition, block, &image->definition, error))
        return false;
    if (!image->definition || !c->screen || strcmp(c->definition, c->screen) != 0)
        return load_claim(c->screen, block, &image->screen, error);
    image->screen = AOB_NEW_ARRAY(float, pixels_of(block)); /* nothing is missing: the two are one file */
    memcpy(image->screen, image->definition, pixels_of(block) * sizeof(float));
    return true;
}

static void map_claims(const struct aob_technique *technique, const struct aob_block_case *c, size_t count,
                       struct aob_case_image *image)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    if (!image->definition || !technique->definition.map ||
        !aob_worker_values(technique, c->frame.params, c->frame.param_count, values, NULL))
        return;
    for (size_t i = 0; i < count; i++) {
        image->definition[i] = technique->definition.map(values, image->definition[i]);
        if (image->screen)
            image->screen[i] = technique->definition.map(values, image->screen[i]);
    }
}

/* The truth's own error shows how small a difference is still meaningful. NULL where no pixel has a closed form; the
 * closed forms are cosine-weighted. */
static json_t *oracle_to_json(const struct aob_block *block, const struct aob_block_target *target,
                              const float *ao, const float *truth)
{
    const char *scene = block->job.drawing.view.scene;
    struct aob_oracle_desc desc = {.oracle = scene && !target->uniform ? aob_oracle_find(scene) : NULL,
                                   .camera = &block->job.drawing.view.camera,
                                   .gbuffer = &block->drawing.gbuffer,
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
    const struct aob_projection *view = &block->drawing.gbuffer.projection;
    return (struct aob_score_desc){.width = block->job.drawing.view.width,
                                   .height = block->job.drawing.view.height,
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
static json_t *score_target(const struct aob_block *block, size_t f, const struct aob_block_target *target,
                            struct aob_case_image *image, const struct aob_traced *truth,
                            struct aob_error *error)
{
    struct aob_score_desc desc = describe(block, image, truth->ao, truth->se, target->radius);
    unsigned outputs = 1u << AOB_OUT_VISIBILITY;
    struct aob_metrics metrics;
    aob_score(&desc, &metrics);
    metrics.flip = aob_flip(&desc);
    metrics.ssim = aob_ssim(&desc);
    if (image->definition && image->screen)
        aob_split(&desc, image->definition, image->screen, &metrics);
    if (block->sequence)
        aob_block_sequence_score(block, f, (size_t)(target - block->job.targets),
                                 &(struct aob_block_sequence_images){image->ao, truth->ao, truth->se},
                                 &metrics);
    if (image->bent && truth->open) {
        const struct aob_bent_truth bent = {(const float(*)[3])truth->open, (const float(*)[3])image->normal};
        aob_bent_score(&desc, (const float(*)[3])image->bent, &bent, &metrics);
        outputs |= 1u << AOB_OUT_BENT_NORMAL;
    }
    if (!aob_case_effects_score(block, f, target, &desc, image, &metrics, &outputs, error))
        return NULL;
    json_t *entry = json_pack("{s:{s:o, s:s}, s:s}", "target", "radius", aob_json_number(target->radius),
                              "weighting", target->uniform ? "uniform" : "cosine", "reference",
                              block->job.drawing.view.captured ? "screen" : "ray-traced");
    aob_metrics_to_json(&metrics, outputs, entry);
    json_t *oracle = oracle_to_json(block, target, image->ao, truth->ao);
    if (oracle)
        json_object_set_new(entry, "oracle", oracle);
    return entry;
}

/* `none` claims nothing, and draws it; the null backend draws nothing of any. */
static bool judge_drawn(const struct aob_block *block, size_t f, const struct aob_case_image *image,
                        struct aob_error *error)
{
    const struct aob_block_case *c = &block->job.cases[block->case_of_frame[f]];
    struct aob_score_desc desc = describe(block, image, image->truth, NULL, 1);
    if (!c->definition || block->drawing.gpu->info.draws_nothing ||
        aob_score_judge_drawn(&desc, image->definition, error))
        return true;
    return aob_blank_explain(block->frames[f].graph.technique, c, &desc, error);
}

/* Against one target; the truth of the case's own one stays with the image. */
static bool score_against(const struct aob_block *block, size_t f, size_t t, struct aob_case_image *image,
                          json_t *errors, struct aob_error *error)
{
    const struct aob_block_target *target = &block->job.targets[t];
    struct aob_traced truth = {0};
    bool ok = aob_traced_load(target->truth[AOB_OUT_VISIBILITY], block, target->bent, &truth, error);
    json_t *entry = ok ? score_target(block, f, target, image, &truth, error) : NULL;
    ok = entry;
    if (ok)
        json_array_append_new(errors, entry);
    if (ok && t == block->job.cases[block->case_of_frame[f]].target) {
        image->truth = truth.ao;
        image->se = truth.se;
        image->open = image->bent ? truth.open : NULL;
        if (!image->bent)
            free(truth.open);
        return true;
    }
    aob_traced_finish(&truth);
    return ok;
}

static bool score_case(const struct aob_block *block, size_t f, struct aob_case_image *image, json_t *answer,
                       struct aob_error *error)
{
    json_t *errors = json_array();
    bool ok = true;
    for (size_t t = 0; ok && block->job.error && t < block->job.target_count; t++)
        ok = score_against(block, f, t, image, errors, error);
    if (json_array_size(errors))
        json_object_set(answer, "errors", errors);
    json_decref(errors);
    return ok;
}

/* Whether what was drawn is what the outputs say that it is. */
static bool judge_values(const struct aob_block *block, const struct aob_case_image *image,
                         struct aob_error *error)
{
    struct aob_score_desc desc = describe(block, image, image->ao, NULL, 1);
    return aob_score_judge(&desc, error) &&
           (!image->bent || aob_bent_judge(&desc, (const float(*)[3])image->bent, error)) &&
           aob_case_effects_judge(&desc, image, error);
}

static bool refuse(json_t *answer)
{
    json_object_set_new(answer, "status", json_string("invalid"));
    json_object_del(answer, "errors");
    json_object_del(answer, "sequence");
    return false;
}

/* True: the image is a visibility, and everything that it is to be compared with was there. */
static bool judge_and_score(const struct aob_block *block, size_t f, struct aob_case_image *image,
                            json_t *answer, struct aob_error *error)
{
    const struct aob_block_case *c = &block->job.cases[block->case_of_frame[f]];
    char digest[AOB_KEY_SIZE];
    if (block->sequence && !aob_block_sequence_is_drawn(block, f, error))
        return false;
    if ((block->sequence && !aob_block_sequence_judge(block, f, error)) || !judge_values(block, image, error))
        return refuse(answer);
    aob_case_image_digest(block, image, digest);
    json_object_set_new(answer, "image_digest", json_string(digest));
    if (!load_claims(block, c, image, error))
        return false;
    map_claims(block->frames[f].graph.technique, c, pixels_of(block), image);
    if (!score_case(block, f, image, answer, error)) {
        json_object_del(answer, "errors");
        return false;
    }
    if (block->sequence && image->truth)
        json_object_set_new(answer, "sequence", aob_block_sequence_to_json(block, f));
    return !image->truth || judge_drawn(block, f, image, error) || refuse(answer);
}

static bool draw(struct aob_block *block, size_t f, struct aob_case_image *image, struct aob_error *error)
{
    struct aob_frame *frame = &block->frames[f];
    if (!aob_frame_run(frame, 1, NULL, error) ||
        !aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, image->ao, error))
        return false;
    if (frame->graph.wanted & ~(unsigned)AOB_OUTPUTS_REQUIRED)
        image->normal = aob_case_image_normals(block);
    if (!aob_case_effects_read(block, frame, image, error))
        return false;
    if (!aob_graph_gives(&frame->graph, AOB_OUT_BENT_NORMAL))
        return true;
    image->bent = aob_alloc(pixels_of(block), sizeof *image->bent);
    return aob_frame_read(frame, AOB_OUT_BENT_NORMAL, 3, image->bent[0], error);
}

/* What of the surfaces the frame left out, where it was to leave out what it can. */
static bool note_left_out(const struct aob_frame *frame, json_t *answer, struct aob_error *error)
{
    double share;
    if (!(frame->graph.wanted & AOB_WANT_THRIFT))
        return true;
    if (!aob_frame_left_out(frame, &share, error))
        return false;
    json_object_set_new(answer, "left_out", aob_json_number(share));
    return true;
}

bool aob_block_score(struct aob_block *block, size_t f, json_t *answer, struct aob_error *error)
{
    const struct aob_block_case *c = &block->job.cases[block->case_of_frame[f]];
    struct aob_case_image image = {.ao = AOB_NEW_ARRAY(float, pixels_of(block)),
                                   .depth = AOB_NEW_ARRAY(float, pixels_of(block))};
    int64_t start = aob_clock_wall_ns();
    bool drawn = draw(block, f, &image, error);
    aob_case_image_crop(block, block->drawing.gbuffer.depth, 1, image.depth);
    bool ok = drawn && note_left_out(&block->frames[f], answer, error) &&
              judge_and_score(block, f, &image, answer, error);
    /* An image that is refused is stored too, because one may want to look at it. */
    if (drawn && c->image && !aob_case_image_write(block, c, &image, ok ? error : NULL))
        ok = false;
    block->shares.images += (double)(aob_clock_wall_ns() - start) * 1e-9;
    aob_case_image_finish(&image);
    return ok;
}
