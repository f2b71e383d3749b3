#include "take.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/member.h"
#include "base/memory.h"
#include "pack.h"
#include "store/journal.h"

static bool find_night(struct aob_taking *taking, struct aob_error *error)
{
    struct aob_query query;
    aob_query_begin(&query, taking->history, "SELECT folder, name, whole FROM night WHERE id = ?", error);
    aob_query_whole(&query, taking->night);
    bool whole = false, there = aob_query_step(&query);
    if (there) {
        taking->folder = aob_query_copy(&query, 0);
        taking->config = aob_query_copy(&query, 1);
        whole = aob_query_get_whole(&query, 2) != 0;
    }
    if (!aob_query_end(&query))
        return false;
    if (!there)
        return aob_fail(error, "%s: has no night %lld", taking->history->path, (long long)taking->night);
    return !whole || aob_fail(error, "%s: night %lld has ended: begin another one", taking->history->path,
                              (long long)taking->night);
}

/* A journal may also hold cases of an earlier state of the modules, which the run does not have any more. */
static json_t *keep_planned(json_t *records, const json_t *info)
{
    json_t *list = json_object_get(info, "keys"), *keys = json_object(), *kept = json_array(), *item;
    size_t i;
    json_array_foreach(list, i, item)
    {
        if (json_is_string(item))
            json_object_set_new(keys, json_string_value(item), json_true());
    }
    json_array_foreach(records, i, item)
    {
        if (!json_is_array(list) || json_object_get(keys, aob_member_text(item, "key")))
            json_array_append(kept, item);
    }
    json_decref(keys);
    json_decref(records);
    return kept;
}

/* What is looked at of a record: parsing the rest would take most of the time. */
static const char *const needed[] = {
    "key",
    "series",
    "scene",
    "view",
    "metre",
    "technique",
    "module",
    "params",
    "options",
    "backend",
    "width",
    "height",
    "light.name",
    "status",
    "reason",
    "fingerprint",
    "memory_bytes",
    "image_digest",
    "reference_radius",
    "error",
    "time.clock",
    "time.threads",
    "time.cpu_ms",
    "time.wall_ms",
    "time.device_ms",
    "time.ratio_to_ref",
    "time.ci_low",
    "time.ci_high",
    "time.ref_ms",
    "time.rounds_file",
    "cache.*.frame.levels",
    NULL,
};

/* None is good, as beside a journal of an old program. One that cannot be read would be taken for none: all records would count
 * as planned, and no build would be known. */
static bool read_info(struct aob_taking *taking, struct aob_error *error)
{
    json_error_t why = {.line = 0};
    char *path = aob_path_join(taking->folder, "run.json");
    bool there = aob_file_exists(path);
    taking->info = there ? json_load_file(path, 0, &why) : NULL;
    bool ok = !there || json_is_object(taking->info) ||
              aob_fail(error,
                       "%s: is damaged (%s): run the config into its folder again, or remove this file to "
                       "keep the journal alone",
                       path, taking->info ? "no object" : why.text);
    free(path);
    return ok;
}

static bool read_folder(struct aob_taking *taking, struct aob_error *error)
{
    char *journal = aob_path_join(taking->folder, "journal.jsonl");
    bool there = aob_file_exists(journal);
    bool ok = read_info(taking, error) &&
              (taking->info || there ||
               aob_fail(error, "%s: is not the folder of a run: it has no journal.jsonl", taking->folder));
    if (ok && there)
        ok =
            (taking->journal = aob_file_read(journal, (size_t)1 << 30, &taking->journal_size, error)) != NULL;
    struct aob_error damage = {{0}};
    json_t *records = ok ? aob_journal_read_only(journal, needed, &damage, error) : NULL;
    if (*damage.text)
        aob_warn("%s", damage.text);
    if (records)
        taking->records = keep_planned(records, taking->info);
    free(journal);
    return taking->records != NULL;
}

bool aob_taking_read(struct aob_taking *taking, struct aob_error *error)
{
    return find_night(taking, error) && read_folder(taking, error);
}

void aob_taking_finish(struct aob_taking *taking)
{
    free(taking->folder);
    free(taking->config);
    free(taking->journal);
    json_decref(taking->info);
    json_decref(taking->records);
}

static bool run_with_night(struct aob_taking *taking, const char *sql, struct aob_error *error)
{
    struct aob_query query;
    aob_query_begin(&query, taking->history, sql, error);
    aob_query_whole(&query, taking->night);
    aob_query_run(&query);
    return aob_query_end(&query);
}

/* What it held so far is replaced. */
static bool clear(struct aob_taking *taking, struct aob_error *error)
{
    return run_with_night(taking, "DELETE FROM point WHERE night = ?", error) &&
           run_with_night(taking, "DELETE FROM rounds WHERE night = ?", error) &&
           run_with_night(taking, "DELETE FROM measured WHERE night = ?", error) &&
           run_with_night(taking, "DELETE FROM journal WHERE night = ?", error) &&
           run_with_night(taking, "DELETE FROM run WHERE night = ?", error);
}

static bool take_journal(struct aob_taking *taking, struct aob_error *error)
{
    struct aob_query query;
    size_t size = taking->journal_size;
    char *packed = aob_pack("journal.jsonl", taking->journal ? taking->journal : "", &size, error);
    if (!packed)
        return false;
    aob_query_begin(&query, taking->history, "INSERT INTO journal VALUES(?, ?, ?)", error);
    aob_query_whole(&query, taking->night);
    aob_query_whole(&query, (int64_t)taking->journal_size);
    aob_query_bytes(&query, packed, size);
    aob_query_run(&query);
    free(packed);
    return aob_query_end(&query);
}

static bool take_info(struct aob_taking *taking, struct aob_error *error)
{
    struct aob_query query;
    char *text = taking->info ? json_dumps(taking->info, JSON_REAL_PRECISION(9)) : NULL;
    if (!text)
        return true;
    aob_query_begin(&query, taking->history, "INSERT INTO run VALUES(?, ?)", error);
    aob_query_whole(&query, taking->night);
    aob_query_text(&query, text);
    aob_query_run(&query);
    free(text);
    return aob_query_end(&query);
}

static bool take_sums(struct aob_taking *taking, size_t *points, struct aob_error *error)
{
    struct aob_query query;
    aob_query_begin(&query, taking->history,
                    "UPDATE night SET build = ?, cases = (SELECT count(*) FROM point WHERE night = night.id),"
                    " ok = (SELECT count(*) FROM point WHERE night = night.id AND status = 'ok')"
                    " WHERE id = ? RETURNING cases",
                    error);
    aob_query_text(&query, aob_member_text(taking->info, "build"));
    aob_query_whole(&query, taking->night);
    *points = aob_query_step(&query) ? (size_t)aob_query_get_whole(&query, 0) : 0;
    return aob_query_end(&query);
}

bool aob_night_take(struct aob_history *history, int64_t night, size_t *taken, struct aob_error *error)
{
    struct aob_taking taking = {.history = history, .night = night};
    size_t points = 0;
    if (!aob_database_begin(history, error))
        return false;
    bool ok = aob_taking_read(&taking, error) && clear(&taking, error) && take_journal(&taking, error) &&
              take_info(&taking, error) && aob_take_points(&taking, error) &&
              aob_take_rounds(&taking, error) && aob_take_modules(&taking, error) &&
              take_sums(&taking, &points, error);
    ok = aob_database_end(history, ok, error);
    if (ok && taken)
        *taken = points;
    aob_taking_finish(&taking);
    return ok;
}
