#include "chosen.h"
#include <string.h>

bool aob_chosen_check(const struct aob_chosen *chosen, struct aob_error *error)
{
    if (chosen->backend && !aob_gpu_find(chosen->backend))
        return aob_fail(error, "--backend: there is no '%s'; see: aobudget list backends", chosen->backend);
    return !chosen->technique || aob_technique_list_find(chosen->techniques, NULL, chosen->technique, error);
}

bool aob_chosen_technique(const struct aob_chosen *chosen, const struct aob_technique_info *technique)
{
    const struct aob_modules *modules = chosen->modules;
    if (!chosen->technique)
        return !modules->count || technique->module;
    if (strcmp(chosen->technique, technique->name) != 0)
        return false;
    for (size_t i = 0; !technique->module && i < modules->count; i++)
        if (aob_technique_list_find(chosen->techniques, modules->names[i], chosen->technique, NULL))
            return false; /* the module's is meant */
    return true;
}

bool aob_chosen_backend(const struct aob_chosen *chosen, const char *backend)
{
    return chosen->backend ? strcmp(chosen->backend, backend) == 0 : strcmp(backend, "null") != 0;
}

/* As a shell reads it back. */
static void add_quoted(const char *word, struct aob_text *text)
{
    aob_text_add(text, "'");
    for (; *word; word++)
        aob_text_add(text, *word == '\'' ? "'\\''" : "%c", *word);
    aob_text_add(text, "'");
}

void aob_chosen_command(const struct aob_technique_info *technique, const char *backend, const char *device,
                        struct aob_text *text)
{
    aob_text_add(text, "aobudget stress");
    if (technique)
        aob_text_add(text, " --technique %s", technique->name);
    if (backend)
        aob_text_add(text, " --backend %s", backend);
    if (technique && technique->module) {
        aob_text_add(text, " --module ");
        add_quoted(technique->module, text);
    }
    if (backend && device) {
        aob_text_add(text, " --device ");
        add_quoted(device, text);
    }
}
