#include <stdlib.h>
#include "base/file.h"
#include "config.h"

static void free_axes(struct aob_axis *axes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        for (size_t v = 0; v < axes[i].count; v++)
            free(axes[i].values[v].text);
        free(axes[i].values);
        free(axes[i].name);
    }
    free(axes);
}

static void free_backends(struct aob_backend_choice *backends)
{
    for (size_t i = 0; i < backends->count; i++)
        free(backends->names[i].text);
    free(backends->names);
}

void aob_technique_choice_finish(struct aob_technique_choice *choice)
{
    free(choice->name.text);
    free(choice->module.text);
    free(choice->file);
    free_backends(&choice->backends);
    free_axes(choice->axes, choice->axis_count);
    *choice = (struct aob_technique_choice){0};
}

void aob_scene_choice_finish(struct aob_scene_choice *choice)
{
    free(choice->name);
    free(choice->file);
    free(choice->view);
    free(choice->capture);
    free(choice->given);
    free(choice->light);
    free(choice->gbuffer);
}

void aob_config_leave_gone(struct aob_config *config, struct aob_text *gone)
{
    size_t kept = 0;
    for (size_t i = 0; i < config->scene_count; i++) {
        struct aob_scene_choice *choice = &config->scenes[i];
        const char *file = choice->capture ? choice->capture : choice->file;
        if (!file || aob_file_exists(file)) {
            config->scenes[kept++] = *choice;
            continue;
        }
        aob_text_add_line(gone, "%s%s", choice->capture ? "capture:" : "", choice->given);
        aob_scene_choice_finish(choice);
    }
    config->scene_count = kept;
}

void aob_config_leave_unshown(struct aob_config *config)
{
    for (size_t i = 0; i < config->profile_count; i++)
        free(config->profiles[i].text);
    free(config->profiles);
    config->profiles = NULL;
    config->profile_count = config->profile_capacity = 0;
    free(config->budget.text);
    config->budget.text = NULL;
}

void aob_config_finish(struct aob_config *config)
{
    for (size_t i = 0; i < config->scene_count; i++)
        aob_scene_choice_finish(&config->scenes[i]);
    free(config->effects.text);
    for (size_t i = 0; i < config->technique_count; i++)
        aob_technique_choice_finish(&config->techniques[i]);
    aob_config_leave_unshown(config);
    free_backends(&config->backends);
    free_axes(config->options, config->option_count);
    free(config->scenes);
    free(config->sizes);
    free(config->techniques);
    free(config->targets);
    free(config->name);
    free(config->path);
    free(config->place);
    free(config->text);
    *config = (struct aob_config){0};
}
