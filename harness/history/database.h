/* The SQLite file behind a history, for the files of this room: statements with bound values, transactions, and one line
 * for whatever SQLite says. Threads: one a history. */
#ifndef AOB_HISTORY_DATABASE_H
#define AOB_HISTORY_DATABASE_H
#include <sqlite3.h>
#include <stdint.h>
#include "history.h"

struct aob_history {
    sqlite3 *db;
    char *path;
    bool writes;
    bool changing; /* between aob_database_begin and aob_database_end */
    bool failed;   /* meanwhile, a statement: the others do nothing any more */
};

/* Writes the line for what SQLite said last: what is wrong with the file, and what to do. Always false. */
bool aob_database_fail(struct aob_history *history, struct aob_error *error);

/* Runs constant SQL whose rows nobody reads. */
bool aob_database_run(struct aob_history *history, const char *sql, struct aob_error *error);

/* What a transaction's changes are made in. Begun with the lock of a writer, for which another one is waited
 * AOB_HISTORY_WAIT_S; a history that was opened for reading only is refused by a line. aob_database_end keeps the changes if
 * `ok`, else takes all of them back; false then, too. After a full disk, among others, SQLite takes the transaction back by
 * itself, and would keep what each statement does behind it: so after the first failure none runs any more. */
bool aob_database_begin(struct aob_history *history, struct aob_error *error);
bool aob_database_end(struct aob_history *history, bool ok, struct aob_error *error);

/* A statement in use. After the first failure, its own or another one's of the transaction, it does nothing: so only its end
 * is asked. */
struct aob_query {
    struct aob_history *history;
    sqlite3_stmt *statement;
    struct aob_error *error;
    int bound;   /* values so far */
    bool failed; /* `error` has the line */
};
void aob_query_begin(struct aob_query *query, struct aob_history *history, const char *sql,
                     struct aob_error *error);
/* Each binds the next value. Texts and bytes are borrowed until the statement is stepped; NULL is NULL. NAN becomes NULL. */
void aob_query_text(struct aob_query *query, const char *text);
void aob_query_number(struct aob_query *query, double value);
void aob_query_whole(struct aob_query *query, int64_t value);
void aob_query_bytes(struct aob_query *query, const void *bytes, size_t size);

/* The next row; false at their end and after a failure. */
bool aob_query_step(struct aob_query *query);
/* Makes the statement as it was before its first value, to be used again. */
void aob_query_reset(struct aob_query *query);
/* Runs a statement without rows to its end and resets it. */
bool aob_query_run(struct aob_query *query);
bool aob_query_end(struct aob_query *query); /* frees; false if anything failed */

/* A column of the row, from 0. A text of NULL is "", a number NAN. The copy is the caller's to free. */
char *aob_query_copy(const struct aob_query *query, int column);
double aob_query_get_number(const struct aob_query *query, int column);
int64_t aob_query_get_whole(const struct aob_query *query, int column);
/* Into an array of `size` bytes, cut to fit. */
void aob_query_get_text(const struct aob_query *query, int column, char *text, size_t size);
#endif
