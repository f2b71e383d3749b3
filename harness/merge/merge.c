#include "merge.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/hash.h"
#include "base/member.h"
#include "base/memory.h"
#include "files.h"
#include "merged_info.h"
#include "set.h"
#include "source.h"
#include "store/run_folder.h"
#include "tell.h"
#include "union.h"

/* A merge, from its folders to its document. */
struct merging {
    const struct aob_merge_desc *desc;
    struct aob_merge_source *sources;
    struct aob_merge_sets sets;
    struct aob_merge_told told;
};

static bool open_sources(struct merging *merging, struct aob_error *error)
{
    json_t *builds = json_object();
    bool ok = true;
    for (size_t i = 0; i < merging->desc->count && ok; i++)
        ok = aob_merge_source_open(&merging->sources[i], merging->desc->folders[i], error) &&
             aob_merge_source_judge(&merging->sources[0], &merging->sources[i], error) &&
             aob_merge_source_judge_builds(&merging->sources[i], builds, error);
    json_decref(builds);
    return ok;
}

static bool read_sources(struct merging *merging, struct aob_error *error)
{
    for (size_t i = 0; i < merging->desc->count; i++)
        if (!aob_merge_source_read(&merging->sources[i], error))
            return false;
    return true;
}

/* From the first source whose copy is that of the run. Without one, the folder is one of an older version. */
static bool keep_config(const struct aob_merge_set *set, const struct aob_run_folder *folder,
                        struct aob_error *error)
{
    const char *wanted = aob_member_text(set->sources[0]->info, "config_hash");
    bool ok = true, kept = false;
    for (size_t i = 0; i < set->count && !kept; i++) {
        size_t size;
        char hash[AOB_KEY_SIZE] = "", *path = aob_path_join(set->sources[i]->path, "run.config.yaml"),
             *text = aob_file_read(path, (size_t)1 << 30, &size, NULL);
        if (text)
            aob_hash_bytes(text, size, hash);
        kept = strcmp(hash, wanted) == 0;
        if (kept)
            ok = aob_run_folder_keep_config(folder, text, size, error);
        free(text);
        free(path);
    }
    if (!kept)
        aob_warn("%s: no folder has the run's config as it was: run.config.yaml is missing", folder->path);
    return ok;
}

/* Behind each line stood a line break, or what damaged the next one. */
static bool write_journal(const struct aob_merge_union *all, const char *path, struct aob_error *error)
{
    struct aob_piece *pieces = AOB_NEW_ARRAY(struct aob_piece, all->count + 1);
    size_t count = 0;
    for (size_t i = 0; i < all->count; i++) {
        const struct aob_piece *line = all->cases[i].line;
        if (!line)
            continue;
        ((char *)(uintptr_t)line->bytes)[line->size] = '\n';
        pieces[count++] = (struct aob_piece){line->bytes, line->size + 1};
    }
    bool ok = aob_file_write_pieces(path, pieces, count, error);
    free(pieces);
    return ok;
}

/* What is discarded is an earlier merge, or what one that was interrupted left. */
static bool write_folder(struct merging *merging, const struct aob_merge_set *set, json_t *info,
                         struct aob_merge_union *all, struct aob_error *error)
{
    struct aob_run_folder folder = {0};
    struct aob_merge_files files = {0};
    bool ok = aob_run_folder_open(&folder, set->out, info, true, error) && keep_config(set, &folder, error) &&
              aob_merge_files_copy(&files, all, set->out, error) &&
              aob_merge_union_keep(all, set->out, error) && aob_folder_flush(set->out, error) &&
              write_journal(all, folder.journal_path, error);
    if (ok)
        aob_merge_told_take(&merging->told, set, info, all, &files);
    aob_merge_files_finish(&files);
    aob_run_folder_close(&folder);
    return ok;
}

static bool merge_set(struct merging *merging, const struct aob_merge_set *set, struct aob_error *error)
{
    struct aob_merge_union all;
    json_t *info = aob_merged_info_create(set);
    aob_merge_union_make(&all, set, json_object_get(info, "keys"));
    bool ok = write_folder(merging, set, info, &all, error);
    aob_merge_union_finish(&all);
    json_decref(info);
    return ok;
}

static bool merge_sets(struct merging *merging, struct aob_error *error)
{
    for (size_t i = 0; i < merging->sets.count; i++)
        if (!merge_set(merging, &merging->sets.items[i], error))
            return i ? aob_fail_in(error, "%s is merged, but not %s", merging->sets.items[i - 1].out,
                                   merging->sets.items[i].out)
                     : false;
    return true;
}

bool aob_merge(const struct aob_merge_desc *desc, struct aob_merged *merged, struct aob_error *error)
{
    struct merging merging = {.desc = desc, .sources = AOB_NEW_ARRAY(struct aob_merge_source, desc->count)};
    bool ok = open_sources(&merging, error);
    if (ok)
        aob_merge_sets_make(&merging.sets, merging.sources, desc->count, desc->out);
    ok = ok && aob_merge_sets_judge(&merging.sets, merging.sources, desc->count, error) &&
         read_sources(&merging, error);
    aob_merge_told_init(&merging.told);
    ok = ok && merge_sets(&merging, error);
    if (ok) {
        aob_merge_sets_tell(&merging.sets);
        merged->code =
            aob_merge_told_tell(&merging.told) && merging.sets.count == 1 ? AOB_EXIT_OK : AOB_EXIT_PART;
        merged->document = aob_merge_told_to_json(&merging.told, desc->folders, desc->count);
    }
    aob_merge_told_finish(&merging.told);
    aob_merge_sets_finish(&merging.sets);
    for (size_t i = 0; i < desc->count; i++)
        aob_merge_source_close(&merging.sources[i]);
    free(merging.sources);
    return ok;
}
