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
    return strcmp(chosen->technique, technique->name) == 0 &&
           (!modules->count || technique->module ||
            !aob_technique_list_find(chosen->techniques, modules->names[0], chosen->technique, NULL));
}

bool aob_chosen_backend(const struct aob_chosen *chosen, const char *backend)
{
    return chosen->backend ? strcmp(chosen->backend, backend) == 0 : strcmp(backend, "null") != 0;
}
