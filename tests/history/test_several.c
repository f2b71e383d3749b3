/* Several programs at one history, and one that is killed. */
#include <signal.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <time.h>
#include "night_folder.h"

static void wait_for(pid_t child)
{
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 0);
}

/* How many points there are, and as many cases as its one night says it has. */
static size_t count_points(void)
{
    struct aob_nights nights = {0};
    size_t lines = 0, points = 0;
    struct aob_history *history = history_open(AOB_HISTORY_READ);
    assert_true(aob_nights_read(history, NULL, &nights, &error));
    assert_true(aob_lines_count(history, NULL, &lines, &points, &error));
    assert_int_equal(nights.items[0].cases, points);
    aob_nights_finish(&nights);
    aob_history_close(history);
    return points;
}

static void check_whole(void)
{
    sqlite3 *db = NULL;
    sqlite3_stmt *check = NULL;
    sqlite3_open(path, &db);
    sqlite3_prepare_v2(db, "PRAGMA integrity_check", -1, &check, NULL);
    assert_int_equal(sqlite3_step(check), SQLITE_ROW);
    assert_string_equal((const char *)sqlite3_column_text(check, 0), "ok");
    sqlite3_finalize(check);
    sqlite3_close(db);
}

/* Killed after ever longer times, a taking night holds what it held before or all of the new one. */
static void test_killed(void **state)
{
    (void)state;
    enum { OLD = 3, NEW = 400 };
    struct aob_history *history = history_open(AOB_HISTORY_WRITE);
    run_write(OLD, 2);
    int64_t night = night_keep(history, "nightly", false);
    aob_history_close(history);
    run_write(NEW, 3);
    int before = 0, done = 0;
    for (long us = 500; done < 2 && us < 30000000; us += us / 2) {
        pid_t child = fork();
        if (!child) {
            history = aob_history_open(path, AOB_HISTORY_WRITE, NULL);
            _exit(history && aob_night_take(history, night, NULL, NULL) ? 0 : 1);
        }
        nanosleep(&(struct timespec){us / 1000000, us % 1000000 * 1000}, NULL);
        kill(child, SIGKILL);
        waitpid(child, NULL, 0);
        size_t points = count_points();
        if (points != OLD && points != NEW)
            fail_msg("killed after %ld us, it holds %zu points", us, points);
        before += points == OLD;
        done += points == NEW;
        check_whole();
    }
    assert_true(before > 0);
    assert_int_equal(done, 2);
    history = history_open(AOB_HISTORY_WRITE);
    assert_true(aob_night_take(history, night, NULL, &error));
    aob_history_close(history);
}

/* Nights of two programs at once: both are whole, and their cases share their lines. */
static void test_two_writers(void **state)
{
    (void)state;
    enum { NIGHTS = 8 };
    run_write(20, 2);
    pid_t children[2];
    for (int i = 0; i < 2; i++) {
        children[i] = fork();
        if (!children[i]) {
            struct aob_history *own = aob_history_open(path, AOB_HISTORY_WRITE, &error);
            for (int n = 0; own && n < NIGHTS; n++)
                night_keep(own, i ? "weekly" : "nightly", true);
            aob_history_close(own);
            _exit(own ? 0 : 1);
        }
    }
    for (int i = 0; i < 2; i++)
        wait_for(children[i]);
    struct aob_lines lines = {0};
    struct aob_history *history = history_open(AOB_HISTORY_READ);
    assert_true(aob_lines_read(history, &(struct aob_lines_ask){.config = "nightly"}, &lines, &error));
    assert_int_equal(lines.count, 20);
    for (size_t i = 0; i < lines.count; i++)
        assert_int_equal(lines.items[i].count, NIGHTS);
    aob_lines_finish(&lines);
    assert_true(aob_lines_read(history, &(struct aob_lines_ask){0}, &lines, &error));
    assert_int_equal(lines.count, 40);
    aob_lines_finish(&lines);
    aob_history_close(history);
    check_whole();
}

/* A connection of the test's own, in the middle of its writing. */
static sqlite3 *begin_foreign(void)
{
    sqlite3 *db = NULL;
    assert_int_equal(sqlite3_open(path, &db), SQLITE_OK);
    assert_int_equal(sqlite3_exec(db, "BEGIN IMMEDIATE; UPDATE point SET ratio = 99", NULL, NULL, NULL),
                     SQLITE_OK);
    return db;
}

static void test_reader_beside_a_writer(void **state)
{
    (void)state;
    struct aob_lines lines = {0};
    struct aob_history *history = history_open(AOB_HISTORY_WRITE);
    run_write(3, 2);
    night_keep(history, "nightly", true);
    aob_history_close(history);
    sqlite3 *db = begin_foreign();
    history = history_open(AOB_HISTORY_READ);
    assert_true(aob_lines_read(history, &(struct aob_lines_ask){0}, &lines, &error));
    assert_near(lines.items[0].points[0].ratio, 2, 0);
    aob_lines_finish(&lines);
    assert_int_equal(sqlite3_exec(db, "COMMIT", NULL, NULL, NULL), SQLITE_OK);
    assert_true(aob_lines_read(history, &(struct aob_lines_ask){0}, &lines, &error));
    assert_near(lines.items[0].points[0].ratio, 99, 0);
    aob_lines_finish(&lines);
    assert_int_equal(
        aob_night_begin(history, &(struct aob_night_desc){.name = "x", .folder = folder}, &error), 0);
    assert_contains(error.text, "the history is open for reading only");
    aob_history_close(history);
    sqlite3_close(db);
}

/* It waits AOB_HISTORY_WAIT_S, and says so. */
static void test_held(void **state)
{
    (void)state;
    struct aob_history *history = history_open(AOB_HISTORY_WRITE);
    run_write(3, 2);
    night_keep(history, "nightly", true);
    aob_history_close(history);
    sqlite3 *db = begin_foreign();
    assert_null(aob_history_open(path, AOB_HISTORY_WRITE, &error));
    assert_contains(error.text, "another program writes to this history (waited 10 s): try again later");
    sqlite3_close(db);
    aob_history_close(history_open(AOB_HISTORY_WRITE));
}

#define TEST(test) cmocka_unit_test_setup_teardown(test, night_folder_make, night_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_killed),
        TEST(test_two_writers),
        TEST(test_reader_beside_a_writer),
        TEST(test_held),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
