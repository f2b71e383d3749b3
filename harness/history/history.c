#include "history.h"
#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "database.h"
#include "header.h"
#include "schema.h"

static char *folder_of(const char *path)
{
    char *copy = aob_strdup(path), *folder = aob_strdup(dirname(copy));
    free(copy);
    return folder;
}

/* By the rights that files are opened with. */
static bool may_write(const char *path)
{
    return faccessat(AT_FDCWD, path, W_OK, AT_EACCESS) == 0;
}

/* Whether locks and log cannot be put beside the file. */
static bool is_shut(const char *path)
{
    char *folder = folder_of(path);
    bool shut = !may_write(path) || !may_write(folder);
    free(folder);
    return shut;
}

/* The log of changes lies beside the file, so its folder must be writable as well. */
static bool check_writable(const char *path, bool there, struct aob_error *error)
{
    char *folder = folder_of(path);
    bool ok = true;
    if (there && !may_write(path))
        ok = aob_fail(error, "%s: the history cannot be written: %s", path, strerror(errno));
    else if (!may_write(folder))
        ok = aob_fail(error,
                      errno == ENOENT ? "%s: cannot be made: the folder %s is not there: create it"
                                      : "%s: the folder %s of the history cannot be written: %s",
                      path, folder, strerror(errno));
    free(folder);
    return ok;
}

/* The path as SQLite's URI: letters that would mean something there are written as %XX. */
static char *uri_of(const char *path, const char *options)
{
    char *whole = aob_path_absolute(path);
    struct aob_text uri = {0};
    aob_text_add(&uri, "file:");
    for (const char *c = whole; *c; c++)
        aob_text_add(&uri, strchr("%?#", *c) ? "%%%02X" : "%c", (unsigned char)*c);
    aob_text_add(&uri, "%s", options);
    free(whole);
    return uri.data;
}

/* A reader takes part in the locks where it can, since others may write meanwhile. Where it cannot, because file or folder are
 * not to be written, nobody else writes there either, unless a log lies beside. */
static bool connect(struct aob_history *history, bool alone, struct aob_error *error)
{
    int flags = (alone ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE) |
                (history->writes ? SQLITE_OPEN_CREATE : 0) | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX;
    char *uri = uri_of(history->path, alone && !aob_header_has_log(history->path) ? "?immutable=1" : "");
    bool ok = sqlite3_open_v2(uri, &history->db, flags, NULL) == SQLITE_OK;
    free(uri);
    if (!ok)
        return aob_database_fail(history, error);
    sqlite3_busy_timeout(history->db, (int)(1000 * AOB_HISTORY_WAIT_S));
    return aob_database_run(history,
                            history->writes ? "PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON"
                                            : "PRAGMA query_only = ON",
                            error);
}

static bool ask_number(struct aob_history *history, const char *sql, int64_t *number, struct aob_error *error)
{
    struct aob_query query;
    aob_query_begin(&query, history, sql, error);
    *number = aob_query_step(&query) ? aob_query_get_whole(&query, 0) : 0;
    return aob_query_end(&query);
}

/* Of two programs that find no file, the second one finds the tables of the first. */
static bool make_tables(struct aob_history *history, struct aob_error *error)
{
    int64_t version;
    bool ok = aob_database_begin(history, error) &&
              ask_number(history, "PRAGMA user_version", &version, error) &&
              (version || aob_database_run(history, aob_history_schema, error));
    return aob_database_end(history, ok, error);
}

static bool has_tables(struct aob_history *history, struct aob_error *error)
{
    static const char sql[] = "SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name IN ('class', "
                              "'night', 'line', 'point',"
                              " 'figures', 'journal', 'run', 'rounds', 'module', 'measured')";
    int64_t tables, version;
    if (!ask_number(history, "PRAGMA user_version", &version, error) ||
        !ask_number(history, sql, &tables, error))
        return false;
    if (version > AOB_HISTORY_VERSION) /* the change may lie in the log */
        return aob_fail(error,
                        "%s: made by a newer aobudget (version %lld; this one reads up to %d): use that one",
                        history->path, (long long)version, AOB_HISTORY_VERSION);
    return tables == 10 ||
           aob_fail(error, "%s: the history is damaged (tables are missing): take its last copy",
                    history->path);
}

