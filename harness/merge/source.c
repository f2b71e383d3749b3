#include "source.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/member.h"
#include "base/text.h"

static bool hold(struct aob_merge_source *source, struct aob_error *error)
{
    char *path = aob_path_join(source->path, "journal.jsonl");
    bool ok = !aob_file_exists(path) || aob_journal_hold(&source->journal, path, error);
    free(path);
    return ok;
}

static bool is_whole(const json_t *info)
{
    return *aob_member_text(info, "config_hash") && *aob_member_text(info, "build") &&
           json_is_array(json_object_get(info, "keys"));
}

static bool read_info(struct aob_merge_source *source, struct aob_error *error)
{
    char *path = aob_path_join(source->path, "run.json");
    json_error_t cause;
    source->info = json_load_file(path, 0, &cause);
    bool ok = is_whole(source->info);
    if (!aob_file_exists(path))
        aob_fail(error, "%s: it has no run.json, so it is no folder of a run", source->path);
    else if (!ok)
        aob_fail(error, "%s: it is damaged, or an older version wrote it: start the run there again (%s)",
                 path, source->info ? "no config_hash, build or keys" : cause.text);
    free(path);
    return ok;
}

bool aob_merge_source_open(struct aob_merge_source *source, const char *path, struct aob_error *error)
{
    *source = (struct aob_merge_source){.path = path};
    if (!aob_file_exists(path))
        return aob_fail(error, "%s: there is no such folder", path);
    return hold(source, error) && read_info(source, error);
}

bool aob_merge_source_judge(const struct aob_merge_source *first, const struct aob_merge_source *other,
                            struct aob_error *error)
{
    static const char *const members[][2] = {{"config_hash", "configs"}, {"build", "builds of this program"}};
    for (size_t i = 0; i < sizeof members / sizeof *members; i++) {
        const char *a = aob_member_text(first->info, members[i][0]),
                   *b = aob_member_text(other->info, members[i][0]);
        if (strcmp(a, b) != 0)
            return aob_fail(
                error, "%s and %s hold runs of two %s (%s %s and %s): only parts of one run can be merged",
                first->path, other->path, members[i][1], members[i][0], a, b);
    }
    return true;
}

static bool judge_build(const struct aob_merge_source *source, const json_t *technique, json_t *builds,
                        struct aob_error *error)
{
    const char *module = aob_member_text(technique, "module"), *digest = aob_member_text(technique, "digest");
    struct aob_text name = {0};
    aob_text_add(&name, "technique '%s'%s%s", aob_member_text(technique, "name"), *module ? " of " : "",
                 module);
    const json_t *known = json_object_get(builds, name.data);
    const char *other = aob_member_text(known, "digest");
    bool ok = !known || strcmp(other, digest) == 0;
    if (!known)
        json_object_set_new(builds, name.data,
                            json_pack("{s:s, s:s}", "digest", digest, "folder", source->path));
    if (!ok)
        aob_fail(error,
                 "%s and %s hold runs of two builds of %s (digest %s and %s): only parts of one run can be "
                 "merged",
                 aob_member_text(known, "folder"), source->path, name.data, other, digest);
    aob_text_finish(&name);
    return ok;
}

bool aob_merge_source_judge_builds(const struct aob_merge_source *source, json_t *builds,
                                   struct aob_error *error)
{
    const json_t *technique;
    size_t at;
    json_array_foreach(json_object_get(source->info, "techniques"), at, technique)
    {
        if (!judge_build(source, technique, builds, error))
            return false;
    }
    return true;
}

bool aob_merge_source_read(struct aob_merge_source *source, struct aob_error *error)
{
    static const char *const paths[] = {"key", "status", NULL};
    struct aob_error damage = {{0}};
    char *path = aob_path_join(source->path, "journal.jsonl");
    source->records = aob_journal_read_lines(path, paths, &source->lines, &damage, error);
    if (*damage.text)
        aob_warn("%s", damage.text);
    free(path);
    return source->records;
}

void aob_merge_source_close(struct aob_merge_source *source)
{
    json_decref(source->info);
    json_decref(source->records);
    aob_journal_lines_finish(&source->lines);
    aob_journal_close(&source->journal);
    *source = (struct aob_merge_source){0};
}
