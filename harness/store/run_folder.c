#include "run_folder.h"
#include <dirent.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"

static bool same_text(const json_t *a, const json_t *b, const char *name)
{
    const char *ta = json_string_value(json_object_get(a, name)),
               *tb = json_string_value(json_object_get(b, name));
    return ta && tb && strcmp(ta, tb) == 0;
}

static bool judge_earlier_run(const struct aob_run_folder *folder, const json_t *info,
                              struct aob_error *error)
{
    if (!aob_file_exists(folder->info) && !aob_file_exists(folder->journal_path))
        return true;
    json_t *earlier = json_load_file(folder->info, 0, NULL);
    const char *other = !earlier ? "a run whose run.json is missing or damaged"
                        : !same_text(earlier, info, "config_hash")
                            ? "a run of another config, or of this one "
                              "before it was changed"
                        : !same_text(earlier, info, "build") ? "a run of another build of this program"
                                                             : NULL;
    json_decref(earlier);
    return !other ||
           aob_fail(error, "%s holds %s: use --fresh to discard it, or another --out", folder->path, other);
}

/* Names are ours: 32 hexadecimal digits and .exr. */
static void discard_images(const char *images)
{
    DIR *directory = opendir(images);
    for (struct dirent *entry; directory && (entry = readdir(directory));) {
        if (strspn(entry->d_name, "0123456789abcdef") != 32 || strcmp(entry->d_name + 32, ".exr") != 0)
            continue;
        char *path = aob_path_join(images, entry->d_name);
        unlink(path);
        free(path);
    }
    if (directory)
        closedir(directory);
}

static bool discard_earlier_run(struct aob_run_folder *folder, const char *images, struct aob_error *error)
{
    discard_images(images);
    return ftruncate(folder->journal.file, 0) == 0 ||
           aob_fail(error, "%s: cannot be emptied", folder->journal_path);
}

bool aob_run_folder_open(struct aob_run_folder *folder, const char *path, const json_t *info, bool fresh,
                         struct aob_error *error)
{
    *folder = (struct aob_run_folder){.path = aob_strdup(path),
                                      .info = aob_path_join(path, "run.json"),
                                      .journal_path = aob_path_join(path, "journal.jsonl")};
    char *images = aob_path_join(path, "images");
    bool ok = aob_folder_create(path, error) && aob_folder_create(images, error) &&
              (fresh || judge_earlier_run(folder, info, error)) &&
              aob_journal_open(&folder->journal, folder->journal_path, error) &&
              (!fresh || discard_earlier_run(folder, images, error)) &&
              aob_run_folder_describe(folder, info, error);
    free(images);
    return ok;
}

bool aob_run_folder_describe(const struct aob_run_folder *folder, const json_t *info, struct aob_error *error)
{
    char *text = json_dumps(info, JSON_INDENT(1) | JSON_REAL_PRECISION(6));
    bool ok = aob_file_write(folder->info, text, strlen(text), error);
    free(text);
    return ok;
}

void aob_run_folder_close(struct aob_run_folder *folder)
{
    aob_journal_close(&folder->journal);
    free(folder->path);
    free(folder->info);
    free(folder->journal_path);
    *folder = (struct aob_run_folder){0};
}
