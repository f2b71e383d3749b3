#include "tell.h"
#include "base/error.h"
#include "base/member.h"

enum { SHOWN = 10 }; /* of each kind of warning */

void aob_merge_told_init(struct aob_merge_told *told)
{
    *told = (struct aob_merge_told){.name = json_null(),
                                    .out = json_array(),
                                    .conflicts = json_array(),
                                    .lost = json_array(),
                                    .apart = json_array()};
}

static json_t *folders_of(const struct aob_merge_set *set)
{
    json_t *folders = json_array();
    for (size_t i = 0; i < set->count; i++)
        json_array_append_new(folders, json_string(set->sources[i]->path));
    return folders;
}

void aob_merge_told_take(struct aob_merge_told *told, const struct aob_merge_set *set, const json_t *info,
                         const struct aob_merge_union *all, const struct aob_merge_files *files)
{
    size_t at, cases = 0;
    const json_t *key;
    for (size_t i = 0; i < all->count; i++)
        cases += all->cases[i].source != NULL;
    json_array_foreach(json_object_get(info, "keys"), at, key) /* the plan's come first in the union */
    {
        aob_table_put(&told->planned, json_string_value(key), told->planned.count);
        if (all->cases[at].source)
            aob_table_put(&told->found, json_string_value(key), told->found.count);
    }
    json_decref(told->name);
    told->name = json_incref(json_object_get(info, "name"));
    told->cases += cases;
    told->dropped += all->dropped;
    json_array_extend(told->conflicts, all->conflicts);
    json_array_extend(told->lost, files->lost);
    json_array_extend(told->apart, files->apart);
    json_array_append_new(told->out, json_pack("{s:s, s:o, s:I, s:I, s:I}", "folder", set->out, "folders",
                                               folders_of(set), "cases", (json_int_t)cases, "missing",
                                               (json_int_t)all->missing, "files", (json_int_t)files->copied));
}

static const char *folder_at(const json_t *entry, size_t at)
{
    return json_string_value(json_array_get(json_object_get(entry, "folders"), at));
}

static void tell_conflict(const json_t *c)
{
    aob_warn("%s has another %s in %s than in %s, which stands (case %s); the other is kept in %s",
             aob_member_text(c, "case"), aob_member_text(c, "differs"), folder_at(c, 1), folder_at(c, 0),
             aob_member_text(c, "key"), aob_member_text(c, "kept"));
}

static void tell_lost(const json_t *lost)
{
    aob_warn("%s; `run` on the merged folder measures its cases again", aob_member_text(lost, "reason"));
}

static void tell_apart(const json_t *apart)
{
    const char *becomes = json_string_value(json_object_get(apart, "becomes"));
    aob_warn("%s has other bytes in %s than in %s, %s%s", aob_member_text(apart, "file"), folder_at(apart, 1),
             folder_at(apart, 0), becomes ? "and is kept as " : "which stand", becomes ? becomes : "");
}

static void tell_some(const json_t *list, void (*tell)(const json_t *entry))
{
    size_t count = json_array_size(list);
    for (size_t i = 0; i < count && i < SHOWN; i++)
        tell(json_array_get(list, i));
    if (count > SHOWN)
        aob_warn("and %zu more of these; --json lists all of them", count - SHOWN);
}

static size_t missing(const struct aob_merge_told *told)
{
    return told->planned.count - told->found.count;
}

bool aob_merge_told_tell(const struct aob_merge_told *told)
{
    size_t lacking = missing(told);
    tell_some(told->conflicts, tell_conflict);
    tell_some(told->lost, tell_lost);
    tell_some(told->apart, tell_apart);
    if (lacking)
        aob_warn("%zu of %zu cases of the plan are in none of the folders", lacking, told->planned.count);
    return !lacking && !json_array_size(told->conflicts) && !json_array_size(told->lost) &&
           !json_array_size(told->apart);
}

json_t *aob_merge_told_to_json(const struct aob_merge_told *told, const char *const *folders, size_t count)
{
    json_t *given = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(given, json_string(folders[i]));
    return json_pack("{s:O, s:o, s:O, s:I, s:I, s:O, s:O, s:O, s:I, s:I}", "name", told->name, "folders",
                     given, "out", told->out, "cases", (json_int_t)told->cases, "dropped",
                     (json_int_t)told->dropped, "conflicts", told->conflicts, "lost", told->lost, "apart",
                     told->apart, "planned", (json_int_t)told->planned.count, "missing",
                     (json_int_t)missing(told));
}

void aob_merge_told_finish(struct aob_merge_told *told)
{
    json_decref(told->name);
    json_decref(told->out);
    json_decref(told->conflicts);
    json_decref(told->lost);
    json_decref(told->apart);
    aob_table_finish(&told->planned);
    aob_table_finish(&told->found);
    *told = (struct aob_merge_told){0};
}
