#include "builds.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/hash.h"
#include "base/memory.h"
#include "config/config_builds.h"
#include "run/again.h"
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

bool aob_builds_identical(const char *a, const char *b, bool *identical, struct aob_error *error)
{
    char hash_a[AOB_KEY_SIZE], hash_b[AOB_KEY_SIZE];
    if (!aob_hash_file(a, hash_a, error) || !aob_hash_file(b, hash_b, error))
        return false;
    *identical = strcmp(hash_a, hash_b) == 0;
    return true;
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
static bool measure(const struct aob_compare_desc *desc, struct aob_run_desc *run, struct aob_error *error)
{
    double precision = desc->precision > 0 ? desc->precision : AOB_COMPARE_PRECISION;
    if (!desc->quiet)
        aob_note("compare: measuring both modules in the same blocks");
    run->fresh = run->quiet = run->no_page = true;
    run->processes = AOB_COMPARE_PROCESSES_AB;
    run->seconds = desc->seconds > 0 ? desc->seconds : AOB_COMPARE_SECONDS;
    run->precision = 0.5 * precision;
    enum aob_exit code = aob_run(run, error);
    return code == AOB_EXIT_OK || code == AOB_EXIT_PART;
}

static bool measure_config(const struct aob_compare_desc *desc, const char *folder,
                           const char *const *techniques, struct aob_error *error)
{
    const struct aob_config_builds builds = {{desc->sides[0], desc->sides[1]}, techniques};
    char *config = desc->config ? aob_strdup(desc->config) : write_config(folder, techniques, error);
    struct aob_run_desc run = {
        .dispatch = desc->dispatch, .config = config, .out = folder, .builds = &builds};
    bool ok = config && measure(desc, &run, error);
    free(config);
    return ok;
}

bool aob_builds_measure(const struct aob_compare_desc *desc, const char *folder, struct aob_error *error)
{
    const struct aob_modules modules = {desc->sides, desc->sides, 2, 0};
    struct aob_technique_list list;
    if (!aob_dispatch_describe(&desc->dispatch, &modules, &list, error))
        return false;
    const char **techniques = common_techniques(&list, desc);
    bool ok = *techniques ? measure_config(desc, folder, techniques, error) : fail_nothing(desc, error);
    free(techniques);
    aob_technique_list_finish(&list);
    return ok;
}

/* A module that the run's config does not name stood in for the techniques of its names, as a --module does. */
bool aob_builds_measure_again(const struct aob_compare_desc *desc, const struct aob_old_module *stored,
                              const char *folder, struct aob_error *error)
{
    const char *const paths[] = {stored->file, desc->sides[1]}, *const names[] = {stored->name,
                                                                                  desc->sides[1]};
    const struct aob_run_again again = {stored->place, stored->records, desc->sides[1]};
    struct aob_run_desc run = {
        .dispatch = desc->dispatch, .config = stored->copy, .out = folder, .again = &again};
    run.dispatch.modules = stored->in_config ? (struct aob_modules){paths + 1, names + 1, 1, 0}
                                             : (struct aob_modules){paths, names, 2, 1};
    return measure(desc, &run, error);
}
