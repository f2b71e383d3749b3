#include "block_sequence.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"
#include "case_image.h"
#include "score/flicker.h"
#include "score/score.h"
#include "traced.h"

/* What is kept of a frame until the next one is drawn. */
struct pose {
    struct aob_gbuffer gbuffer;
    float *depth; /* of the view */
    struct aob_traced truths[AOB_CONFIG_MAX_TARGETS];
    float *images[AOB_BLOCK_MAX]; /* of each frame of the block */
    unsigned seed;
};

struct aob_block_sequence {
    struct pose poses[2], *before;
    struct aob_flicker flicker[AOB_BLOCK_MAX][AOB_CONFIG_MAX_TARGETS];
    double errors[AOB_BLOCK_MAX][AOB_CONFIG_MAX_FRAMES];
    struct aob_error undrawn[AOB_BLOCK_MAX], invalid[AOB_BLOCK_MAX]; /* empty: it was, it is not */
};

static size_t pixels_of(const struct aob_block *block)
{
    return (size_t)block->job.drawing.view.width * (size_t)block->job.drawing.view.height;
}

static void finish_pose(struct pose *pose)
{
    aob_gbuffer_finish(&pose->gbuffer);
    free(pose->depth);
    for (size_t t = 0; t < AOB_CONFIG_MAX_TARGETS; t++)
        aob_traced_finish(&pose->truths[t]);
    for (size_t f = 0; f < AOB_BLOCK_MAX; f++)
        free(pose->images[f]);
    *pose = (struct pose){.seed = 0};
}

void aob_block_sequence_destroy(struct aob_block_sequence *sequence)
{
    if (!sequence)
        return;
    finish_pose(&sequence->poses[0]);
    finish_pose(&sequence->poses[1]);
    free(sequence);
}

static bool load_pose(const struct aob_block *block, const struct aob_job_pose *from, struct pose *pose,
                      struct aob_error *error)
{
    const struct aob_job_view *view = &block->job.drawing.view;
    const struct aob_gbuffer_desc desc = {&from->camera, view->width, view->height, view->guard,
                                          from->frame > 0};
    pose->seed = from->seed;
    if (!aob_gbuffer_load(&pose->gbuffer, from->gbuffer, &desc, error))
        return false;
    pose->depth = AOB_NEW_ARRAY(float, pixels_of(block));
    aob_case_image_crop(block, pose->gbuffer.depth, 1, pose->depth);
    for (size_t t = 0; block->job.error && t < block->job.target_count; t++)
        if (!aob_traced_load(from->truth[t], block, false, &pose->truths[t], error))
            return false;
    return true;
}

static bool set_number(struct aob_frame *frame, int number, struct aob_error *error)
{
    unsigned char values[sizeof frame->values];
    memcpy(values, frame->values, sizeof values);
    return aob_frame_set(frame, number, values, error);
}

static bool draw_frame(struct aob_block *block, size_t f, int number, float *image, struct aob_error *error)
{
    struct aob_frame *frame = &block->frames[f];
    return set_number(frame, number, error) && aob_frame_run(frame, 1, NULL, error) &&
           (!block->job.score || aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, image, error));
}

static void add_pair(const struct aob_block *block, size_t f, size_t t, const struct aob_flicker_desc *pair)
{
    aob_flicker_add(&block->sequence->flicker[f][t], pair);
}

static struct aob_flicker_frame flicker_frame(const struct pose *pose, size_t f, size_t t)
{
    return (struct aob_flicker_frame){&pose->gbuffer, pose->images[f], pose->truths[t].ao,
                                      pose->truths[t].se};
}

/* Against the truths of its own time, and with the frame before. */
static void score_pose(struct aob_block *block, size_t f, size_t number, const struct pose *now)
{
    struct aob_block_sequence *sequence = block->sequence;
    const struct pose *before = sequence->before;
    const struct aob_job_view *view = &block->job.drawing.view;
    size_t own = block->job.cases[block->case_of_frame[f]].target;
    struct aob_metrics metrics;
    aob_score(&(struct aob_score_desc){.width = view->width,
                                       .height = view->height,
                                       .image = now->images[f],
                                       .truth = now->truths[own].ao,
                                       .depth = now->depth,
                                       .sky_depth = 0.5f * AOB_GBUFFER_SKY},
              &metrics);
    sequence->errors[f][number] = metrics.rmse;
    for (size_t t = 0; before && t < block->job.target_count; t++)
        add_pair(block, f, t,
                 &(struct aob_flicker_desc){.now = flicker_frame(now, f, t),
                                            .before = flicker_frame(before, f, t),
                                            .then = aob_camera_then(&block->job.poses[number].camera),
                                            .same_noise = now->seed == before->seed});
}

static bool judge_image(const struct aob_block *block, const struct pose *pose, size_t f,
                        struct aob_error *error)
{
    const struct aob_job_view *view = &block->job.drawing.view;
    return aob_score_judge(&(struct aob_score_desc){.width = view->width,
                                                    .height = view->height,
                                                    .image = pose->images[f],
                                                    .truth = pose->images[f],
                                                    .depth = pose->depth,
                                                    .sky_depth = 0.5f * AOB_GBUFFER_SKY},
                           error);
}

