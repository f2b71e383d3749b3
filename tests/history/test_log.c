/* A history beside the log of a writer that was killed: a reader changes neither, and a file whose end is lost is refused. */
#include "history_file.h"

enum { PAGE = 4096, LOG_HEAD = 32, FRAME_HEAD = 24 };

static void test_newer_in_the_log(void **state)
{
    (void)state;
    make_history();
    kill_writer("PRAGMA user_version = 4");
    check_refused("made by a newer aobudget (version 4; this one reads up to 1)", false);
}

/* A small change lies in the log, and the file lost its end: the last page, some, and nearly all. */
static void test_cut_short_beside_a_log(void **state)
{
    (void)state;
    make_history();
    kill_writer("PRAGMA wal_autocheckpoint = 0; UPDATE night SET summary = 'x'");
    size_t size;
    char *bytes = aob_file_read(path, 1 << 26, &size, &error);
    const size_t cuts[] = {size - 1, size - PAGE, size / 20 * 19, PAGE};
    for (size_t i = 0; i < sizeof cuts / sizeof *cuts; i++) {
        put(bytes, cuts[i]);
        check_refused("the history is cut short", false);
        assert_int_equal(aob_file_size(path), cuts[i]);
    }
    put(bytes, size); /* the log is still good for the whole file */
    aob_history_close(history_open(AOB_HISTORY_WRITE));
    free(bytes);
}

/* The one ratio that all points have. */
static void check_ratio(enum aob_history_use use, size_t points, double ratio)
{
    struct aob_lines lines;
    size_t count = 0;
    struct aob_history *history = history_open(use);
    assert_true(aob_lines_read(history, &(struct aob_lines_ask){.figures = 1}, &lines, &error));
    for (size_t i = 0; i < lines.count; i++)
        for (size_t k = 0; k < lines.items[i].count; k++, count++)
            assert_true(lines.items[i].points[k].ratio == ratio);
    assert_int_equal(count, points);
    aob_lines_finish(&lines);
    aob_history_close(history);
}

/* It reads what lies in the log, and leaves both files as they are to who writes next. */
static void test_reader_leaves_the_log(void **state)
{
    (void)state;
    make_history();
    kill_writer("UPDATE point SET ratio = 7");
    struct two_files before = files_read();
    assert_true(before.sizes[1] > LOG_HEAD);
    check_ratio(AOB_HISTORY_READ, 6, 7);
    check_ratio(AOB_HISTORY_READ, 6, 7);
    check_files(&before);
    check_ratio(AOB_HISTORY_WRITE, 6, 7);
    struct two_files after = files_read();
    assert_int_equal(after.sizes[1], 0);
    free(after.bytes[0]);
}

static uint32_t word(const char *at)
{
    const unsigned char *bytes = (const unsigned char *)at;
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

/* A writer was killed while it worked its log into the file: the first page is written, and says more than the file has. */
static struct two_files kill_amid_checkpoint(void)
{
    kill_writer("PRAGMA wal_autocheckpoint = 0; UPDATE point SET ratio = 7;"
                "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 400)"
                "INSERT INTO class(text, machine, clock) SELECT printf('%0900d', i), '', '' FROM n");
    struct two_files files = files_read();
    const char *first = NULL;
    for (size_t at = LOG_HEAD; at + FRAME_HEAD + PAGE <= files.sizes[1]; at += FRAME_HEAD + PAGE)
        if (word(files.bytes[1] + at) == 1)
            first = files.bytes[1] + at + FRAME_HEAD;
    assert_non_null(first);
    assert_true(word(first + 28) * (size_t)PAGE > files.sizes[0]);
    memcpy(files.bytes[0], first, PAGE);
    put(files.bytes[0], files.sizes[0]);
    return files;
}

static void test_end_in_the_log(void **state)
{
    (void)state;
    make_history();
    struct two_files files = kill_amid_checkpoint();
    check_ratio(AOB_HISTORY_READ, 6, 7);
    check_files(&files);
    check_ratio(AOB_HISTORY_WRITE, 6, 7);
    check_ratio(AOB_HISTORY_READ, 6, 7);
}

/* The log's last change is not whole, since its last page lacks, or its end was not written: so it is none, and what the header
 * says is nowhere. */
static void test_end_in_half_a_log(void **state)
{
    (void)state;
    make_history();
    struct two_files files = kill_amid_checkpoint();
    char log[sizeof path + 4];
    snprintf(log, sizeof log, "%s-wal", path);
    assert_true(aob_file_write(log, files.bytes[1], files.sizes[1] - PAGE, &error));
    check_refused("the history is cut short", false);
    memset(files.bytes[1] + files.sizes[1] - PAGE - FRAME_HEAD + 4, 0, 4); /* that it ends a change */
    assert_true(aob_file_write(log, files.bytes[1], files.sizes[1], &error));
    check_refused("the history is cut short", false);
    free(files.bytes[0]);
    free(files.bytes[1]);
}

/* What lacks is in the log, and a page of the tables is damaged: the reader is told as well, and all stays. */
static void test_damaged_page_and_end_in_the_log(void **state)
{
    (void)state;
    sqlite3 *db = NULL;
    sqlite3_stmt *root = NULL;
    make_history();
    sqlite3_open(path, &db);
    sqlite3_prepare_v2(db, "SELECT rootpage FROM sqlite_schema WHERE name = 'rounds'", -1, &root, NULL);
    assert_int_equal(sqlite3_step(root), SQLITE_ROW);
    size_t page = (size_t)sqlite3_column_int(root, 0);
    sqlite3_finalize(root);
    sqlite3_close(db);
    struct two_files files = kill_amid_checkpoint();
    memset(files.bytes[0] + (page - 1) * PAGE, 0x5a, PAGE);
    put(files.bytes[0], files.sizes[0]);
    check_refused("the history is damaged", false);
    check_files(&files);
}

#define TEST(test) cmocka_unit_test_setup_teardown(test, night_folder_make, night_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_newer_in_the_log),      TEST(test_cut_short_beside_a_log),
        TEST(test_reader_leaves_the_log), TEST(test_end_in_the_log),
        TEST(test_end_in_half_a_log),     TEST(test_damaged_page_and_end_in_the_log),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
