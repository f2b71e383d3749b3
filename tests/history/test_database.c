/* Files that are no good history: one line each, and the file stays as it was to the byte. */
#include <errno.h>
#include <sys/resource.h>
#include "base/memory.h"
#include "history_file.h"

static void test_no_database(void **state)
{
    (void)state;
    put("key,series\r\n", 12);
    check_refused("is not a history (no SQLite file): name another file", false);
    put("SQLite format 3", 16); /* and nothing behind it */
    check_refused("is the SQLite file of another program", false);
}

static void test_other_application(void **state)
{
    (void)state;
    alter("CREATE TABLE point(line, night)");
    check_refused("is the SQLite file of another program, no history", false);
}

static void test_newer(void **state)
{
    (void)state;
    make_history();
    alter("PRAGMA user_version = 3");
    check_refused("made by a newer aobudget (version 3; this one reads up to 1): use that one", false);
}

static void test_cut_short(void **state)
{
    (void)state;
    make_history();
    size_t size;
    char *bytes = aob_file_read(path, 1 << 26, &size, &error);
    for (size_t cut = size - 1; cut > 100; cut /= 3) {
        put(bytes, cut);
        check_refused("the history is cut short", false);
    }
    free(bytes);
}

static void test_missing_table(void **state)
{
    (void)state;
    make_history();
    alter("DROP TABLE rounds");
    check_refused("the history is damaged (tables are missing): take its last copy", false);
}

/* A page of the points is overwritten: who would write is refused; who reads meets it. */
static void test_damaged_page(void **state)
{
    (void)state;
    size_t size;
    make_history();
    char *bytes = aob_file_read(path, 1 << 26, &size, &error);
    sqlite3 *db = NULL;
    sqlite3_stmt *root = NULL;
    sqlite3_open(path, &db);
    sqlite3_prepare_v2(db, "SELECT rootpage FROM sqlite_schema WHERE name = 'point'", -1, &root, NULL);
    assert_int_equal(sqlite3_step(root), SQLITE_ROW);
    size_t page = (size_t)sqlite3_column_int(root, 0);
    sqlite3_finalize(root);
    sqlite3_close(db);
    memset(bytes + (page - 1) * 4096, 0x5a, 4096);
    put(bytes, size);
    check_refused("the history is damaged", true);
    struct aob_lines lines;
    struct aob_history *history = history_open(AOB_HISTORY_READ);
    assert_false(aob_lines_read(history, &(struct aob_lines_ask){0}, &lines, &error));
    assert_contains(error.text, "the history is damaged");
    assert_int_equal(lines.count, 0);
    error = (struct aob_error){{0}};
    assert_false(aob_lines_read(history, &(struct aob_lines_ask){0}, &lines, &error)); /* and again */
    assert_contains(error.text, "the history is damaged");
    aob_history_close(history);
    free(bytes);
}

static void test_not_there(void **state)
{
    (void)state;
    assert_null(aob_history_open(path, AOB_HISTORY_READ, &error));
    assert_contains(error.text, "there is no such history");
    assert_false(aob_file_exists(path));
    char *lost = aob_path_join(place, "lost/h.db");
    assert_null(aob_history_open(lost, AOB_HISTORY_WRITE, &error));
    assert_contains(error.text, "cannot be made: the folder");
    assert_contains(error.text, "is not there: create it");
    free(lost);
    assert_null(aob_history_open(place, AOB_HISTORY_WRITE, &error));
    assert_contains(error.text, "is no file: name the file of a history");
}

/* What a kill in the first moment leaves, and what SQLite calls a database: to be written it is as good as none. */
static void test_empty(void **state)
{
    (void)state;
    put("", 0);
    assert_null(aob_history_open(path, AOB_HISTORY_READ, &error));
    assert_contains(error.text, "is empty: no night was ever kept in it");
    make_history();
    aob_history_close(history_open(AOB_HISTORY_READ));
}

