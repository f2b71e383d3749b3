#include <stdlib.h>
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

void aob_config_finish(struct aob_config *config)
{
    for (size_t i = 0; i < config->scene_count; i++) {
        free(config->scenes[i].name);
        free(config->scenes[i].file);
        free(config->scenes[i].view);
        free(config->scenes[i].capture);
        free(config->scenes[i].given);
        free(config->scenes[i].gbuffer);
    }
    for (size_t i = 0; i < config->technique_count; i++) {
        free(config->techniques[i].name.text);
        free(config->techniques[i].module.text);
        free(config->techniques[i].file);
        free_backends(&config->techniques[i].backends);
        free_axes(config->techniques[i].axes, config->techniques[i].axis_count);
    }
    free_backends(&config->backends);
    free_axes(config->options, config->option_count);
    free(config->scenes);
    free(config->sizes);
    free(config->techniques);
    free(config->targets);
    free(config->name);
    free(config->path);
    *config = (struct aob_config){0};
}
