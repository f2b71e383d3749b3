#include "run_folder.h"
#include <dirent.h>
#include <ftw.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/part.h"
#include "base/text.h"

static bool same_text(const json_t *a, const json_t *b, const char *name)
{
    const char *ta = json_string_value(json_object_get(a, name)),
               *tb = json_string_value(json_object_get(b, name));
    return ta && tb && strcmp(ta, tb) == 0;
}

void aob_run_folder_add_device(struct aob_text *text, const json_t *device)
{
    json_t *member;
    const char *name;
    json_object_foreach((json_t *)(uintptr_t)device, name, member)
    {
        aob_text_add(text, "%s", text->size ? ", " : "");
        if (json_is_integer(member))
            aob_text_add(text, "%s %lld", name, (long long)json_integer_value(member));
        else
            aob_text_add(text, "%s", json_string_value(member) ? json_string_value(member) : "?");
    }
}

static bool fail_other_device(const char *folder, const char *backend, const json_t *then, const json_t *now,
                              struct aob_error *error)
{
    struct aob_text before = {0}, after = {0};
    aob_run_folder_add_device(&before, then);
    aob_run_folder_add_device(&after, now);
    aob_fail(error,
             "%s holds a run on another device (%s: %s; now it is %s): use --fresh to discard it, or another "
             "--out",
             folder, backend, before.data, after.data);
    aob_text_finish(&before);
    aob_text_finish(&after);
    return false;
}

const char *aob_run_folder_other_device(const json_t *then, const json_t *now)
{
    const char *backend;
    json_t *device;
    json_object_foreach((json_t *)(uintptr_t)now, backend, device)
    {
        json_t *before = json_object_get(then, backend);
        if (json_is_object(before) && json_is_object(device) && !json_equal(before, device))
            return backend;
    }
    return NULL;
}

/* A backend that could not be opened, then or now, has measured nothing that could be mixed. The device that it had
 * then stays known for the next time. */
static bool judge_devices(const struct aob_run_folder *folder, const json_t *earlier, json_t *info,
                          struct aob_error *error)
{
    json_t *devices = json_object_get(info, "devices"), *before = json_object_get(earlier, "devices"), *now;
    const char *backend, *other = aob_run_folder_other_device(before, devices);
    if (other)
        return fail_other_device(folder->path, other, json_object_get(before, other),
                                 json_object_get(devices, other), error);
    json_object_foreach(devices, backend, now)
    {
        json_t *then = json_object_get(before, backend);
        if (json_is_object(then) && !json_is_object(now))
            json_object_set(devices, backend, then);
    }
    return true;
}

static const char *find_difference(const json_t *earlier, const json_t *info)
{
    if (!earlier)
        return "a run whose run.json is missing or damaged";
    if (!same_text(earlier, info, "config_hash"))
        return "a run of another config, or of this one before it was changed";
    return same_text(earlier, info, "build") ? NULL : "a run of another build of this program";
}

static json_t *keys_of(const json_t *info, const char *list)
{
    json_t *keys = json_object(), *key;
    size_t at;
    json_array_foreach(json_object_get(info, list), at, key)
    {
        json_object_set_new(keys, json_string_value(key) ? json_string_value(key) : "", json_true());
    }
    return keys;
}

/* What an earlier call asked for stays asked for, as far as it is planned now. No list stands for all. */
static void keep_asked(const json_t *earlier, json_t *info)
{
    json_t *asked = json_object_get(info, "asked"), *before = json_object_get(earlier, "asked"), *key;
    size_t at;
    if (!asked || !before) {
        json_object_del(info, "asked");
        return;
    }
    json_t *planned = keys_of(info, "keys"), *has = keys_of(info, "asked");
    json_array_foreach(before, at, key)
    {
        const char *text = json_string_value(key);
        if (text && json_object_get(planned, text) && !json_object_get(has, text))
            json_array_append(asked, key);
    }
    json_decref(planned);
    json_decref(has);
}

/* The cases of views that this call's filter left unplanned are those that an earlier call planned. */
static void keep_planned(const json_t *earlier, json_t *info)
{
    json_t *keys = json_object_get(info, "keys"), *has = keys_of(info, "keys"), *key;
    size_t at;
    json_array_foreach(json_object_get(earlier, "keys"), at, key)
    {
        if (json_string_value(key) && !json_object_get(has, json_string_value(key)))
            json_array_append(keys, key);
    }
    json_object_set_new(info, "cases", json_integer((json_int_t)json_array_size(keys)));
    json_decref(has);
}

/* Without a record there is nothing that could be lost or mixed: such a run was stopped before its first case. */
static bool judge_earlier_run(const struct aob_run_folder *folder, json_t *info, struct aob_error *error)
{
    if (!aob_file_size(folder->journal_path))
        return true;
    json_t *earlier = json_load_file(folder->info, 0, NULL);
    const char *other = find_difference(earlier, info);
    bool ok = other ? aob_fail(error, "%s holds %s: use --fresh to discard it, or another --out",
                               folder->path, other)
                    : judge_devices(folder, earlier, info, error);
    if (ok && json_is_true(json_object_get(info, "part")))
        keep_planned(earlier, info);
    if (ok)
        keep_asked(earlier, info);
    json_decref(earlier);
    return ok;
}

