#include "config_size.h"

const struct aob_backend_choice *aob_config_backends(const struct aob_config *config,
                                                     const struct aob_technique_choice *choice)
{
    return choice->backends.count ? &choice->backends : &config->backends;
}

static double product(const struct aob_axis *axes, size_t count)
{
    double points = 1;
    for (size_t i = 0; i < count; i++)
        points *= (double)axes[i].count;
    return points;
}

/* A product of a million axes is infinite as a double; as a whole number it would have come round to a small one. */
static double count_cases(const struct aob_config *config)
{
    double places = 0, points = 0;
    for (size_t s = 0; s < config->scene_count; s++)
        places += config->scenes[s].capture ? 1 : (double)config->size_count;
    for (size_t t = 0; t < config->technique_count; t++) {
        const struct aob_technique_choice *choice = &config->techniques[t];
        points +=
            (double)aob_config_backends(config, choice)->count * product(choice->axes, choice->axis_count);
    }
    return places * points * product(config->options, config->option_count);
}

static const struct aob_axis *longer(const struct aob_axis *longest, const struct aob_axis *axes,
                                     size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!longest || axes[i].count > longest->count)
            longest = &axes[i];
    return longest;
}

bool aob_config_judge_size(const struct aob_config *config, struct aob_error *error)
{
    double cases = count_cases(config);
    if (cases <= AOB_CONFIG_MAX_CASES)
        return true;
    const struct aob_axis *longest = longer(NULL, config->options, config->option_count);
    for (size_t t = 0; t < config->technique_count; t++)
        longest = longer(longest, config->techniques[t].axes, config->techniques[t].axis_count);
    aob_fail(error, "the sweep has more than %d cases, namely %.6g: take values out of its axes",
             AOB_CONFIG_MAX_CASES, cases);
    return aob_config_fail_at(config, longest ? longest->line : 0, longest ? longest->column : 0, error);
}
