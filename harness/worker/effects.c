#include "effects.h"
#include <stdio.h>
#include <stdlib.h>
#include "base/memory.h"
#include "job/term.h"
#include "scene/light.h"
#include "store/image.h"

static size_t pixels_of(const struct aob_block *block)
{
    return (size_t)block->job.drawing.view.width * (size_t)block->job.drawing.view.height;
}

bool aob_case_effects_read(const struct aob_block *block, struct aob_frame *frame,
                           struct aob_case_image *image, struct aob_error *error)
{
    for (int which = AOB_OUT_VISIBILITY_RGB; which < AOB_OUTPUT_COUNT; which++) {
        struct aob_case_effect *effect = &image->effects[which];
        if (!aob_graph_gives(&frame->graph, (enum aob_output)which))
            continue;
        effect->components = aob_output_components((enum aob_output)which);
        effect->image = AOB_NEW_ARRAY(float, pixels_of(block) * (size_t)effect->components);
        if (!aob_frame_read(frame, (enum aob_output)which, effect->components, effect->image, error))
            return false;
    }
    return true;
}

bool aob_case_effects_judge(const struct aob_score_desc *desc, const struct aob_case_image *image,
                            struct aob_error *error)
{
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++) {
        const struct aob_case_effect *effect = &image->effects[which];
        const struct aob_effect judged = {
            .output = (enum aob_output)which, .components = effect->components, .image = effect->image};
        if (effect->image && !aob_effect_judge(desc, &judged, error))
            return false;
    }
    return true;
}

static bool load_truth(const struct aob_block *block, const char *path, struct aob_case_effect *effect,
                       struct aob_error *error)
{
    static const char *const values[] = {"R", "G", "B"}, *const errors[] = {"SE.R", "SE.G", "SE.B"};
    const struct aob_job_view *view = &block->job.drawing.view;
    struct aob_image file = {0};
    size_t stride = (size_t)effect->components;
    if (!aob_image_read(&file, path, error))
        return false;
    if (file.width == view->width && file.height == view->height) {
        effect->truth = aob_image_interleaved(&file, values, stride, stride);
        effect->se = aob_image_interleaved(&file, errors, stride, stride);
    }
    aob_image_finish(&file);
    return (effect->truth && effect->se) ||
           aob_fail(error, "%s: not a reference of %dx%d", path, view->width, view->height);
}

/* What the visibility stands for where nobody knows more: the same share of every channel, of the lobe, or of what falls on an
 * open surface. */
static float *make_plain(const struct aob_block *block, size_t f, enum aob_output which,
                         const struct aob_case_image *image)
{
    const struct aob_light *light = &block->frames[f].screen->light;
    size_t stride = (size_t)image->effects[which].components, pixels = pixels_of(block);
    float *plain = AOB_NEW_ARRAY(float, pixels *stride);
    for (size_t i = 0; i < pixels; i++) {
        double open[3] = {1, 1, 1};
        const float *n = image->normal[i];
        if (which == AOB_OUT_IRRADIANCE)
            aob_light_irradiance(light, aob_vec((double)n[0], (double)n[1], (double)n[2]), open);
        for (size_t c = 0; c < stride; c++)
            plain[i * stride + c] = image->ao[i] * (float)open[c];
    }
    return plain;
}

/* The fit of bounces, given the true visibility; it is one of visibility that the cosine weighs. */
static float *make_model(const struct aob_block *block, const float *truth)
{
    size_t pixels = pixels_of(block);
    float *model = AOB_NEW_ARRAY(float, 3 * pixels), *albedo = aob_case_image_albedo(block);
    for (size_t i = 0; i < 3 * pixels; i++)
        model[i] = (float)aob_effect_bounced((double)truth[i / 3], (double)albedo[i]);
    free(albedo);
    return model;
}

