#include "database.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

/* SQLite tells the cause of some faults only, and leaves errno as the system set it: so that is cleared before each call. */
static bool fail_io(struct aob_history *history, struct aob_error *error)
{
    int cause = sqlite3_system_errno(history->db) ? sqlite3_system_errno(history->db) : errno;
    bool reading = sqlite3_extended_errcode(history->db) == SQLITE_IOERR_READ ||
                   sqlite3_extended_errcode(history->db) == SQLITE_IOERR_SHORT_READ;
    const char *what = sqlite3_errcode(history->db) == SQLITE_CANTOPEN ? "opened"
                       : reading                                       ? "read"
                                                                       : "written";
    return aob_fail(error, "%s: cannot be %s: %s", history->path, what,
                    cause ? strerror(cause) : sqlite3_errmsg(history->db));
}

bool aob_database_fail(struct aob_history *history, struct aob_error *error)
{
    switch (sqlite3_errcode(history->db)) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return aob_fail(error, "%s: another program writes to this history (waited %g s): try again later",
                        history->path, AOB_HISTORY_WAIT_S);
    case SQLITE_FULL:
        return aob_fail(error,
                        "%s: the disk is full; what was under way is taken back: make room and try again",
                        history->path);
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
        return aob_fail(error, "%s: the history is damaged (%s): take its last copy", history->path,
                        sqlite3_errmsg(history->db));
    case SQLITE_IOERR:
    case SQLITE_CANTOPEN:
        return fail_io(history, error);
    default:
        return aob_fail(error, "%s: %s", history->path, sqlite3_errmsg(history->db));
    }
}

bool aob_database_run(struct aob_history *history, const char *sql, struct aob_error *error)
{
    errno = 0;
    return sqlite3_exec(history->db, sql, NULL, NULL, NULL) == SQLITE_OK || aob_database_fail(history, error);
}

bool aob_database_begin(struct aob_history *history, struct aob_error *error)
{
    if (!history->writes)
        return aob_fail(error, "%s: the history is open for reading only", history->path);
    history->failed = false;
    history->changing = aob_database_run(history, "BEGIN IMMEDIATE", error);
    return history->changing;
}

bool aob_database_end(struct aob_history *history, bool ok, struct aob_error *error)
{
    ok = ok && !history->failed && aob_database_run(history, "COMMIT", error);
    history->changing = false;
    if (ok)
        return true;
    if (!sqlite3_get_autocommit(history->db)) /* some failures have taken it back by themselves */
        sqlite3_exec(history->db, "ROLLBACK", NULL, NULL, NULL);
    return false;
}

/* The first line stands. */
static void judge(struct aob_query *query, int code)
{
    if (query->failed || code == SQLITE_OK)
        return;
    query->failed = query->history->failed = true;
    aob_database_fail(query->history, query->error);
}

void aob_query_begin(struct aob_query *query, struct aob_history *history, const char *sql,
                     struct aob_error *error)
{
    *query = (struct aob_query){.history = history, .error = error};
    judge(query, sqlite3_prepare_v2(history->db, sql, -1, &query->statement, NULL));
}

void aob_query_text(struct aob_query *query, const char *text)
{
    if (!query->failed)
        judge(query, sqlite3_bind_text(query->statement, ++query->bound, text, -1, SQLITE_STATIC));
}

void aob_query_number(struct aob_query *query, double value)
{
    if (!query->failed)
        judge(query, sqlite3_bind_double(query->statement, ++query->bound, value));
}

void aob_query_whole(struct aob_query *query, int64_t value)
{
    if (!query->failed)
        judge(query, sqlite3_bind_int64(query->statement, ++query->bound, value));
}

void aob_query_bytes(struct aob_query *query, const void *bytes, size_t size)
{
    if (!query->failed)
        judge(query, sqlite3_bind_blob64(query->statement, ++query->bound, bytes, size, SQLITE_STATIC));
}

bool aob_query_step(struct aob_query *query)
{
    query->failed = query->failed || (query->history->changing && query->history->failed);
    if (query->failed)
        return false;
    errno = 0;
    int code = sqlite3_step(query->statement);
    if (code == SQLITE_ROW)
        return true;
    judge(query, code == SQLITE_DONE ? SQLITE_OK : code);
    return false;
}

void aob_query_reset(struct aob_query *query)
{
    query->bound = 0;
    if (query->failed)
        return;
    sqlite3_reset(query->statement); /* the step has said already what was wrong */
    sqlite3_clear_bindings(query->statement);
}

bool aob_query_run(struct aob_query *query)
{
    aob_query_step(query);
    aob_query_reset(query);
    return !query->failed;
}

bool aob_query_end(struct aob_query *query)
{
    sqlite3_finalize(query->statement);
    query->statement = NULL;
    return !query->failed;
}

static const char *get_text(const struct aob_query *query, int column)
{
    const unsigned char *text = sqlite3_column_text(query->statement, column);
    return text ? (const char *)text : "";
}

char *aob_query_copy(const struct aob_query *query, int column)
{
    return aob_strdup(get_text(query, column));
}

double aob_query_get_number(const struct aob_query *query, int column)
{
    return sqlite3_column_type(query->statement, column) == SQLITE_NULL
               ? NAN
               : sqlite3_column_double(query->statement, column);
}

int64_t aob_query_get_whole(const struct aob_query *query, int column)
{
    return sqlite3_column_int64(query->statement, column);
}

void aob_query_get_text(const struct aob_query *query, int column, char *text, size_t size)
{
    snprintf(text, size, "%s", get_text(query, column));
}
