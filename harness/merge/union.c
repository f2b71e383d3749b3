#include "union.h"
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/json_keep.h"
#include "base/member.h"
#include "base/memory.h"
#include "base/table.h"
#include "base/text.h"
#include "store/run_folder.h"

static int rank_of(const json_t *record)
{
    const char *status = aob_member_text(record, "status");
    return strcmp(status, "ok") == 0 ? 2 : strcmp(status, "invalid") == 0 ? 1 : 0;
}

/* Some members of a line; decref it. */
static json_t *read_members(const struct aob_piece *line, const char *const *paths)
{
    char *cut = aob_alloc(line->size + 1, 1);
    json_t *record = json_loadb(cut, aob_json_keep(line->bytes, line->size, paths, cut), 0, NULL);
    free(cut);
    return record;
}

char *aob_merge_case_describe(const struct aob_piece *line)
{
    static const char *const paths[] = {"scene",   "view",  "technique", "params",
                                        "backend", "width", "height",    NULL};
    struct aob_text text = {0};
    json_t *record = read_members(line, paths), *value;
    const char *name;
    aob_text_add(&text, "%s/%s %s", aob_member_text(record, "scene"), aob_member_text(record, "view"),
                 aob_member_text(record, "technique"));
    json_object_foreach(json_object_get(record, "params"), name, value)
    {
        char *shown = aob_member_show(value);
        aob_text_add(&text, " %s=%s", name, shown);
        free(shown);
    }
    aob_text_add(&text, ", %s %gx%g", aob_member_text(record, "backend"), aob_member_number(record, "width"),
                 aob_member_number(record, "height"));
    json_decref(record);
    return text.data;
}

/* What two records of a case must agree on; NULL: they do. */
static const char *find_difference(const struct aob_piece *a, const struct aob_piece *b)
{
    static const char *const members[] = {"image_digest", "errors", "error", "sequence", NULL};
    const char *difference = NULL;
    json_t *first = read_members(a, members), *second = read_members(b, members);
    for (const char *const *m = members; *m && !difference; m++) {
        const json_t *here = json_object_get(first, *m), *there = json_object_get(second, *m);
        if (here != there && !json_equal(here, there))
            difference = *m;
    }
    json_decref(first);
    json_decref(second);
    return difference;
}

static void offer(struct aob_merge_union *all, size_t place, const struct aob_merge_source *source, size_t at)
{
    struct aob_merge_case *c = &all->cases[place];
    const json_t *record = json_array_get(source->records, at);
    const struct aob_piece *line = &source->lines.items[at];
    int rank = rank_of(record);
    if (c->source && rank == c->rank)
        *AOB_PUSH(all->others, all->other_count, all->other_capacity) =
            (struct aob_merge_other){place, source, line, rank, find_difference(c->line, line)};
    if (!c->source || rank > c->rank)
        *c = (struct aob_merge_case){c->key, source, line, rank};
}

static size_t find_case(struct aob_merge_union *all, struct aob_table *places, const char *key)
{
    size_t at = aob_table_put(places, key, all->count);
    if (at == all->count)
        *AOB_PUSH(all->cases, all->count, all->capacity) = (struct aob_merge_case){.key = key};
    return at;
}

static void add_conflict(struct aob_merge_union *all, const struct aob_merge_other *other, const char *kept)
{
    const struct aob_merge_case *stands = &all->cases[other->at];
    char *what = aob_merge_case_describe(stands->line);
    json_array_append_new(all->conflicts,
                          json_pack("{s:s, s:s, s:[s, s], s:s, s:s}", "key", stands->key, "case", what,
                                    "folders", stands->source->path, other->source->path, "differs",
                                    other->differs, "kept", kept));
    free(what);
}

/* What was compared with a record that gave way to a better one is no matter any more. */
static void settle(struct aob_merge_union *all, const char *out)
{
    char *kept = aob_path_join(out, AOB_RUN_FOLDER_CONFLICTS);
    size_t count = 0;
    for (size_t i = 0; i < all->other_count; i++) {
        const struct aob_merge_other other = all->others[i];
        if (other.rank != all->cases[other.at].rank)
            continue;
        all->others[count++] = other;
        all->dropped += !other.differs;
        if (other.differs)
            add_conflict(all, &other, kept);
    }
    all->other_count = count;
    free(kept);
}

void aob_merge_union_make(struct aob_merge_union *all, const struct aob_merge_set *set, const json_t *keys)
{
    struct aob_table places = {0};
    json_t *value;
    size_t at, planned;
    *all = (struct aob_merge_union){.conflicts = json_array()};
    json_array_foreach(keys, at, value)
    {
        find_case(all, &places, json_string_value(value));
    }
    planned = all->count;
    for (size_t s = 0; s < set->count; s++)
        json_array_foreach(set->sources[s]->records, at, value)
        {
            const char *key = json_string_value(json_object_get(value, "key"));
            offer(all, find_case(all, &places, key), set->sources[s], at);
        }
    for (size_t i = 0; i < planned; i++)
        all->missing += !all->cases[i].source;
    aob_table_finish(&places);
    settle(all, set->out);
}

/* What stands before a line; free() it. */
static char *make_head(const struct aob_merge_source *source)
{
    json_t *path = aob_json_path(source->path);
    char *shown = json_dumps(path, JSON_ENCODE_ANY);
    struct aob_text head = {0};
    aob_text_add(&head, "{\"folder\":%s,\"record\":", shown);
    free(shown);
    json_decref(path);
    return head.data;
}

bool aob_merge_union_keep(const struct aob_merge_union *all, const char *out, struct aob_error *error)
{
    struct aob_piece *pieces = AOB_NEW_ARRAY(struct aob_piece, 3 * all->other_count + 1);
    char **heads = AOB_NEW_ARRAY(char *, all->other_count + 1),
         *path = aob_path_join(out, AOB_RUN_FOLDER_CONFLICTS);
    size_t count = 0;
    for (size_t i = 0; i < all->other_count; i++) {
        if (!all->others[i].differs)
            continue;
        heads[i] = make_head(all->others[i].source);
        pieces[count++] = (struct aob_piece){heads[i], strlen(heads[i])};
        pieces[count++] = *all->others[i].line;
        pieces[count++] = (struct aob_piece){"}\n", 2};
    }
    bool ok = !count || aob_file_write_pieces(path, pieces, count, error);
    for (size_t i = 0; i < all->other_count; i++)
        free(heads[i]);
    free(heads);
    free(pieces);
    free(path);
    return ok;
}

void aob_merge_union_finish(struct aob_merge_union *all)
{
    json_decref(all->conflicts);
    free(all->cases);
    free(all->others);
    *all = (struct aob_merge_union){0};
}
