#include "set.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "store/run_folder.h"

/* "out", "out-2": a slash at the end is none of the name. */
static char *name_out(const char *out, size_t number)
{
    struct aob_text name = {0};
    size_t size = strlen(out);
    while (size > 1 && out[size - 1] == '/')
        size--;
    aob_text_add(&name, "%.*s", (int)size, out);
    if (number)
        aob_text_add(&name, "-%zu", number + 1);
    return name.data;
}

static void join(struct aob_merge_set *set, const struct aob_merge_source *source)
{
    const char *backend;
    json_t *device;
    json_object_foreach(json_object_get(source->info, "devices"), backend, device)
    {
        if (!json_is_object(json_object_get(set->devices, backend)))
            json_object_set(set->devices, backend, device);
    }
    *AOB_PUSH(set->sources, set->count, set->capacity) = source;
}

static struct aob_merge_set *find_set(struct aob_merge_sets *sets, const struct aob_merge_source *source)
{
    for (size_t i = 0; i < sets->count; i++)
        if (!aob_run_folder_other_device(sets->items[i].devices, json_object_get(source->info, "devices")))
            return &sets->items[i];
    return NULL;
}

void aob_merge_sets_make(struct aob_merge_sets *sets, const struct aob_merge_source *sources, size_t count,
                         const char *out)
{
    for (size_t i = 0; i < count; i++) {
        struct aob_merge_set *set = find_set(sets, &sources[i]);
        if (!set) {
            char *name = name_out(out, sets->count);
            set = AOB_PUSH(sets->items, sets->count, sets->capacity);
            *set = (struct aob_merge_set){.out = name, .devices = json_object()};
        }
        join(set, &sources[i]);
    }
}

static void add_folders(const struct aob_merge_set *set, struct aob_text *text)
{
    for (size_t i = 0; i < set->count; i++)
        aob_text_add(text, "%s%s", i ? ", " : "", set->sources[i]->path);
}

void aob_merge_sets_tell(const struct aob_merge_sets *sets)
{
    for (size_t i = 1; i < sets->count; i++) {
        const json_t *first = sets->items[0].devices, *own = sets->items[i].devices;
        const char *backend = aob_run_folder_other_device(first, own);
        struct aob_text folders = {0}, here = {0}, there = {0};
        add_folders(&sets->items[i], &folders);
        aob_run_folder_add_device(&here, json_object_get(own, backend));
        aob_run_folder_add_device(&there, json_object_get(first, backend));
        aob_note("%s: merged from %s, on another device (%s: %s; in %s it is %s)", sets->items[i].out,
                 folders.data, backend, here.data, sets->items[0].out, there.data);
        aob_text_finish(&folders);
        aob_text_finish(&here);
        aob_text_finish(&there);
    }
}

static bool is_same_folder(const char *a, const char *b)
{
    struct stat first, second;
    return stat(a, &first) == 0 && stat(b, &second) == 0 && first.st_dev == second.st_dev &&
           first.st_ino == second.st_ino;
}

static bool is_given(const json_t *folder, const struct aob_merge_source *sources, size_t count)
{
    bool given = false;
    for (size_t i = 0; i < count && !given; i++) {
        json_t *path = aob_json_path(sources[i].path);
        given = json_equal(path, folder);
        json_decref(path);
    }
    return given;
}

/* An earlier merge is made again from what it was made from; a run that went on in it has taken that list out of run.json. */
static bool judge_earlier(const char *out, const json_t *info, const struct aob_merge_source *sources,
                          size_t count, struct aob_error *error)
{
    const json_t *merged = json_object_get(info, "merged"), *folder;
    size_t at;
    if (!merged)
        return aob_fail(error, "%s holds a run: choose another --out", out);
    json_array_foreach(merged, at, folder)
    {
        if (!is_given(folder, sources, count))
            return aob_fail(
                error,
                "%s was merged from %s as well, which is not given: give it too, or choose another "
                "--out",
                out, json_string_value(folder) ? json_string_value(folder) : "?");
    }
    return true;
}

/* The folder, or the nearest one above that there is, must be one that can be written to; a link to nothing is there, too. */
static bool judge_place(const char *out, struct aob_error *error)
{
    char *path = aob_strdup(out), *slash;
    struct stat info;
    bool there;
    while (!(there = lstat(path, &info) == 0) && (slash = strrchr(path, '/')))
        slash[slash == path] = '\0'; /* the root keeps its slash */
    const char *place = there ? path : ".";
    bool ok = true;
    if (stat(place, &info) == 0 && !S_ISDIR(info.st_mode))
        ok = aob_fail(error, "%s: it is not a folder", place);
    else if (access(place, W_OK | X_OK) != 0)
        ok = aob_fail(error, "%s: cannot create the folder: %s", out, strerror(errno));
    free(path);
    return ok;
}

/* Of the folder and of what a run has in it. */
static bool judge_places(const char *out, struct aob_error *error)
{
    static const char *const folders[] = {"images", "truths", "rounds", "graphs", NULL};
    bool ok = judge_place(out, error);
    for (const char *const *f = folders; *f && ok; f++) {
        char *path = aob_path_join(out, *f);
        ok = judge_place(path, error);
        free(path);
    }
    return ok;
}

/* Of the folders that are written, this may be a later one. */
static bool judge_writer(const char *journal, struct aob_error *error)
{
    struct aob_journal held = {0};
    bool ok = !aob_file_exists(journal) || aob_journal_hold(&held, journal, error);
    aob_journal_close(&held);
    return ok;
}

static bool judge_out(const char *out, const struct aob_merge_source *sources, size_t count,
                      struct aob_error *error)
{
    for (size_t i = 0; i < count; i++)
        if (is_same_folder(out, sources[i].path))
            return aob_fail(error, "%s is one of the folders that are merged: choose another --out", out);
    char *journal = aob_path_join(out, "journal.jsonl"), *path = aob_path_join(out, "run.json");
    json_t *info = json_load_file(path, 0, NULL);
    bool ok = judge_places(out, error) && judge_writer(journal, error) &&
              (!aob_file_size(journal) || judge_earlier(out, info, sources, count, error));
    json_decref(info);
    free(path);
    free(journal);
    return ok;
}

bool aob_merge_sets_judge(const struct aob_merge_sets *sets, const struct aob_merge_source *sources,
                          size_t count, struct aob_error *error)
{
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < i; k++)
            if (is_same_folder(sources[i].path, sources[k].path))
                return aob_fail(error, "%s and %s are one folder: give it once", sources[k].path,
                                sources[i].path);
    for (size_t i = 0; i < sets->count; i++)
        if (!judge_out(sets->items[i].out, sources, count, error))
            return false;
    return true;
}

void aob_merge_sets_finish(struct aob_merge_sets *sets)
{
    for (size_t i = 0; i < sets->count; i++) {
        json_decref(sets->items[i].devices);
        free(sets->items[i].sources);
        free(sets->items[i].out);
    }
    free(sets->items);
    *sets = (struct aob_merge_sets){0};
}
