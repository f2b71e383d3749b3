#include "shape.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "held.h"

static void keep_first(struct aob_axis *axis)
{
    for (size_t v = 1; v < axis->count; v++)
        free(axis->values[v].text);
    axis->count = 1;
}

static void keep_first_backend(struct aob_backend_choice *backends)
{
    for (size_t i = 1; i < backends->count; i++)
        free(backends->names[i].text);
    backends->count = backends->count ? 1 : 0;
}

static void keep_technique(struct aob_config *config, const char *name)
{
    size_t kept = 0;
    for (size_t i = 0; i < config->technique_count; i++) {
        struct aob_technique_choice *choice = &config->techniques[i];
        if (strcmp(choice->name.text, name) == 0)
            config->techniques[kept++] = *choice;
        else
            aob_technique_choice_finish(choice);
    }
    config->technique_count = kept;
    if (!kept)
        AOB_PUSH(config->techniques, config->technique_count, config->technique_capacity)->name.text =
            aob_strdup(name);
}

static bool judge(const struct aob_config *config, struct aob_error *error)
{
    for (size_t i = 0; i < config->scene_count; i++)
        if (config->scenes[i].motion.frames) {
            aob_fail(error, "a fit is of pictures, and this is a sequence: leave motion out");
            return aob_config_fail_at(config, config->scenes[i].line, config->scenes[i].column, error);
        }
    if (config->measure_error)
        return true;
    aob_fail(error, "a fit is to the truth, and measure says error: false");
    return aob_config_fail_at(config, 0, 0, error);
}

bool aob_tune_shape_read(const struct aob_tune_desc *desc, struct aob_config *config, bool **held,
                         struct aob_error *error)
{
    if (!aob_config_read(config, desc->config, error) || !judge(config, error) ||
        !aob_tune_held_mark(config, desc->held_out, held, error))
        return false;
    keep_technique(config, desc->technique);
    if (config->size_count) /* none is needed where all are captures */
        config->size_count = 1;
    keep_first_backend(&config->backends);
    for (size_t i = 0; i < config->option_count; i++)
        keep_first(&config->options[i]);
    config->images = false;
    aob_config_leave_unshown(config);
    return true;
}

static int part(int pixels, int divisor)
{
    return (pixels + divisor - 1) / divisor;
}

static void make_smaller(struct aob_config *config, int divisor)
{
    for (size_t i = 0; i < config->size_count; i++) {
        config->sizes[i].width = part(config->sizes[i].width, divisor);
        config->sizes[i].height = part(config->sizes[i].height, divisor);
    }
    for (size_t i = 0; divisor > 1 && i < config->option_count; i++) {
        struct aob_value *value = &config->options[i].values[0];
        char text[16];
        if (strcmp(config->options[i].name, "guard_band") != 0)
            continue;
        snprintf(text, sizeof text, "%d", part(atoi(value->text), divisor));
        free(value->text);
        value->text = aob_strdup(text);
    }
}

static void put_entries(const struct aob_tune *tune, const struct aob_tune_shape *shape,
                        struct aob_config *config)
{
    for (size_t i = 0; i < config->technique_count; i++)
        aob_technique_choice_finish(&config->techniques[i]);
    config->technique_count = 0;
    for (size_t s = 0; s < shape->count; s++)
        for (int side = 0; side < AOB_TUNE_SIDES; side++) {
            if (!shape->sides[side] || shape->settings[s].dear)
                continue;
            struct aob_technique_choice *entry =
                AOB_PUSH(config->techniques, config->technique_count, config->technique_capacity);
            aob_tune_setting_entry(&shape->settings[s], tune->technique, (enum aob_tune_side)side,
                                   tune->target.radius, entry);
            keep_first_backend(&entry->backends);
        }
}

static void put_target(struct aob_config *config, const struct aob_target *target)
{
    config->target_count = 0;
    *AOB_PUSH(config->targets, config->target_count, config->target_capacity) = *target;
}

bool aob_tune_shape_expand(const struct aob_tune_desc *desc, const struct aob_tune *tune,
                           const struct aob_tune_shape *shape, struct aob_sweep *sweep,
                           struct aob_error *error)
{
    struct aob_config *config = &sweep->config;
    bool *held = NULL, ok = aob_tune_shape_read(desc, config, &held, error);
    free(held);
    if (!ok)
        return false;
    for (size_t i = 0; i < config->scene_count; i++)
        config->scenes[i].told = true; /* the first look at the config has said it */
    put_entries(tune, shape, config);
    put_target(config, &tune->target);
    make_smaller(config, shape->divisor);
    config->spp = config->spp < shape->spp ? config->spp : shape->spp;
    config->measure_error = shape->error;
    config->measure_time = shape->time && (config->measure_time || isfinite(desc->budget_ms));
    return aob_sweep_expand(sweep, desc->dispatch, error);
}