/* Runs `body` in a child that the rights of files hold for, whoever runs the test; 0 is good. */
static int run_as_user(int (*body)(void))
{
    int status = 0;
    pid_t child = fork();
    if (!child) {
        if (geteuid() == 0 && setuid(65534) != 0)
            _exit(99);
        _exit(body());
    }
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static int body_reads_but_does_not_write(void)
{
    struct aob_lines lines = {0};
    struct aob_history *history = aob_history_open(path, AOB_HISTORY_READ, &error);
    if (!history || !aob_lines_read(history, &(struct aob_lines_ask){.figures = 1}, &lines, &error)) {
        fprintf(stderr, "%s\n", error.text);
        return 1;
    }
    int wrong = lines.count == 3 && lines.items[0].count == 2 ? 0 : 2;
    aob_lines_finish(&lines);
    aob_history_close(history);
    history = aob_history_open(path, AOB_HISTORY_WRITE, &error);
    if (!history && strstr(error.text, "cannot be written: Permission denied"))
        return wrong;
    fprintf(stderr, "%s\n", error.text);
    return 3;
}

static void test_read_only(void **state)
{
    (void)state;
    make_history();
    assert_int_equal(chmod(path, 0444), 0);
    assert_int_equal(chmod(place, 0777), 0);
    assert_int_equal(run_as_user(body_reads_but_does_not_write), 0); /* the file */
    assert_int_equal(chmod(path, 0666), 0);
    assert_int_equal(chmod(place, 0555), 0);
    assert_int_equal(run_as_user(body_reads_but_does_not_write), 0); /* its folder */
    assert_int_equal(chmod(path, 0444), 0);
    assert_int_equal(run_as_user(body_reads_but_does_not_write),
                     0); /* both, as on a medium that is read only */
}

static int body_is_told_of_the_log(void)
{
    if (!aob_history_open(path, AOB_HISTORY_READ, &error) &&
        strstr(error.text, "-wal, and cannot be worked in here: copy both"))
        return 0;
    return fprintf(stderr, "%s\n", error.text), 1;
}

/* A writer was killed, and nobody may work in what it left in the log. */
static void test_log_on_a_read_only_medium(void **state)
{
    (void)state;
    make_history();
    kill_writer("PRAGMA user_version = 1; UPDATE point SET ratio = 7");
    char *shared = aob_alloc(strlen(path) + 5, 1);
    sprintf(shared, "%s-shm", path);
    assert_int_equal(unlink(shared), 0);
    free(shared);
    assert_int_equal(chmod(place, 0555), 0);
    assert_int_equal(run_as_user(body_is_told_of_the_log), 0);
    assert_int_equal(chmod(place, 0755), 0);
    struct aob_lines lines;
    struct aob_history *history = history_open(AOB_HISTORY_READ);
    assert_true(aob_lines_read(history, &(struct aob_lines_ask){0}, &lines, &error));
    assert_near(lines.items[0].points[0].ratio, 7, 0);
    aob_lines_finish(&lines);
    aob_history_close(history);
}

/* A writer that is open keeps its log: who may not write reads it none the less, and sees what was kept last. */
static void test_read_only_beside_a_writer(void **state)
{
    (void)state;
    run_write(3, 2);
    struct aob_history *history = history_open(AOB_HISTORY_WRITE);
    night_keep(history, "nightly", true);
    night_keep(history, "nightly", true);
    char *shared = aob_alloc(strlen(path) + 5, 1);
    sprintf(shared, "%s-shm", path);
    assert_int_equal(chmod(shared, 0444), 0);
    sprintf(shared, "%s-wal", path);
    assert_int_equal(chmod(shared, 0444), 0);
    assert_int_equal(chmod(path, 0444), 0);
    assert_int_equal(chmod(place, 0555), 0);
    int code = run_as_user(body_reads_but_does_not_write);
    assert_int_equal(chmod(place, 0755), 0);
    aob_history_close(history);
    free(shared);
    assert_int_equal(code, 0);
}

/* The files may not grow, as on a full disk: what was under way is taken back. */
static int body_meets_a_limit(void)
{
    struct aob_history *history = aob_history_open(path, AOB_HISTORY_WRITE, &error);
    const struct aob_night_desc desc = {.name = "nightly", .config_hash = "c", .folder = folder};
    int64_t night = history ? aob_night_begin(history, &desc, &error) : 0;
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &(struct rlimit){1 << 16, RLIM_INFINITY});
    bool taken = !night || aob_night_take(history, night, NULL, &error);
    setrlimit(RLIMIT_FSIZE, &(struct rlimit){RLIM_INFINITY, RLIM_INFINITY});
    if (taken || !strstr(error.text, "File too large"))
        return fprintf(stderr, "%s\n", error.text), 1;
    struct aob_nights nights = {0};
    size_t lines = 0, points = 0;
    bool ok = aob_nights_read(history, NULL, &nights, &error) && nights.count == 3 &&
              nights.items[2].cases == 0 && nights.items[1].cases == 3 &&
              aob_lines_count(history, NULL, &lines, &points, &error) && points == 6;
    aob_nights_finish(&nights);
    ok = ok && aob_night_take(history, night, NULL, &error);
    aob_history_close(history);
    return ok ? 0 : 2;
}

static void test_full_disk(void **state)
{
    (void)state;
    int status;
    make_history();
    run_write(3000, 2); /* more than SQLite holds in memory, so that it fails in the middle */
    pid_t child = fork();
    if (!child)
        _exit(body_meets_a_limit());
    waitpid(child, &status, 0);
    assert_int_equal(status, 0);
}

/* SQLite takes a transaction back by itself when the disk is full in its midst, as RAISE(ROLLBACK) does: nothing that the
 * other statements do then may stay. */
static void test_taken_back(void **state)
{
    (void)state;
    size_t lines = 0, points = 0;
    make_history();
    alter("CREATE TRIGGER full BEFORE INSERT ON figures WHEN (SELECT count(*) FROM figures) = 10"
          " BEGIN SELECT RAISE(ROLLBACK, 'no room'); END");
    run_write(20, 2);
    struct aob_history *history = history_open(AOB_HISTORY_WRITE);
    const struct aob_night_desc desc = {.name = "nightly", .config_hash = "c", .folder = folder};
    int64_t night = aob_night_begin(history, &desc, &error);
    assert_false(aob_night_take(history, night, NULL, &error));
    assert_contains(error.text, "no room");
    assert_true(aob_lines_count(history, NULL, &lines, &points, &error));
    assert_int_equal(lines, 3);
    assert_int_equal(points, 6);
    aob_history_close(history);
    alter("DROP TRIGGER full");
    history = history_open(AOB_HISTORY_WRITE);
    assert_true(aob_night_take(history, night, &points, &error));
    assert_int_equal(points, 20);
    aob_history_close(history);
}

#define TEST(test) cmocka_unit_test_setup_teardown(test, night_folder_make, night_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_no_database),
        TEST(test_other_application),
        TEST(test_newer),
        TEST(test_cut_short),
        TEST(test_missing_table),
        TEST(test_damaged_page),
        TEST(test_not_there),
        TEST(test_empty),
        TEST(test_read_only),
        TEST(test_read_only_beside_a_writer),
        TEST(test_log_on_a_read_only_medium),
        TEST(test_full_disk),
        TEST(test_taken_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