static bool check_pages(struct aob_history *history, const char *check, struct aob_error *error)
{
    struct aob_query query;
    aob_query_begin(&query, history, check, error);
    char *said = aob_query_step(&query) ? aob_query_copy(&query, 0) : aob_strdup("ok");
    bool ok = aob_query_end(&query) &&
              (strcmp(said, "ok") == 0 ||
               aob_fail(error, "%s: the history is damaged (%s): take its last copy", history->path, said));
    free(said);
    return ok;
}

/* Every page of the tables that decide where a point goes. Those of figures, rounds and modules are ten times as many: they
 * are judged where they are read, unless the end of the file lies in the log. */
static bool check_tables(struct aob_history *history, bool all, struct aob_error *error)
{
    static const char *const checks[] = {"PRAGMA quick_check(class)", "PRAGMA quick_check(night)",
                                         "PRAGMA quick_check(line)", "PRAGMA quick_check(point)"};
    bool ok = true;
    if (all)
        return check_pages(history, "PRAGMA quick_check", error);
    for (size_t i = 0; i < AOB_COUNT(checks) && ok; i++)
        ok = check_pages(history, checks[i], error);
    return ok;
}

static bool judge(struct aob_history *history, enum aob_header header, struct aob_error *error)
{
    bool is_short = header == AOB_HEADER_SHORT;
    if (!has_tables(history, error) ||
        ((history->writes || is_short) && !check_tables(history, is_short, error)))
        return false;
    return !history->writes || (aob_database_run(history, "PRAGMA journal_mode = WAL", error) &&
                                aob_database_begin(history, error) && aob_database_end(history, true, error));
}

static bool refuse_missing(const char *path, enum aob_header header, struct aob_error *error)
{
    if (header == AOB_HEADER_NONE)
        return aob_fail(error, "%s: there is no such history", path);
    return aob_fail(error, "%s: is empty: no night was ever kept in it", path);
}

/* What is closed last works its log into the file, and removes it: only who writes a good history may do that. */
static void keep_log(struct aob_history *history, bool keep)
{
    sqlite3_db_config(history->db, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, (int)keep, NULL);
}

static bool open_and_judge(struct aob_history *history, enum aob_header header, struct aob_error *error)
{
    bool log = aob_header_has_log(history->path), alone = !history->writes && is_shut(history->path),
         there = header >= AOB_HEADER_GOOD, ok = connect(history, alone, error);
    keep_log(history, log);
    ok = ok && (there || make_tables(history, error)) && judge(history, header, error);
    if (ok && history->writes)
        keep_log(history, false);
    if (!ok && alone && log && sqlite3_errcode(history->db) == SQLITE_CANTOPEN)
        aob_fail(error,
                 "%s: what a stopped program changed last lies in %s-wal, and cannot be worked in here: copy "
                 "both to "
                 "a folder that can be written",
                 history->path, history->path);
    return ok;
}

struct aob_history *aob_history_open(const char *path, enum aob_history_use use, struct aob_error *error)
{
    bool writes = use == AOB_HISTORY_WRITE;
    enum aob_header header = aob_header_judge(path, error);
    bool there = header >= AOB_HEADER_GOOD;
    if (header == AOB_HEADER_BAD || (!there && !writes && !refuse_missing(path, header, error)) ||
        (writes && !check_writable(path, header != AOB_HEADER_NONE, error)))
        return NULL;
    struct aob_history *history = AOB_NEW(struct aob_history);
    *history = (struct aob_history){.path = aob_strdup(path), .writes = writes};
    if (open_and_judge(history, header, error))
        return history;
    aob_history_close(history);
    return NULL;
}

void aob_history_close(struct aob_history *history)
{
    if (!history)
        return;
    sqlite3_close(history->db);
    free(history->path);
    free(history);
}
