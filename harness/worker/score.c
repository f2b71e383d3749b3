#include "block.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/clock.h"
#include "base/json.h"
#include "base/memory.h"
#include "score/flip.h"
#include "score/oracle_score.h"
#include "score/score.h"
#include "score/split.h"
#include "score/ssim.h"
#include "store/image.h"

bool aob_block_drop_damaged(const char *path, struct aob_error *error)
{
    unlink(path);
    return aob_fail_in(error, "the cached file was damaged and is removed; run again");
}

static bool load_channel(const char *path, const char *name, const struct aob_block *block, float **pixels,
                         struct aob_error *error)
{
    struct aob_image image = {0};
    if (!aob_image_read(&image, path, error))
        return aob_block_drop_damaged(path, error);
    const float *channel = aob_image_channel(&image, name);
    size_t count = (size_t)block->width * (size_t)block->height;
    bool ok = channel && image.width == block->width && image.height == block->height;
    if (ok) {
        *pixels = AOB_NEW_ARRAY(float, count);
        memcpy(*pixels, channel, count * sizeof(float));
    }
    aob_image_finish(&image);
    return ok || aob_fail(error, "%s: not a reference of %dx%d", path, block->width, block->height);
}

/* What one case is compared with, cropped to the view; screen: the definition within the screen-space bound. */
struct truth {
    float *depth, *ao, *se, *definition, *screen;
};

static void crop(const struct aob_block *block, const float *from, int stride, float *into)
{
    for (int y = 0; y < block->height; y++)
        for (int x = 0; x < block->width; x++)
            into[y * block->width + x] =
                from[((size_t)(y + block->guard) * (size_t)block->gbuffer.projection.width +
                      (size_t)(x + block->guard)) *
                     (size_t)stride];
}

static bool load_truth(const struct aob_block *block, const json_t *c, struct truth *truth,
                       struct aob_error *error)
{
    const char *reference = json_string_value(json_object_get(c, "reference"));
    const char *definition = json_string_value(json_object_get(c, "definition"));
    const char *screen = json_string_value(json_object_get(c, "screen"));
    size_t count = (size_t)block->width * (size_t)block->height;
    truth->depth = AOB_NEW_ARRAY(float, count);
    crop(block, block->gbuffer.depth, 1, truth->depth);
    if (!reference || !block->error)
        return true;
    /* All are tried, so that one run removes all that are damaged. */
    bool ok = load_channel(reference, "AO", block, &truth->ao, error) &&
              load_channel(reference, "SE", block, &truth->se, error);
    ok = (!definition || load_channel(definition, "AO", block, &truth->definition, error)) && ok;
    ok = (!screen || load_channel(screen, "AO", block, &truth->screen, error)) && ok;
    return ok;
}

static void free_truth(struct truth *truth)
{
    free(truth->depth);
    free(truth->ao);
    free(truth->se);
    free(truth->definition);
    free(truth->screen);
}

static void map_definition(const struct aob_block *block, const struct aob_frame *frame, const json_t *c,
                           struct truth *truth)
{
    const struct aob_technique *technique = frame->graph.technique;
    unsigned char values[4 * AOB_MAX_PARAM];
    if (!truth->definition || !technique->definition.map ||
        !aob_worker_params(technique, json_object_get(c, "params"), values, NULL))
        return;
    for (size_t i = 0; i < (size_t)block->width * (size_t)block->height; i++) {
        truth->definition[i] = technique->definition.map(values, truth->definition[i]);
        if (truth->screen)
            truth->screen[i] = technique->definition.map(values, truth->screen[i]);
    }
}

