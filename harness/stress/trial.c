#include "trial.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "score/bent.h"
#include "score/effect.h"

void aob_trial_init(struct aob_trial *trial, struct aob_subject *subject, bool quick)
{
    *trial = (struct aob_trial){.subject = subject, .quick = quick, .worst = -1};
}

void aob_trial_clear(struct aob_trial *trial)
{
    for (size_t i = 0; i < trial->block_count; i++) {
        if (trial->blocks[i].is_exhibit)
            aob_exhibit_finish(trial->blocks[i].data);
        free(trial->blocks[i].data);
    }
    trial->block_count = 0;
}

void aob_trial_finish(struct aob_trial *trial)
{
    aob_trial_clear(trial);
    free(trial->blocks);
    free(trial->sight.image);
    free(trial->sight.wanted);
    *trial = (struct aob_trial){0};
}

static bool stopped(const struct aob_trial *trial)
{
    return *trial->error.text || *trial->excuse.text;
}

static void *keep(struct aob_trial *trial, void *data, bool is_exhibit)
{
    *AOB_PUSH(trial->blocks, trial->block_count, trial->block_capacity) =
        (struct aob_trial_block){data, is_exhibit};
    return data;
}

struct aob_exhibit *aob_trial_exhibit(struct aob_trial *trial, const struct aob_exhibit_desc *desc)
{
    struct aob_exhibit *exhibit = AOB_NEW(struct aob_exhibit);
    if (!stopped(trial) && aob_exhibit_init(exhibit, desc, &trial->error))
        return keep(trial, exhibit, true);
    aob_mesh_finish(desc->mesh);
    free(exhibit);
    return NULL;
}

float *aob_trial_image(struct aob_trial *trial, const struct aob_exhibit *exhibit)
{
    return keep(trial, AOB_NEW_ARRAY(float, aob_exhibit_pixels(exhibit)), false);
}

float (*aob_trial_vectors(struct aob_trial *trial, const struct aob_exhibit *exhibit))[3]
{
    return keep(trial, aob_alloc(aob_exhibit_pixels(exhibit), 3 * sizeof(float)), false);
}

bool *aob_trial_mask(struct aob_trial *trial, const struct aob_exhibit *exhibit)
{
    return keep(trial, AOB_NEW_ARRAY(bool, aob_exhibit_pixels(exhibit)), false);
}

/* The sky is not held to 0..1, but what is no number there reaches the surfaces beside it in the next filter. */
static void look_through(struct aob_trial *trial, const struct aob_shot *shot, const float *pixels)
{
    for (size_t i = 0; i < aob_exhibit_pixels(shot->exhibit); i++) {
        bool fine =
            aob_exhibit_is_surface(shot->exhibit, i) ? pixels[i] >= 0 && pixels[i] <= 1 : isfinite(pixels[i]);
        if (fine || trial->broken)
            continue;
        int x = (int)(i % (size_t)shot->exhibit->width), y = (int)(i / (size_t)shot->exhibit->width);
        aob_trial_take(trial, NAN, &(struct aob_seen){.shot = shot, .image = pixels},
                       "pixel (%d, %d) of %dx%d is %g, which is no visibility", x, y, shot->exhibit->width,
                       shot->exhibit->height, (double)pixels[i]);
        trial->broken = true;
    }
}

static void look_through_bent(struct aob_trial *trial, const struct aob_shot *shot,
                              const struct aob_reading *reading)
{
    for (size_t i = 0; i < aob_exhibit_pixels(shot->exhibit); i++) {
        const float *b = reading->of[AOB_OUT_BENT_NORMAL] + 3 * i;
        if (!aob_exhibit_is_surface(shot->exhibit, i) || aob_bent_is_sound(b) || trial->broken)
            continue;
        int x = (int)(i % (size_t)shot->exhibit->width), y = (int)(i / (size_t)shot->exhibit->width);
        aob_trial_take(trial, NAN, &(struct aob_seen){.shot = shot, .image = reading->of[AOB_OUT_VISIBILITY]},
                       "pixel (%d, %d): the bent normal (%g, %g, %g) is not finite or longer than 1", x, y,
                       (double)b[0], (double)b[1], (double)b[2]);
        trial->broken = true;
    }
}

