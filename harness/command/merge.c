#include "merge/merge.h"
#include <stdlib.h>
#include "base/json.h"
#include "base/member.h"
#include "base/memory.h"
#include "command.h"

struct options {
    struct aob_common common; /* its words are the folders */
    const char *out;
};

static const struct aob_flag flags[] = {
    {"out", "DIR", "the folder that they become; it holds no run yet", AOB_FLAG_TEXT,
     offsetof(struct options, out)},
    {0},
};

static void note_summary(const json_t *document)
{
    double dropped = aob_member_number(document, "dropped");
    const json_t *out;
    size_t at;
    json_array_foreach(json_object_get(document, "out"), at, out)
    {
        aob_note("%s: %.0f cases of %zu folders", aob_member_text(out, "folder"),
                 aob_member_number(out, "cases"), json_array_size(json_object_get(out, "folders")));
    }
    if (dropped > 0)
        aob_note("%.0f records were dropped: they say the same as one of a folder that was given before",
                 dropped);
}

static bool summarise(const struct options *o, const json_t *document, struct aob_error *error)
{
    if (!o->common.quiet)
        note_summary(document);
    return !o->common.json || aob_json_write(document, o->common.json, error);
}

static enum aob_exit merge(void *from, struct aob_error *error)
{
    const struct options *o = from;
    const struct aob_words *words = &o->common.words;
    struct aob_merged merged;
    if (!o->out)
        return aob_fail(error, "merge: --out DIR is missing: the folder that they become"), AOB_EXIT_USAGE;
    if (!aob_json_check(o->common.json, error))
        return AOB_EXIT_USAGE;
    const char **folders = AOB_NEW_ARRAY(const char *, words->count);
    for (size_t i = 0; i < words->count; i++)
        folders[i] = words->items[i];
    bool ok = aob_merge(&(struct aob_merge_desc){folders, words->count, o->out}, &merged, error);
    free(folders);
    if (!ok)
        return AOB_EXIT_USAGE;
    if (!summarise(o, merged.document, error))
        merged.code = AOB_EXIT_USAGE;
    json_decref(merged.document);
    return merged.code;
}

const struct aob_command aob_command_merge = {
    .name = "merge",
    .help = "one folder of the folders of a run's parts",
    .usage = "DIR... --out DIR",
    .summary = "One folder of a run of the folders of its parts, such as its shards.",
    .flags = flags,
    .least = 1,
    .most = 1000,
    .size = sizeof(struct options),
    .run = merge,
};
