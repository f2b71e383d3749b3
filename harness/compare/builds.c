#include "builds.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/hash.h"
#include "base/memory.h"
#include "config/config_builds.h"
#include "run/run.h"

/* The techniques that both modules have, NULL-ended; their texts are the list's. free() it. */
static const char **common_techniques(const struct aob_technique_list *list,
                                      const struct aob_compare_desc *desc)
{
    const char **names = AOB_NEW_ARRAY(const char *, list->count + 1);
    size_t used = 0;
    for (size_t i = 0; i < list->count; i++) {
        const struct aob_technique_info *a = &list->items[i];
        if (!a->module || strcmp(a->module, desc->sides[0]) != 0 ||
            (desc->technique && strcmp(a->name, desc->technique) != 0))
            continue;
        for (size_t k = 0; k < list->count; k++) {
            const struct aob_technique_info *b = &list->items[k];
            if (b->module && strcmp(b->module, desc->sides[1]) == 0 && strcmp(b->name, a->name) == 0) {
                names[used++] = a->name;
                break;
            }
        }
    }
    return names;
}

static bool fail_nothing(const struct aob_compare_desc *desc, struct aob_error *error)
{
    if (desc->technique)
        return aob_fail(error, "%s and %s do not both have a technique '%s'", desc->sides[0], desc->sides[1],
                        desc->technique);
    return aob_fail(error, "%s and %s have no technique of one name", desc->sides[0], desc->sides[1]);
}

bool aob_builds_identical(const struct aob_compare_desc *desc, bool *identical, struct aob_error *error)
{
    char a[AOB_KEY_SIZE], b[AOB_KEY_SIZE];
    if (!aob_hash_file(desc->sides[0], a, error) || !aob_hash_file(desc->sides[1], b, error))
        return false;
    *identical = strcmp(a, b) == 0;
    return true;
}

/* The entry of run.json's techniques that is of a module and has a name of the new one's. */
static const json_t *find_stored(const json_t *info, const struct aob_technique_list *list,
                                 const struct aob_compare_desc *desc)
{
    json_t *entry;
    size_t at;
    json_array_foreach(json_object_get(info, "techniques"), at, entry)
    {
        const char *name = json_string_value(json_object_get(entry, "name"));
        for (size_t i = 0; name && json_object_get(entry, "module") && i < list->count; i++)
            if (list->items[i].module && strcmp(list->items[i].name, name) == 0 &&
                (!desc->technique || strcmp(name, desc->technique) == 0))
                return entry;
    }
    return NULL;
}

static char *check_stored(const struct aob_compare_desc *desc, const json_t *entry, struct aob_error *error)
{
    const char *module = json_string_value(json_object_get(entry, "module")),
               *digest = json_string_value(json_object_get(entry, "digest"));
    char now[AOB_KEY_SIZE];
    if (!module || !digest) {
        aob_fail(error,
                 "%s has no technique of %s that came from a module: measure both builds, compare A.so B.so",
                 desc->sides[0], desc->sides[1]);
        return NULL;
    }
    if (!aob_hash_file(module, now, error)) {
        aob_fail_in(error, "the module of %s", desc->sides[0]);
        return NULL;
    }
    if (strcmp(now, digest) != 0) {
        aob_fail(error, "%s is not the build that %s was measured with: give that build as A", module,
                 desc->sides[0]);
        return NULL;
    }
    return aob_strdup(module);
}

char *aob_builds_stored(const struct aob_compare_desc *desc, struct aob_error *error)
{
    const struct aob_modules modules = {&desc->sides[1], &desc->sides[1], 1, 0};
    struct aob_technique_list list;
    json_error_t json;
    if (!aob_dispatch_describe(&desc->dispatch, &modules, &list, error))
        return NULL;
    char *path = aob_path_join(desc->sides[0], "run.json");
    json_t *info = json_load_file(path, 0, &json);
    char *module = NULL;
    if (info)
        module = check_stored(desc, find_stored(info, &list, desc), error);
    else
        aob_fail(error, "%s: %s; is it the folder of a run?", path, json.text);
    json_decref(info);
    free(path);
    aob_technique_list_finish(&list);
    return module;
}

/* Where no config is given: the defaults of `shot`. It is kept beside the results, to be taken up and changed. */
static char *write_config(const char *folder, const char *const *techniques, struct aob_error *error)
{
    struct aob_text text = {0};
    char *path = aob_path_join(folder, "compare.yaml");
    aob_text_add(&text, "name: compare\nscenes: [{name: " AOB_COMPARE_SCENE "}]\nresolutions: [480x270]\n"
                        "backends: [vulkan]\ntechniques:\n");
    for (const char *const *name = techniques; *name; name++)
        aob_text_add(&text, "  - name: %s\n", *name);
    if (!aob_folder_create(folder, error) || !aob_file_write(path, text.data, text.size, error)) {
        free(path);
        path = NULL;
    }
    aob_text_finish(&text);
    return path;
}

/* Intervals of half the difference that counts decide it whichever way it lies. */
static bool measure(const struct aob_compare_desc *desc, const char *config, const char *folder,
                    const char *const *techniques, struct aob_error *error)
{
    const struct aob_config_builds builds = {{desc->sides[0], desc->sides[1]}, techniques};
    double precision = desc->precision > 0 ? desc->precision : AOB_COMPARE_PRECISION;
    enum aob_exit code =
        aob_run(&(struct aob_run_desc){.dispatch = desc->dispatch,
                                       .config = config,
                                       .out = folder,
                                       .fresh = true,
                                       .quiet = true,
                                       .no_page = true,
                                       .builds = &builds,
                                       .processes = AOB_COMPARE_PROCESSES_AB,
                                       .seconds = desc->seconds > 0 ? desc->seconds : AOB_COMPARE_SECONDS,
                                       .precision = 0.5 * precision},
                error);
    return code == AOB_EXIT_OK || code == AOB_EXIT_PART;
}

bool aob_builds_measure(const struct aob_compare_desc *desc, const char *folder, struct aob_error *error)
{
    const struct aob_modules modules = {desc->sides, desc->sides, 2, 0};
    struct aob_technique_list list;
    if (!aob_dispatch_describe(&desc->dispatch, &modules, &list, error))
        return false;
    const char **techniques = common_techniques(&list, desc);
    bool ok = *techniques || fail_nothing(desc, error);
    char *config = !ok            ? NULL
                   : desc->config ? aob_strdup(desc->config)
                                  : write_config(folder, techniques, error);
    if (ok && !desc->quiet)
        aob_note("compare: measuring both modules in the same blocks");
    ok = config && measure(desc, config, folder, techniques, error);
    free(config);
    free(techniques);
    aob_technique_list_finish(&list);
    return ok;
}