static void look_through_effect(struct aob_trial *trial, const struct aob_shot *shot, enum aob_output output,
                                const struct aob_reading *reading)
{
    const struct aob_exhibit *exhibit = shot->exhibit;
    float *depth = aob_trial_image(trial, exhibit);
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        depth[i] = aob_exhibit_depth(exhibit, i);
    const struct aob_score_desc desc = {.width = exhibit->width,
                                        .height = exhibit->height,
                                        .depth = depth,
                                        .sky_depth = 0.5f * AOB_GBUFFER_SKY};
    const struct aob_effect effect = {
        .output = output, .components = aob_output_components(output), .image = reading->of[output]};
    struct aob_error line = {{0}};
    if (trial->broken || aob_effect_judge(&desc, &effect, &line))
        return;
    aob_trial_take(trial, NAN, &(struct aob_seen){.shot = shot, .image = reading->of[AOB_OUT_VISIBILITY]},
                   "%s", line.text);
    trial->broken = true;
}

/* Draws, reads the outputs of these bits, and looks at all of them. */
static struct aob_reading read_outputs(struct aob_trial *trial, const struct aob_shot *shot, uint32_t outputs)
{
    struct aob_reading reading = {{0}, 0};
    bool unfit = false;
    struct aob_error error = {{0}};
    if (stopped(trial) || !shot->exhibit)
        return reading;
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        if (outputs >> which & 1)
            reading.of[which] = aob_output_components((enum aob_output)which) == 1
                                    ? aob_trial_image(trial, shot->exhibit)
                                    : aob_trial_vectors(trial, shot->exhibit)[0];
    if (!aob_subject_draw(trial->subject, shot, &reading, &unfit, &error)) {
        *(unfit ? &trial->excuse : &trial->error) = error;
        return (struct aob_reading){{0}, 0};
    }
    look_through(trial, shot, reading.of[AOB_OUT_VISIBILITY]);
    if (reading.of[AOB_OUT_BENT_NORMAL])
        look_through_bent(trial, shot, &reading);
    for (int which = AOB_OUT_VISIBILITY_RGB; which < AOB_OUTPUT_COUNT; which++)
        if (reading.of[which])
            look_through_effect(trial, shot, (enum aob_output)which, &reading);
    return reading;
}

float *aob_trial_draw(struct aob_trial *trial, const struct aob_shot *shot)
{
    return read_outputs(trial, shot, 1u << AOB_OUT_VISIBILITY).of[AOB_OUT_VISIBILITY];
}

struct aob_open aob_trial_draw_open(struct aob_trial *trial, const struct aob_shot *shot)
{
    struct aob_reading reading =
        read_outputs(trial, shot, 1u << AOB_OUT_VISIBILITY | 1u << AOB_OUT_BENT_NORMAL);
    return (struct aob_open){reading.of[AOB_OUT_VISIBILITY], (float(*)[3])reading.of[AOB_OUT_BENT_NORMAL]};
}

struct aob_reading aob_trial_read(struct aob_trial *trial, const struct aob_shot *shot)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    if (stopped(trial) || !aob_subject_values(trial->subject, shot, values, &options, &trial->error))
        return (struct aob_reading){{0}, 0};
    return read_outputs(trial, shot, 1u << AOB_OUT_VISIBILITY | aob_options_wanted(&options));
}

bool aob_trial_film(struct aob_trial *trial, const struct aob_film *film, const bool *wanted, float **images)
{
    bool unfit = false;
    struct aob_error error = {{0}};
    for (size_t i = 0; i < film->count; i++) {
        images[i] = NULL;
        if (stopped(trial) || !film->frames[i])
            return false;
    }
    for (size_t i = 0; i < film->count; i++)
        images[i] = wanted[i] ? aob_trial_image(trial, film->frames[i]) : NULL;
    if (!aob_subject_film(trial->subject, film, images, &unfit, &error)) {
        *(unfit ? &trial->excuse : &trial->error) = error;
        return false;
    }
    struct aob_shot shot = *film->shot;
    for (size_t i = 0; i < film->count; i++) {
        shot.exhibit = film->frames[i];
        if (images[i])
            look_through(trial, &shot, images[i]);
    }
    return true;
}