static void score_effect(const struct aob_block *block, size_t f, const struct aob_block_target *target,
                         const struct aob_score_desc *desc, const struct aob_case_image *image,
                         const struct aob_effect *traced, struct aob_metrics *metrics)
{
    struct aob_effect effect = *traced;
    bool lit = effect.output == AOB_OUT_LIT; /* a case that wants no further output is the plain one */
    bool fits = effect.output == AOB_OUT_VISIBILITY_RGB && !target->uniform;
    float *plain = lit ? NULL : make_plain(block, f, effect.output, image),
          *model = fits ? make_model(block, desc->truth) : NULL;
    effect.plain = plain;
    effect.exposure = aob_light_exposure(&block->frames[f].screen->light);
    effect.model = model;
    aob_effect_score(desc, &effect, metrics);
    free(plain);
    free(model);
}

static bool is_own(const struct aob_block *block, size_t f, const struct aob_block_target *target)
{
    return target == &block->job.targets[block->job.cases[block->case_of_frame[f]].target];
}

bool aob_case_effects_score(const struct aob_block *block, size_t f, const struct aob_block_target *target,
                            const struct aob_score_desc *desc, struct aob_case_image *image,
                            struct aob_metrics *metrics, unsigned *outputs, struct aob_error *error)
{
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++) {
        struct aob_case_effect *drawn = &image->effects[which];
        struct aob_case_effect traced = {.components = drawn->components};
        if (!drawn->image || !target->truth[which])
            continue;
        bool ok = load_truth(block, target->truth[which], &traced, error);
        if (ok) {
            const struct aob_effect effect = {.output = (enum aob_output)which,
                                              .components = drawn->components,
                                              .image = drawn->image,
                                              .truth = traced.truth,
                                              .se = traced.se};
            score_effect(block, f, target, desc, image, &effect, metrics);
            *outputs |= 1u << which;
        }
        if (ok && is_own(block, f, target)) {
            drawn->truth = traced.truth;
            drawn->se = traced.se;
            continue;
        }
        free(traced.truth);
        free(traced.se);
        if (!ok)
            return false;
    }
    return true;
}

/* "technique.irradiance.R", or without a letter where there is one component. */
static void add_channels(struct aob_image *file, const char *whose, const char *name, const float *values,
                         int components)
{
    for (int c = 0; c < components; c++) {
        char channel[64];
        snprintf(channel, sizeof channel, components > 1 ? "%s.%s.%c" : "%s.%s", whose, name, "RGB"[c]);
        aob_image_add_part(file, channel, values + c, (size_t)components);
    }
}

static void add_difference(struct aob_image *file, const char *name, const struct aob_case_image *image,
                           const struct aob_case_effect *effect)
{
    char channel[64];
    size_t stride = (size_t)effect->components;
    snprintf(channel, sizeof channel, "error.%s", name);
    float *into = aob_image_add(file, channel);
    for (size_t i = 0; i < (size_t)file->width * (size_t)file->height; i++)
        for (size_t c = 0; c < stride && !aob_case_image_is_sky(image, i); c++)
            into[i] += (effect->image[i * stride + c] - effect->truth[i * stride + c]) / (float)stride;
}

void aob_case_effects_store(const struct aob_case_image *image, struct aob_image *file)
{
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++) {
        const struct aob_case_effect *effect = &image->effects[which];
        const char *name = aob_output_name((enum aob_output)which);
        if (!effect->image)
            continue;
        add_channels(file, "technique", name, effect->image, effect->components);
        if (!effect->truth)
            continue;
        add_channels(file, "reference", name, effect->truth, effect->components);
        add_channels(file, "reference.SE", name, effect->se, effect->components);
        add_difference(file, name, image, effect);
    }
}

void aob_case_effects_finish(struct aob_case_image *image)
{
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++) {
        free(image->effects[which].image);
        free(image->effects[which].truth);
        free(image->effects[which].se);
        image->effects[which] = (struct aob_case_effect){0};
    }
}
