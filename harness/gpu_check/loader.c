#include "loader.h"
#include <dlfcn.h>
#include <stdbool.h>
#include <stdlib.h>
#include "base/memory.h"
#include "base/text.h"

static const struct {
    const char *library, *folder;
} loaders[] = {{"libvulkan.so.1", "lib/vulkan"}, {"libEGL.so.1", "lib/egl"}};

static bool has(const char *library)
{
    void *handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
    if (handle)
        dlclose(handle);
    return handle;
}

char *aob_loader_environment(const char *folder, json_t *packed)
{
    struct aob_text text = {0};
    const char *set = getenv("LD_LIBRARY_PATH");
    for (size_t i = 0; i < AOB_COUNT(loaders); i++) {
        if (has(loaders[i].library))
            continue;
        aob_text_add(&text, "%s%s/%s", text.size ? ":" : "LD_LIBRARY_PATH=", folder, loaders[i].folder);
        json_array_append_new(packed, json_string(loaders[i].library));
    }
    if (text.size && set)
        aob_text_add(&text, ":%s", set);
    return text.data;
}
