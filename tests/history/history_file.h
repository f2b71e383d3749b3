/* For tests that alter the file of a history, and look at it and at its log to the byte. */
#ifndef AOB_TESTS_HISTORY_HISTORY_FILE_H
#define AOB_TESTS_HISTORY_HISTORY_FILE_H
#include <signal.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include "night_folder.h"

/* A history of two nights, closed. */
static inline void make_history(void)
{
    struct aob_history *history = history_open(AOB_HISTORY_WRITE);
    run_write(3, 2);
    night_keep(history, "nightly", true);
    night_keep(history, "nightly", true);
    aob_history_close(history);
}

/* SQL by a connection of the test's own. */
static inline void alter(const char *sql)
{
    sqlite3 *db = NULL;
    assert_int_equal(sqlite3_open(path, &db), SQLITE_OK);
    assert_int_equal(sqlite3_exec(db, sql, NULL, NULL, NULL), SQLITE_OK);
    assert_int_equal(sqlite3_close(db), SQLITE_OK);
}

/* The file and its log, byte for byte. */
struct two_files {
    char *bytes[2];
    size_t sizes[2];
};

static inline struct two_files files_read(void)
{
    struct two_files files = {{0}, {0}};
    char log[sizeof path + 4];
    snprintf(log, sizeof log, "%s-wal", path);
    files.bytes[0] = aob_file_read(path, 1 << 26, &files.sizes[0], &error);
    assert_non_null(files.bytes[0]);
    if (aob_file_exists(log))
        files.bytes[1] = aob_file_read(log, 1 << 26, &files.sizes[1], &error);
    return files;
}

/* They are still as they were; frees what was read. */
static inline void check_files(struct two_files *before)
{
    struct two_files after = files_read();
    for (int i = 0; i < 2; i++) {
        assert_int_equal(before->sizes[i], after.sizes[i]);
        if (before->sizes[i])
            assert_memory_equal(before->bytes[i], after.bytes[i], before->sizes[i]);
        free(before->bytes[i]);
        free(after.bytes[i]);
    }
}

/* Both uses refuse it with a line that says `says`, and change nothing. */
static inline void check_refused(const char *says, bool write_only)
{
    struct two_files before = files_read();
    for (int use = write_only ? AOB_HISTORY_WRITE : AOB_HISTORY_READ; use <= AOB_HISTORY_WRITE; use++) {
        error = (struct aob_error){{0}};
        struct aob_history *history = aob_history_open(path, (enum aob_history_use)use, &error);
        if (history)
            fail_msg("it was opened, and should say %s", says);
        assert_contains(error.text, says);
        assert_contains(error.text, path);
        assert_null(strchr(error.text, '\n'));
    }
    check_files(&before);
}

static inline void put(const char *bytes, size_t size)
{
    assert_true(aob_file_write(path, bytes, size, &error));
}

/* What a writer that was killed leaves in the log, and not yet in the file. */
static inline void kill_writer(const char *sql)
{
    int status;
    pid_t child = fork();
    if (!child) {
        sqlite3 *db = NULL;
        sqlite3_open(path, &db);
        sqlite3_exec(db, sql, NULL, NULL, NULL);
        raise(SIGKILL);
    }
    waitpid(child, &status, 0);
}
#endif