float *aob_trial_trace(struct aob_trial *trial, const struct aob_exhibit *exhibit, double radius, int spp)
{
    if (stopped(trial) || !exhibit)
        return NULL;
    float *pixels = aob_trial_image(trial, exhibit);
    if (!aob_exhibit_trace(exhibit, radius, spp, pixels, &trial->error))
        return NULL;
    look_through(trial, &(struct aob_shot){.exhibit = exhibit, .radius = radius}, pixels);
    return pixels;
}

static float *copy_of(const float *pixels, size_t count)
{
    float *copy = pixels ? AOB_NEW_ARRAY(float, count) : NULL;
    if (copy)
        memcpy(copy, pixels, count * sizeof *pixels);
    return copy;
}

static void keep_sight(struct aob_trial *trial, const struct aob_seen *seen)
{
    const struct aob_shot *shot = seen ? seen->shot : NULL;
    struct aob_sight *sight = &trial->sight;
    free(sight->image);
    free(sight->wanted);
    *sight = (struct aob_sight){{0}, {0}, 0, 0, NULL, NULL};
    if (!shot || !shot->exhibit)
        return;
    size_t count = aob_exhibit_pixels(shot->exhibit);
    aob_line_print(sight->set, sizeof sight->set, "%s", shot->set ? shot->set : "");
    sight->width = shot->exhibit->width;
    sight->height = shot->exhibit->height;
    sight->image = copy_of(seen->image, count);
    sight->wanted = copy_of(seen->wanted, count);
}

void aob_trial_take(struct aob_trial *trial, double badness, const struct aob_seen *seen, const char *format,
                    ...)
{
    va_list args;
    if (stopped(trial))
        return;
    trial->asked++;
    /* NAN is not greater than anything, and stays once it is there. */
    if (isnan(trial->worst) || badness <= trial->worst)
        return;
    trial->worst = badness;
    keep_sight(trial, seen);
    va_start(args, format);
    aob_line_print_list(trial->sight.where, sizeof trial->sight.where, format, args);
    va_end(args);
}

double aob_worse(double a, double b)
{
    return isnan(a) || a > b ? a : b;
}

double aob_over(double x)
{
    return x < 0 ? 0 : x;
}

void aob_trial_excuse(struct aob_trial *trial, const char *format, ...)
{
    va_list args;
    char line[sizeof trial->excuse.text];
    va_start(args, format);
    aob_line_print_list(line, sizeof line, format, args);
    va_end(args);
    if (!stopped(trial))
        aob_fail(&trial->excuse, "%s", line);
}

struct aob_difference aob_difference_of(const struct aob_exhibit *exhibit, const float *image,
                                        const float *wanted, const bool *mask)
{
    struct aob_difference d = {.most = -1};
    double square = 0, sum = 0;
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++) {
        if (!aob_exhibit_is_surface(exhibit, i) || (mask && !mask[i]))
            continue;
        double e = (double)image[i] - (double)wanted[i];
        d.count++;
        sum += e;
        square += e * e;
        if (fabs(e) > d.most) {
            d.most = fabs(e);
            d.at = i;
        }
    }
    d.mean = d.count ? sum / (double)d.count : NAN;
    d.rmse = d.count ? sqrt(square / (double)d.count) : NAN;
    d.most = d.count && isfinite(sum) ? d.most : NAN;
    return d;
}

double aob_mean_of(const struct aob_exhibit *exhibit, const float *image, const bool *mask)
{
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        if (aob_exhibit_is_surface(exhibit, i) && (!mask || mask[i])) {
            sum += (double)image[i];
            count++;
        }
    return count ? sum / (double)count : NAN;
}