/* What goes wrong is kept for the case's answer; a process that only times has failed with it. */
static bool draw_pose(struct aob_block *block, size_t number, struct pose *now, struct aob_error *error)
{
    struct aob_block_sequence *sequence = block->sequence;
    for (size_t f = 0; f < block->frame_count; f++) {
        struct aob_error *undrawn = &sequence->undrawn[f], *invalid = &sequence->invalid[f];
        now->images[f] = AOB_NEW_ARRAY(float, pixels_of(block));
        if (*undrawn->text)
            continue;
        if (!draw_frame(block, f, (int)number, now->images[f], undrawn)) {
            aob_fail_in(undrawn, "frame %zu", number);
            if (!block->job.score)
                return aob_fail(error, "%s", undrawn->text);
        } else if (block->job.score && !*invalid->text && !judge_image(block, now, f, invalid))
            aob_fail_in(invalid, "frame %zu", number);
        if (block->job.score && block->job.error && !*undrawn->text && block->job.target_count)
            score_pose(block, f, number, now);
    }
    return true;
}

static bool show_last(struct aob_block *block, struct aob_error *error)
{
    struct aob_block_sequence *sequence = block->sequence;
    if (!aob_drawing_show(&block->drawing, &block->drawing.gbuffer, &block->job.drawing.view.camera, error))
        return false;
    for (size_t f = 0; f < block->frame_count; f++)
        if (!*sequence->undrawn[f].text &&
            !set_number(&block->frames[f], (int)block->job.pose_count, &sequence->undrawn[f]) &&
            !block->job.score)
            return aob_fail(error, "%s", sequence->undrawn[f].text);
    return true;
}

bool aob_block_sequence_draw(struct aob_block *block, struct aob_error *error)
{
    if (!block->job.pose_count)
        return true;
    struct aob_block_sequence *sequence = block->sequence = AOB_NEW(struct aob_block_sequence);
    for (size_t i = 0; i < block->job.pose_count; i++) {
        const struct aob_job_pose *from = &block->job.poses[i];
        struct pose *now = &sequence->poses[i % 2];
        finish_pose(now);
        if (!load_pose(block, from, now, error) ||
            !aob_drawing_show(&block->drawing, &now->gbuffer, &from->camera, error) ||
            !draw_pose(block, i, now, error))
            return false;
        sequence->before = now;
    }
    return show_last(block, error);
}

bool aob_block_sequence_is_drawn(const struct aob_block *block, size_t f, struct aob_error *error)
{
    const struct aob_error *undrawn = &block->sequence->undrawn[f];
    return !*undrawn->text || aob_fail(error, "%s", undrawn->text);
}

bool aob_block_sequence_judge(const struct aob_block *block, size_t f, struct aob_error *error)
{
    const struct aob_error *invalid = &block->sequence->invalid[f];
    return !*invalid->text || aob_fail(error, "%s", invalid->text);
}

void aob_block_sequence_score(const struct aob_block *block, size_t f, size_t t,
                              const struct aob_block_sequence_images *last, struct aob_metrics *metrics)
{
    struct aob_block_sequence *sequence = block->sequence;
    const struct aob_job_view *view = &block->job.drawing.view;
    const struct aob_flicker_frame now = {&block->drawing.gbuffer, last->image, last->truth, last->se};
    add_pair(block, f, t,
             &(struct aob_flicker_desc){.now = now,
                                        .before = flicker_frame(sequence->before, f, t),
                                        .then = aob_camera_then(&view->camera),
                                        .same_noise = view->seed == sequence->before->seed});
    metrics->flicker = aob_flicker_value(&sequence->flicker[f][t]);
    if (t == block->job.cases[block->case_of_frame[f]].target)
        sequence->errors[f][block->job.pose_count] = metrics->rmse;
}

json_t *aob_block_sequence_to_json(const struct aob_block *block, size_t f)
{
    const struct aob_block_sequence *sequence = block->sequence;
    const struct aob_flicker *own = &sequence->flicker[f][block->job.cases[block->case_of_frame[f]].target];
    size_t frames = block->job.pose_count + 1;
    json_t *errors = json_array();
    double sum = 0;
    for (size_t i = 0; i < frames; i++) {
        sum += sequence->errors[f][i];
        json_array_append_new(errors, aob_json_number(sequence->errors[f][i]));
    }
    return json_pack("{s:i, s:o, s:o, s:o, s:o, s:o}", "frames", (int)frames, "error", errors, "error_mean",
                     aob_json_number(sum / (double)frames), "flicker",
                     aob_json_number(aob_flicker_value(own)), "truth_change",
                     aob_json_number(aob_flicker_truth_change(own)), "compared",
                     aob_json_number(aob_flicker_compared(own)));
}
