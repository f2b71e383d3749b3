#include "old_module.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/hash.h"
#include "base/member.h"
#include "base/memory.h"
#include "config/config.h"
#include "store/journal.h"

static bool is_wanted(const struct aob_compare_desc *desc, const struct aob_technique_list *list,
                      const char *name)
{
    for (size_t i = 0; i < list->count; i++)
        if (list->items[i].module && strcmp(list->items[i].name, name) == 0)
            return !desc->technique || strcmp(name, desc->technique) == 0;
    return false;
}

/* The first entry of run.json's techniques that is of the module, or of any, and has a name of the new one's. */
static const json_t *find_technique(const json_t *info, const struct aob_compare_desc *desc,
                                    const char *module, const struct aob_technique_list *list)
{
    json_t *entry;
    size_t at;
    json_array_foreach(json_object_get(info, "techniques"), at, entry)
    {
        const char *own = aob_member_text(entry, "module");
        if (*own && (!module || strcmp(own, module) == 0) && *aob_member_text(entry, "digest") &&
            is_wanted(desc, list, aob_member_text(entry, "name")))
            return entry;
    }
    return NULL;
}

/* A run of an older program has no copy; of one whose bytes are others nothing is believed. */
static bool find_config(struct aob_old_module *stored, const char *run, const json_t *info,
                        struct aob_error *error)
{
    char hash[AOB_KEY_SIZE], *copy = aob_path_join(run, "run.config.yaml");
    bool there = *aob_member_text(info, "config") && aob_file_exists(copy);
    bool ok = there && aob_hash_file(copy, hash, error);
    if (!there)
        aob_fail(error, "%s has no copy of its config, run.config.yaml", run);
    else if (ok && strcmp(hash, aob_member_text(info, "config_hash")) != 0)
        ok = aob_fail(error, "%s is not the config that the run was measured with", copy);
    if (ok) {
        stored->place = aob_strdup(aob_member_text(info, "config"));
        stored->copy = copy;
        return true;
    }
    free(copy);
    return false;
}

static void find_file(struct aob_old_module *stored)
{
    struct aob_config config = {0};
    if (stored->copy && aob_config_read_copy(&config, stored->copy, stored->place, NULL))
        for (size_t i = 0; i < config.technique_count && !stored->file; i++)
            if (config.techniques[i].file && strcmp(config.techniques[i].module.text, stored->name) == 0)
                stored->file = aob_strdup(config.techniques[i].file);
    stored->in_config = stored->file;
    stored->file = stored->file ? stored->file : aob_strdup(stored->name);
    aob_config_finish(&config);
}

static bool check_file(const struct aob_old_module *stored, const char *run, const char *digest,
                       struct aob_error *error)
{
    char now[AOB_KEY_SIZE];
    if (!aob_hash_file(stored->file, now, error))
        return aob_fail_in(error, "the module of %s", run);
    return strcmp(now, digest) == 0 ||
           aob_fail(error, "%s is not the build that %s was measured with: give that build as A",
                    stored->file, run);
}

/* A journal may also hold cases of an earlier state of the module, which the run does not have any more. */
static bool read_records(struct aob_old_module *stored, const struct aob_compare_desc *desc,
                         const struct aob_technique_list *list, const json_t *info, struct aob_error *error)
{
    char *path = aob_path_join(desc->sides[0], "journal.jsonl");
    json_t *all = aob_journal_read(path, NULL, error), *keys = json_object(), *item;
    size_t at;
    json_array_foreach(json_object_get(info, "keys"), at, item)
    {
        json_object_set_new(keys, json_string_value(item) ? json_string_value(item) : "", json_true());
    }
    stored->records = json_array();
    json_array_foreach(all, at, item)
    {
        if (strcmp(aob_member_text(item, "module"), stored->name) == 0 &&
            is_wanted(desc, list, aob_member_text(item, "technique")) &&
            json_object_get(keys, aob_member_text(item, "key")))
            json_array_append(stored->records, item);
    }
    bool ok = all && (json_array_size(stored->records) ||
                      aob_fail(error, "%s: it has no case of %s", path, stored->name));
    json_decref(keys);
    json_decref(all);
    free(path);
    return ok;
}

static bool find(struct aob_old_module *stored, const struct aob_compare_desc *desc, const char *module,
                 const struct aob_technique_list *list, const json_t *info, struct aob_error *error)
{
    const json_t *technique = find_technique(info, desc, module, list);
    struct aob_error cause = {{0}};
    if (!technique)
        return aob_fail(error,
                        "%s has no technique of %s that came from %s: measure both builds, compare A.so B.so",
                        desc->sides[0], desc->sides[1], module ? module : "a module");
    stored->name = aob_strdup(aob_member_text(technique, "module"));
    if (!find_config(stored, desc->sides[0], info, &cause) && !desc->config)
        return aob_fail(error, "%s: name the cases with --config FILE", cause.text);
    find_file(stored);
    return check_file(stored, desc->sides[0], aob_member_text(technique, "digest"), error) &&
           read_records(stored, desc, list, info, error);
}

bool aob_old_module_find(struct aob_old_module *stored, const struct aob_compare_desc *desc,
                         const char *module, struct aob_error *error)
{
    const struct aob_modules modules = {&desc->sides[1], &desc->sides[1], 1, 0};
    struct aob_technique_list list;
    json_error_t json;
    if (!aob_dispatch_describe(&desc->dispatch, &modules, &list, error))
        return false;
    char *path = aob_path_join(desc->sides[0], "run.json");
    json_t *info = json_load_file(path, 0, &json);
    bool ok = info ? find(stored, desc, module, &list, info, error)
                   : aob_fail(error, "%s: %s; is it the folder of a run?", path, json.text);
    json_decref(info);
    free(path);
    aob_technique_list_finish(&list);
    return ok;
}

void aob_old_module_finish(struct aob_old_module *stored)
{
    free(stored->name);
    free(stored->file);
    free(stored->place);
    free(stored->copy);
    json_decref(stored->records);
    *stored = (struct aob_old_module){0};
}