static json_t *score_to_json(const struct aob_score_desc *desc, const struct aob_score *s)
{
    return json_pack("{s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:I, s:I}", "rmse",
                     aob_json_number(s->rmse), "band_rmse", aob_json_number(s->band_rmse), "border_rmse",
                     aob_json_number(s->border_rmse), "border_share", aob_json_number(s->border_share), "mae",
                     aob_json_number(s->mae), "bias", aob_json_number(s->bias), "p95",
                     aob_json_number(s->p95), "max", aob_json_number(s->max), "reference_se",
                     aob_json_number(s->reference_se), "flip", aob_json_number(aob_flip(desc)), "ssim",
                     aob_json_number(aob_ssim(desc)), "pixels", (json_int_t)s->pixels, "band_pixels",
                     (json_int_t)s->band_pixels);
}

/* Its causes, where the technique claims something. */
static void add_split(const struct aob_score_desc *desc, const struct truth *truth, json_t *error)
{
    struct aob_split s = {NAN, NAN, NAN, NAN, NAN, NAN};
    if (truth->definition && truth->screen)
        aob_split(desc, truth->definition, truth->screen, &s);
    json_object_set_new(error, "definition_rmse", aob_json_number(s.definition_rmse));
    json_object_set_new(error, "missing_rmse", aob_json_number(s.missing_rmse));
    json_object_set_new(error, "estimator_rmse", aob_json_number(s.estimator_rmse));
    json_object_set_new(error, "covariance",
                        json_pack("{s:o, s:o, s:o}", "definition_missing",
                                  aob_json_number(s.definition_missing), "definition_estimator",
                                  aob_json_number(s.definition_estimator), "missing_estimator",
                                  aob_json_number(s.missing_estimator)));
}

