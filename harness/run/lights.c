#include "lights.h"
#include <string.h>
#include "base/file.h"
#include "job/light_job.h"

struct reading {
    struct aob_light_projection projection;
    bool answered;
};

static void take_answer(void *user, const json_t *object)
{
    struct reading *reading = user;
    reading->answered = reading->answered || aob_light_answer_from_json(object, &reading->projection);
}

static void note(const char *file, const struct aob_light_projection *projection)
{
    if (projection->factors[0] < 0.995)
        aob_note("%s: nine coefficients hold %.0f %% of the light's energy; bands 1 and 2 count %.2f and "
                 "%.2f, so that "
                 "no direction is negative",
                 file, 100 * projection->held, projection->factors[0], projection->factors[1]);
    else
        aob_note("%s: nine coefficients hold %.0f %% of the light's energy", file, 100 * projection->held);
}

static bool load(struct aob_scene_choice *choice, const struct aob_dispatch *dispatch,
                 struct aob_error *error)
{
    struct reading reading = {.answered = false};
    struct aob_job_desc desc = {.job = aob_light_job_to_json(choice->light),
                                .timeout_s = 60 + 2e-6 * (double)aob_file_size(choice->light),
                                .memory_limit = (size_t)4 << 30,
                                .on_answer = take_answer,
                                .user = &reading,
                                .file = choice->light};
    if (!aob_dispatch_job(dispatch, &desc, error))
        return false;
    if (!reading.answered)
        return aob_fail(error, "%s: the worker gave no answer", choice->light);
    memcpy(choice->sh, reading.projection.light.sh, sizeof choice->sh);
    note(choice->light, &reading.projection);
    return true;
}

/* The views of one scene share their probe. */
static const struct aob_scene_choice *loaded(const struct aob_config *config, size_t index)
{
    for (size_t i = 0; i < index; i++)
        if (config->scenes[i].is_probe && strcmp(config->scenes[i].light, config->scenes[index].light) == 0)
            return &config->scenes[i];
    return NULL;
}

bool aob_lights_load(struct aob_config *config, const struct aob_dispatch *dispatch, struct aob_error *error)
{
    for (size_t i = 0; i < config->scene_count; i++) {
        struct aob_scene_choice *choice = &config->scenes[i];
        const struct aob_scene_choice *before = choice->is_probe ? loaded(config, i) : NULL;
        if (before)
            memcpy(choice->sh, before->sh, sizeof choice->sh);
        else if (choice->is_probe && !load(choice, dispatch, error))
            return aob_config_fail_at(config, choice->line, choice->column, error);
    }
    return true;
}
