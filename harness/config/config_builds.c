#include "config_builds.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"

static struct aob_value copy_value(const struct aob_value *value)
{
    return (struct aob_value){aob_strdup(value->text), value->line, value->column};
}

static struct aob_axis copy_axis(const struct aob_axis *axis)
{
    struct aob_axis copy = {.name = aob_strdup(axis->name),
                            .values = AOB_NEW_ARRAY(struct aob_value, axis->count),
                            .count = axis->count,
                            .line = axis->line,
                            .column = axis->column};
    for (size_t i = 0; i < axis->count; i++)
        copy.values[i] = copy_value(&axis->values[i]);
    return copy;
}

static struct aob_technique_choice copy_choice(const struct aob_technique_choice *choice, const char *file)
{
    struct aob_technique_choice copy = {
        .name = copy_value(&choice->name), .module = {aob_strdup(file), 0, 0}, .file = aob_strdup(file)};
    for (size_t i = 0; i < choice->backends.count; i++)
        *AOB_PUSH(copy.backends.names, copy.backends.count, copy.backends.capacity) =
            copy_value(&choice->backends.names[i]);
    for (size_t i = 0; i < choice->axis_count; i++)
        *AOB_PUSH(copy.axes, copy.axis_count, copy.axis_capacity) = copy_axis(&choice->axes[i]);
    return copy;
}

static bool is_wanted(const struct aob_technique_choice *choice, const struct aob_config_builds *builds)
{
    for (const char *const *name = builds->techniques; *name; name++)
        if (strcmp(choice->name.text, *name) == 0)
            return true;
    return false;
}

static bool fail_none(const struct aob_config *config, const struct aob_config_builds *builds,
                      struct aob_error *error)
{
    struct aob_text names = {0};
    for (const char *const *name = builds->techniques; *name; name++)
        aob_text_add(&names, "%s%s", names.size ? ", " : "", *name);
    aob_fail(error, "%s: no entry of techniques is one of both modules (%s)", config->path, names.data);
    aob_text_finish(&names);
    return false;
}

bool aob_config_take_builds(struct aob_config *config, const struct aob_config_builds *builds,
                            struct aob_error *error)
{
    struct aob_technique_choice *choices = NULL;
    size_t count = 0, capacity = 0;
    for (size_t i = 0; i < config->technique_count; i++) {
        struct aob_technique_choice *choice = &config->techniques[i];
        for (int b = 0; b < 2 && is_wanted(choice, builds); b++)
            *AOB_PUSH(choices, count, capacity) = copy_choice(choice, builds->files[b]);
        aob_technique_choice_finish(choice);
    }
    free(config->techniques);
    config->techniques = choices;
    config->technique_count = count;
    config->technique_capacity = capacity;
    return count || fail_none(config, builds, error);
}