/* What `truth` itself is off tells what a difference can mean. NULL where no pixel has a closed form. */
static json_t *oracle_to_json(const struct aob_block *block, double radius, const float *ao,
                              const float *truth)
{
    const char *scene = json_string_value(json_object_get(block->job, "scene"));
    struct aob_oracle_desc desc = {.oracle = aob_oracle_find(scene),
                                   .camera = &block->camera,
                                   .gbuffer = &block->gbuffer,
                                   .radius = radius};
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

static bool score_case(const struct aob_block *block, const json_t *c, const float *ao,
                       const struct truth *truth, json_t *answer, struct aob_error *error)
{
    struct aob_score score;
    const struct aob_projection *view = &block->gbuffer.projection;
    struct aob_score_desc desc = {.width = block->width,
                                  .height = block->height,
                                  .image = ao,
                                  .truth = truth->ao ? truth->ao : ao,
                                  .truth_se = truth->se,
                                  .depth = truth->depth,
                                  .sky_depth = 0.5f * AOB_GBUFFER_SKY,
                                  .radius = aob_json_to_number(json_object_get(c, "radius")),
                                  .pixel_scale = view->sy,
                                  .perspective = view->perspective};
    /* `none` claims nothing, and draws it; the null backend draws nothing of any. */
    bool claims = json_is_string(json_object_get(c, "definition")) && !block->gpu->info.draws_nothing;
    if (!aob_score(&desc, &score, error) || (claims && !aob_score_judge_drawn(&desc, error)))
        return false;
    if (truth->ao) {
        json_t *scored = score_to_json(&desc, &score);
        bool captured = json_is_true(json_object_get(c, "captured"));
        json_object_set_new(scored, "reference", json_string(captured ? "screen" : "ray-traced"));
        add_split(&desc, truth, scored);
        json_t *oracle = oracle_to_json(block, desc.radius, ao, truth->ao);
        if (oracle)
            json_object_set_new(scored, "oracle", oracle);
        json_object_set_new(answer, "error", scored);
    }
    return true;
}

static void add_plane(struct aob_image *image, const char *name, const float *pixels)
{
    if (pixels)
        memcpy(aob_image_add(image, name), pixels,
               (size_t)image->width * (size_t)image->height * sizeof(float));
}

static void add_camera(struct aob_image *image, const struct aob_camera *camera)
{
    aob_image_set_number(image, "aobudget.fov_deg", camera->fov_deg);
    aob_image_set_number(image, "aobudget.ortho_height", camera->ortho_height);
    aob_image_set_vec3(image, "aobudget.shift", (double[3]){camera->shift[0], camera->shift[1], 0});
    aob_image_set_vec3(image, "aobudget.eye", (double[3]){camera->eye.x, camera->eye.y, camera->eye.z});
    aob_image_set_vec3(image, "aobudget.target",
                       (double[3]){camera->target.x, camera->target.y, camera->target.z});
}

static void add_error(struct aob_image *image, const float *ao, const struct truth *truth)
{
    float *error = truth->ao ? aob_image_add(image, "error.AO") : NULL;
    for (size_t i = 0; error && i < (size_t)image->width * (size_t)image->height; i++)
        error[i] = truth->depth[i] < 0.5f * AOB_GBUFFER_SKY ? ao[i] - truth->ao[i] : 0;
}

static bool write_image(const struct aob_block *block, const json_t *c, const char *path, const float *ao,
                        const struct truth *truth, struct aob_error *error)
{
    static const char *const normals[3] = {"N.X", "N.Y", "N.Z"}, *const velocities[2] = {"V.X", "V.Y"},
                             *const albedo[3] = {"albedo.R", "albedo.G", "albedo.B"};
    struct aob_image image = {.width = block->width, .height = block->height};
    float *z = aob_image_add(&image, "Z");
    for (size_t i = 0; i < (size_t)block->width * (size_t)block->height; i++)
        z[i] = truth->depth[i] < 0.5f * AOB_GBUFFER_SKY ? truth->depth[i] : INFINITY;
    for (int n = 0; n < 3; n++)
        crop(block, block->gbuffer.normal + n, 4, aob_image_add(&image, normals[n]));
    for (int a = 0; a < 3 && block->gbuffer.albedo; a++)
        crop(block, block->gbuffer.albedo + a, 3, aob_image_add(&image, albedo[a]));
    for (int v = 0; v < 2 && block->gbuffer.velocity; v++)
        crop(block, block->gbuffer.velocity + v, 2, aob_image_add(&image, velocities[v]));
    add_plane(&image, "technique.AO", ao);
    add_plane(&image, "reference.AO", truth->ao);
    add_plane(&image, "reference.SE", truth->se);
    add_plane(&image, "definition.AO", truth->definition);
    add_plane(&image, "screen.AO", truth->screen);
    add_error(&image, ao, truth);
    add_camera(&image, &block->camera);
    aob_image_set_text(&image, "aobudget.technique", json_string_value(json_object_get(c, "technique")));
    bool ok = aob_image_write(&image, path, error);
    aob_image_finish(&image);
    return ok;
}

bool aob_block_finish_case(struct aob_block *block, size_t f, json_t *answer, struct aob_error *error)
{
    const json_t *c = json_array_get(block->cases, block->case_of_frame[f]);
    const char *path = json_string_value(json_object_get(c, "image"));
    struct truth truth = {0};
    float *ao = AOB_NEW_ARRAY(float, (size_t)block->width *(size_t)block->height);
    int64_t start = aob_clock_wall_ns();
    bool ok = aob_frame_run(&block->frames[f], NULL, error) &&
              aob_frame_read(&block->frames[f], AOB_OUT_VISIBILITY, 1, ao, error) &&
              load_truth(block, c, &truth, error);
    if (ok) {
        map_definition(block, &block->frames[f], c, &truth);
        ok = score_case(block, c, ao, &truth, answer, error) ||
             (json_object_set_new(answer, "status", json_string("invalid")), false);
    }
    if (path && truth.depth && (ok || *error->text))
        ok = write_image(block, c, path, ao, &truth, ok ? error : NULL) && ok;
    block->images_s += (double)(aob_clock_wall_ns() - start) * 1e-9;
    free_truth(&truth);
    free(ao);
    return ok;
}
