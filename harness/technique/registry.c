#include "registry.h"
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"

static void digest_builtin(const struct aob_technique *technique, char key[AOB_KEY_SIZE])
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s %u %u\n", technique->name, technique->abi, technique->revision);
    for (uint32_t i = 0; i < technique->param_count; i++) {
        const struct aob_param *p = &technique->params[i];
        aob_text_add(&text, "%s %d %.17g %.17g %d\n", p->name, p->stage, p->min, p->max, p->rule);
    }
    for (const struct aob_shader *s = technique->shaders; s->name; s++)
        aob_text_add(&text, "%s\n%s\n", s->name, s->text);
    aob_hash_text(text.data, key);
    aob_text_finish(&text);
}

static struct aob_registry_entry *place_for(struct aob_registry *registry, const char *name)
{
    for (size_t i = 0; i < registry->count; i++)
        if (strcmp(registry->entries[i].technique->name, name) == 0)
            return &registry->entries[i];
    return AOB_PUSH(registry->entries, registry->count, registry->capacity);
}

void aob_registry_init(struct aob_registry *registry)
{
    *registry = (struct aob_registry){0};
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++) {
        struct aob_registry_entry *entry = place_for(registry, (*t)->name);
        entry->technique = *t;
        digest_builtin(*t, entry->digest);
    }
}

static bool judge_module(const struct aob_module *module, const char *path, struct aob_error *error)
{
    if (module->abi != AOB_ABI)
        return aob_fail(error, "%s: made for module interface %u, this program has %u: build it again", path,
                        aob_abi_number(module->abi), AOB_ABI);
    if (module->size != sizeof *module)
        return aob_fail(
            error,
            "%s: its description has %u bytes where interface %u has %zu: build it again with this "
            "program's headers",
            path, module->size, AOB_ABI, sizeof *module);
    if (!module->techniques || !module->techniques[0])
        return aob_fail(error, "%s: the module has no technique", path);
    for (const struct aob_technique *const *t = module->techniques; *t; t++)
        if (!aob_technique_judge(*t, error))
            return aob_fail_in(error, "%s", path);
    return true;
}

bool aob_registry_load(struct aob_registry *registry, const char *path, struct aob_error *error)
{
    char digest[AOB_KEY_SIZE];
    if (!aob_hash_file(path, digest, error))
        return false;
    char *full = realpath(path, NULL); /* a name without a slash would be searched for in the system */
    void *handle = full ? dlopen(full, RTLD_NOW | RTLD_LOCAL) : NULL;
    free(full);
    if (!handle)
        return aob_fail(error, "%s: cannot load the module: %s", path, dlerror());
    const struct aob_module *module = dlsym(handle, "aob_module");
    if (!module) {
        dlclose(handle);
        return aob_fail(error, "%s: exports no symbol aob_module: not an aobudget module, or stripped", path);
    }
    if (!judge_module(module, path, error)) {
        dlclose(handle);
        return false;
    }
    *AOB_PUSH(registry->handles, registry->handle_count, registry->handle_capacity) = handle;
    for (const struct aob_technique *const *t = module->techniques; *t; t++) {
        struct aob_registry_entry *entry = place_for(registry, (*t)->name);
        entry->technique = *t;
        entry->module = path;
        memcpy(entry->digest, digest, sizeof digest);
    }
    return true;
}

const struct aob_registry_entry *aob_registry_find(const struct aob_registry *registry, const char *name)
{
    for (size_t i = 0; i < registry->count; i++)
        if (strcmp(registry->entries[i].technique->name, name) == 0)
            return &registry->entries[i];
    return NULL;
}

void aob_registry_finish(struct aob_registry *registry)
{
    for (size_t i = 0; i < registry->handle_count; i++)
        dlclose(registry->handles[i]);
    free(registry->handles);
    free(registry->entries);
    *registry = (struct aob_registry){0};
}
