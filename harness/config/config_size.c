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

/* A list of the config that the product is made of. */
struct factor {
    const char *name;
    size_t count;
    int line, column;
};

/* Of two of one length the first: an axis, where there is one. */
static void take_longer(struct factor *longest, struct factor factor)
{
    if (factor.count > longest->count)
        *longest = factor;
}

static void take_axes(struct factor *longest, const struct aob_axis *axes, size_t count)
{
    for (size_t i = 0; i < count; i++)
        take_longer(longest, (struct factor){axes[i].name, axes[i].count, axes[i].line, axes[i].column});
}

static void take_backends(struct factor *longest, const struct aob_backend_choice *choice)
{
    if (choice->count)
        take_longer(longest, (struct factor){"backends", choice->count, choice->names[0].line,
                                             choice->names[0].column});
}

static struct factor find_longest(const struct aob_config *config)
{
    struct factor longest = {0};
    const struct aob_scene_choice *scenes = config->scenes;
    const struct aob_size *sizes = config->sizes;
    const struct aob_technique_choice *techniques = config->techniques;
    take_axes(&longest, config->options, config->option_count);
    for (size_t t = 0; t < config->technique_count; t++)
        take_axes(&longest, techniques[t].axes, techniques[t].axis_count);
    if (config->scene_count)
        take_longer(&longest, (struct factor){"scenes", config->scene_count, scenes->line, scenes->column});
    if (config->size_count)
        take_longer(&longest, (struct factor){"resolutions", config->size_count, sizes->line, sizes->column});
    take_backends(&longest, &config->backends);
    for (size_t t = 0; t < config->technique_count; t++)
        take_backends(&longest, &techniques[t].backends);
    if (config->technique_count)
        take_longer(&longest, (struct factor){"techniques", config->technique_count, techniques->name.line,
                                              techniques->name.column});
    return longest;
}

bool aob_config_judge_size(const struct aob_config *config, struct aob_error *error)
{
    double cases = count_cases(config);
    if (cases <= AOB_CONFIG_MAX_CASES)
        return true;
    struct factor longest = find_longest(config);
    aob_fail(error,
             "the sweep has more than %d cases, namely %.6g: make a list shorter, such as '%s' with its %zu",
             AOB_CONFIG_MAX_CASES, cases, longest.name, longest.count);
    return aob_config_fail_at(config, longest.line, longest.column, error);
}
