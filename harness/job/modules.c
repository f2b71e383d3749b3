#include "modules.h"
#include <stdint.h>
#include <stdlib.h>
#include "base/json.h"
#include "base/memory.h"

json_t *aob_modules_to_json(const struct aob_modules *modules)
{
    json_t *array = json_array();
    for (size_t i = 0; i < modules->count; i++)
        json_array_append_new(array, aob_json_path(modules->paths[i]));
    return array;
}

void aob_modules_from_json(const json_t *array, struct aob_modules *modules)
{
    const char **paths = AOB_NEW_ARRAY(const char *, json_array_size(array) + 1);
    size_t count = 0;
    for (size_t i = 0; i < json_array_size(array); i++) {
        const char *path = json_string_value(json_array_get(array, i));
        if (path)
            paths[count++] = path;
    }
    *modules = (struct aob_modules){.paths = paths, .count = count};
}

void aob_modules_finish(struct aob_modules *modules)
{
    free((void *)(uintptr_t)modules->paths);
    *modules = (struct aob_modules){0};
}