static struct aob_run_folder name_files(const char *path)
{
    return (struct aob_run_folder){.path = aob_strdup(path),
                                   .info = aob_path_join(path, "run.json"),
                                   .shaders = aob_path_join(path, "shaders"),
                                   .journal_path = aob_path_join(path, "journal.jsonl")};
}

bool aob_run_folder_judge(const char *path, const json_t *info, struct aob_error *error)
{
    struct aob_run_folder folder = name_files(path);
    json_t *copy = json_deep_copy(info);
    bool ok = judge_earlier_run(&folder, copy, error);
    json_decref(copy);
    aob_run_folder_close(&folder);
    return ok;
}

/* Removes only names that a run writes: 32 hexadecimal digits and the ending. A user's own files stay. */
static void discard_files(const char *path, const char *name, const char *ending)
{
    char *folder = aob_path_join(path, name);
    DIR *directory = opendir(folder);
    for (struct dirent *entry; directory && (entry = readdir(directory));) {
        if (strspn(entry->d_name, "0123456789abcdef") != 32 || strcmp(entry->d_name + 32, ending) != 0)
            continue;
        char *file = aob_path_join(folder, entry->d_name);
        unlink(file);
        free(file);
    }
    if (directory)
        closedir(directory);
    free(folder);
}

static int discard_one(const char *path, const struct stat *info, int kind, struct FTW *at)
{
    (void)info;
    (void)kind;
    (void)at;
    remove(path);
    return 0;
}

/* What a driver keeps there is of this run alone. A killed run leaves it for the next to remove. */
static void discard_shaders(const struct aob_run_folder *folder)
{
    nftw(folder->shaders, discard_one, 16, FTW_DEPTH | FTW_PHYS);
}

/* The journal goes first, and from the disk: records whose files are gone would look like a run. */
static bool discard_earlier_run(struct aob_run_folder *folder, struct aob_error *error)
{
    char *conflicts = aob_path_join(folder->path, AOB_RUN_FOLDER_CONFLICTS);
    bool ok = aob_journal_clear(&folder->journal, error);
    if (ok) {
        discard_files(folder->path, "images", ".exr");
        discard_files(folder->path, "truths", ".exr");
        discard_files(folder->path, "rounds", ".jsonl.zst");
        unlink(conflicts);
    }
    free(conflicts);
    return ok;
}

/* What a killed run left half-written. */
static void clean_parts(const char *path)
{
    static const char *const folders[] = {".", "images", "truths", "rounds", "graphs", "report", NULL};
    for (const char *const *f = folders; *f; f++) {
        char *folder = aob_path_join(path, *f);
        aob_part_clean(folder);
        free(folder);
    }
}

static bool create_folders(const char *path, struct aob_error *error)
{
    static const char *const folders[] = {"images", "truths", "rounds", NULL};
    bool ok = true;
    for (const char *const *f = folders; *f && ok; f++) {
        char *folder = aob_path_join(path, *f);
        ok = aob_folder_create(folder, error);
        free(folder);
    }
    return ok;
}

bool aob_run_folder_open(struct aob_run_folder *folder, const char *path, json_t *info, bool fresh,
                         struct aob_error *error)
{
    *folder = name_files(path);
    bool ok = aob_folder_create(path, error) && create_folders(path, error) &&
              (fresh || judge_earlier_run(folder, info, error)) &&
              aob_journal_open(&folder->journal, folder->journal_path, error) &&
              (!fresh || discard_earlier_run(folder, error)) && aob_run_folder_describe(folder, info, error);
    if (!ok)
        return false;
    clean_parts(path);
    discard_shaders(folder);
    folder->open = true;
    return aob_folder_create(folder->shaders, error);
}

bool aob_run_folder_describe(const struct aob_run_folder *folder, const json_t *info, struct aob_error *error)
{
    char *text = json_dumps(info, JSON_INDENT(1) | JSON_REAL_PRECISION(6));
    bool ok = aob_file_write(folder->info, text, strlen(text), error);
    free(text);
    return ok;
}

bool aob_run_folder_keep_config(const struct aob_run_folder *folder, const char *text, size_t size,
                                struct aob_error *error)
{
    char *path = aob_path_join(folder->path, "run.config.yaml");
    size_t kept_size;
    char *kept = aob_file_exists(path) ? aob_file_read(path, size + 1, &kept_size, NULL) : NULL;
    bool same = kept && kept_size == size && memcmp(kept, text, size) == 0; /* it may be the config itself */
    bool ok = same || aob_file_write(path, text, size, error);
    free(kept);
    free(path);
    return ok;
}

void aob_run_folder_close(struct aob_run_folder *folder)
{
    if (folder->open)
        discard_shaders(folder);
    aob_journal_close(&folder->journal);
    free(folder->path);
    free(folder->info);
    free(folder->journal_path);
    free(folder->shaders);
    *folder = (struct aob_run_folder){0};
}
