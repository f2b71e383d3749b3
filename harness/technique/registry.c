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

void aob_registry_init(struct aob_registry *registry)
{
    *registry = (struct aob_registry){0};
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++) {
        struct aob_registry_entry *entry = AOB_PUSH(registry->entries, registry->count, registry->capacity);
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
    for (const struct aob_technique *const *t = module->techniques; *t; t++) {
        if (!aob_technique_judge(*t, error))
            return aob_fail_in(error, "%s", path);
        for (const struct aob_technique *const *other = module->techniques; other < t; other++)
            if (strcmp((*other)->name, (*t)->name) == 0)
                return aob_fail(error, "%s: two of its techniques are named '%s': rename one", path,
                                (*t)->name);
    }
    return true;
}

static bool is_loaded(const struct aob_registry *registry, const char *path)
{
    for (size_t i = 0; i < registry->count; i++)
        if (registry->entries[i].module && strcmp(registry->entries[i].module, path) == 0)
            return true;
    return false;
}

bool aob_registry_load(struct aob_registry *registry, const char *path, struct aob_error *error)
{
    char digest[AOB_KEY_SIZE];
    if (is_loaded(registry, path))
        return true;
    if (!aob_hash_file(path, digest, error))
        return false;
    char *full = realpath(path, NULL); /* a name without a slash would be searched for in the system */
    /* RTLD_LOCAL: builds of one technique define the same names, and each must find its own. */
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
        struct aob_registry_entry *entry = AOB_PUSH(registry->entries, registry->count, registry->capacity);
        entry->technique = *t;
        entry->module = path;
        memcpy(entry->digest, digest, sizeof digest);
    }
    return true;
}

static bool same_module(const char *a, const char *b)
{
    return a && b ? strcmp(a, b) == 0 : a == b;
}

const struct aob_registry_entry *aob_registry_find(const struct aob_registry *registry, const char *module,
                                                   const char *name)
{
    for (size_t i = 0; i < registry->count; i++)
        if (same_module(registry->entries[i].module, module) &&
            strcmp(registry->entries[i].technique->name, name) == 0)
            return &registry->entries[i];
    return NULL;
}

const struct aob_technique *aob_registry_open(struct aob_registry *registry,
                                              const struct aob_address *address, struct aob_error *error)
{
    if (address->module && !aob_registry_load(registry, address->module, error))
        return NULL;
    const struct aob_registry_entry *entry = aob_registry_find(registry, address->module, address->technique);
    if (entry && strcmp(entry->digest, address->digest) == 0)
        return entry->technique;
    aob_fail(error, "%s: the file is another one than when its technique '%s' was planned: start again",
             address->module ? address->module : "the program", address->technique);
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
