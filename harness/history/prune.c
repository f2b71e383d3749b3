#include "base/file.h"
#include "database.h"
#include "night.h"

/* The ended nights that are too old: those before the `keep` latest of their config that ended with cases. One that ended with
 * nothing holds no place among these, and one that is open may be gone on with. */
#define OLD                                                                                                  \
    "(SELECT id FROM night AS old WHERE whole = 1 AND id < (SELECT id FROM night WHERE name = old.name"      \
    " AND whole = 1 AND cases > 0 ORDER BY id DESC LIMIT 1 OFFSET ?1 - 1))"

static bool run(struct aob_history *history, const char *sql, size_t keep, size_t *changes,
                struct aob_error *error)
{
    struct aob_query query;
    aob_query_begin(&query, history, sql, error);
    aob_query_whole(&query, (int64_t)keep);
    aob_query_run(&query);
    *changes += (size_t)sqlite3_changes(history->db);
    return aob_query_end(&query);
}

/* What nothing names any more goes with the nights. */
static const char sweep[] = "DELETE FROM module WHERE digest NOT IN (SELECT digest FROM measured);"
                            "DELETE FROM line WHERE id NOT IN (SELECT line FROM point);"
                            "DELETE FROM class WHERE id NOT IN (SELECT class FROM line)";

static bool remove_nights(struct aob_history *history, size_t keep, struct aob_prune *pruned,
                          struct aob_error *error)
{
    return run(history, "DELETE FROM point WHERE night IN " OLD, keep, &pruned->points, error) &&
           run(history, "DELETE FROM night WHERE id IN " OLD, keep, &pruned->nights, error) &&
           aob_database_run(history, sweep, error);
}

/* A night of which nothing was left to remove is not counted. */
static bool remove_rounds(struct aob_history *history, size_t keep, struct aob_prune *pruned,
                          struct aob_error *error)
{
    size_t files = 0;
    return run(history, "DELETE FROM journal WHERE night IN " OLD, keep, &pruned->nights, error) &&
           run(history, "DELETE FROM rounds WHERE night IN " OLD, keep, &files, error);
}

static bool shrink(struct aob_history *history, struct aob_error *error)
{
    return (aob_database_run(history, "VACUUM", error) &&
            aob_database_run(history, "PRAGMA wal_checkpoint(TRUNCATE)", error)) ||
           aob_fail_in(error, "the nights are removed, but the file could not be made smaller");
}

bool aob_nights_prune(struct aob_history *history, size_t keep, bool rounds_only, struct aob_prune *pruned,
                      struct aob_error *error)
{
    *pruned = (struct aob_prune){0};
    if (keep < 1)
        return aob_fail(error, "%s: at least one night of each config is kept", history->path);
    if (!aob_database_run(history, "PRAGMA wal_checkpoint(TRUNCATE)", error))
        return false;
    long long before = (long long)aob_file_size(history->path);
    if (!aob_database_begin(history, error))
        return false;
    bool ok = rounds_only ? remove_rounds(history, keep, pruned, error)
                          : remove_nights(history, keep, pruned, error);
    if (!aob_database_end(history, ok, error) || !shrink(history, error))
        return false;
    pruned->bytes = before - (long long)aob_file_size(history->path);
    return true;
}
