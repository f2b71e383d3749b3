#include "check.h"
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "store/journal.h"

static char path[256];

static int set_up(void **state)
{
    (void)state;
    snprintf(path, sizeof path, "/tmp/aobudget-journal-%ld.jsonl", (long)getpid());
    unlink(path);
    return 0;
}
static int tear_down(void **state)
{
    (void)state;
    return unlink(path);
}

static void append(struct aob_journal *journal, const char *key, int value)
{
    json_t *record = json_pack("{s:s, s:i}", "key", key, "value", value);
    assert_true(aob_journal_append(journal, record, NULL));
    json_decref(record);
}

static void test_last_line_of_a_key_stands(void **state)
{
    (void)state;
    struct aob_journal journal;
    struct aob_error error;
    assert_true(aob_journal_open(&journal, path, &error));
    append(&journal, "a", 1);
    append(&journal, "b", 2);
    append(&journal, "a", 3);
    aob_journal_close(&journal);
    json_t *records = aob_journal_read(path, NULL, &error);
    assert_int_equal(json_array_size(records), 2);
    assert_int_equal(json_integer_value(json_object_get(json_array_get(records, 0), "value")), 3);
    json_decref(records);
}

/* Cut the file at every byte: what was whole is read, the torn rest is cut off before the next line. */
static void test_torn_anywhere(void **state)
{
    (void)state;
    struct aob_journal journal;
    struct aob_error error;
    size_t size;
    assert_true(aob_journal_open(&journal, path, &error));
    append(&journal, "first", 1);
    append(&journal, "second", 2);
    aob_journal_close(&journal);
    char *whole = aob_file_read(path, 1 << 20, &size, &error);
    size_t first_line = (size_t)(strchr(whole, '\n') - whole) + 1;
    for (size_t cut = 0; cut <= size; cut++) {
        assert_true(aob_file_write(path, whole, cut, &error));
        json_t *records = aob_journal_read(path, NULL, &error);
        size_t expected = cut == size ? 2 : cut >= first_line ? 1 : 0;
        assert_int_equal(json_array_size(records), expected);
        json_decref(records);
        assert_true(aob_journal_open(&journal, path, &error));
        append(&journal, "third", 3);
        aob_journal_close(&journal);
        records = aob_journal_read(path, NULL, &error);
        assert_int_equal(json_array_size(records), expected + 1);
        json_decref(records);
    }
    free(whole);
}

static void test_one_writer(void **state)
{
    (void)state;
    struct aob_journal journal, other;
    struct aob_error error;
    assert_true(aob_journal_open(&journal, path, &error));
    assert_false(aob_journal_open(&other, path, &error));
    assert_contains(error.text, "another run");
    aob_journal_close(&journal);
    assert_true(aob_journal_open(&journal, path, &error));
    aob_journal_close(&journal);
    assert_false(aob_journal_open(&journal, "/proc/nowhere/journal.jsonl", &error));
}

/* Reads a journal of these bytes: how many records it gives, and what it tells of damage. */
static size_t read_bytes(const char *bytes, size_t size, struct aob_error *damage)
{
    struct aob_error error;
    *damage = (struct aob_error){{0}};
    assert_true(aob_file_write(path, bytes, size, &error));
    json_t *records = aob_journal_read(path, damage, &error);
    size_t count = json_array_size(records);
    json_decref(records);
    return count;
}

static void test_damaged_lines_are_told_and_passed_over(void **state)
{
    (void)state;
    static const char *const rubbish[] = {
        "{", "[1]", "{\"key\": 5}", "{\"no\": \"key\"}", "\xff\xfe", "{\"key\": \"a\", \"key\": \"b\"}"};
    static const char good[] = "{\"key\": \"good\"}\n";
    struct aob_error damage;
    char text[1024], wanted[400];
    assert_int_equal(read_bytes("\n\n", 2, &damage), 0);
    assert_string_equal(damage.text, ""); /* an empty line is nothing */
    for (size_t i = 0; i < AOB_COUNT(rubbish); i++) {
        int size = snprintf(text, sizeof text, "%s%s\n%s", good, rubbish[i], good);
        assert_int_equal(read_bytes(text, (size_t)size, &damage), 1);
        snprintf(wanted, sizeof wanted, "%s: line 2 of 3 is damaged and passed over", path);
        assert_string_equal(damage.text, wanted);
    }
    int size = snprintf(text, sizeof text, "%s{\n%s[]\n", good, good);
    assert_int_equal(read_bytes(text, (size_t)size, &damage), 1);
    snprintf(wanted, sizeof wanted, "%s: 2 of 4 lines are damaged and passed over, the first of them line 2",
             path);
    assert_string_equal(damage.text, wanted);
}

/* After a loss of power zeros may stand where a line was, or anywhere in one. Whatever they cover, all other lines
 * count, except that the last one needs its line break. A line break alone may be lost, because zeros part lines
 * too. */
static void test_zeros_cost_what_they_cover(void **state)
{
    (void)state;
    static const char whole[] = "{\"key\":\"a\"}\n{\"key\":\"b\"}\n{\"key\":\"c\"}\n";
    enum { SIZE = sizeof whole - 1, LINE = SIZE / 3 };
    struct aob_error damage;
    char text[SIZE];
    for (size_t from = 0; from < SIZE; from++)
        for (size_t to = from + 1; to <= SIZE; to++) {
            size_t expected = 0, end = to < SIZE ? SIZE : from / LINE * LINE;
            for (size_t line = 0; line < end; line += LINE)
                expected += line + LINE - 1 <= from || line >= to;
            memcpy(text, whole, SIZE);
            memset(text + from, 0, to - from);
            assert_int_equal(read_bytes(text, SIZE, &damage), expected);
            assert_int_equal(to < SIZE, *damage.text != 0);
        }
}

enum { OTHER_SIZE = sizeof path + 8 };

static void take_away(int how, const char other[OTHER_SIZE])
{
    if (how == 0)
        unlink(path);
    if (how == 1)
        rename(path, other);
    if (how == 2) {
        size_t size;
        char *text = aob_file_read(path, 4096, &size, NULL);
        assert_true(text && aob_file_write(other, text, size, NULL));
        free(text);
        rename(other, path);
    }
    if (how == 5) { /* another one in its place, and longer */
        rename(path, other);
        assert_true(aob_file_write(path, other, OTHER_SIZE, NULL));
    }
    if (how == 3 || how == 4)
        assert_int_equal(truncate(path, how == 3 ? 0 : 21), 0);
}

static void test_a_file_that_is_taken_away_is_noticed(void **state)
{
    (void)state;
    char other[OTHER_SIZE];
    snprintf(other, sizeof other, "%s.other", path);
    for (int how = 0; how < 6; how++) {
        struct aob_journal journal;
        struct aob_error error = {{0}};
        unlink(path);
        assert_true(aob_journal_open(&journal, path, &error));
        append(&journal, "a", 1);
        append(&journal, "b", 1);
        assert_true(aob_journal_check(&journal, &error));
        static const char *const told[] = {"deleted or replaced", "moved",       "deleted or replaced",
                                           "cut it from",         "cut it from", "moved"};
        take_away(how, other);
        json_t *record = json_pack("{s:s}", "key", "c");
        assert_false(aob_journal_check(&journal, &error));
        assert_contains(error.text, told[how]);
        error = (struct aob_error){{0}};
        assert_false(aob_journal_append(&journal, record, &error));
        assert_contains(error.text, told[how]);
        json_decref(record);
        aob_journal_close(&journal);
        unlink(other);
    }
    assert_true(aob_file_write(path, "", 0, NULL)); /* for tear_down */
}

/* A full disk, which a limit of the file's size stands for: the cause is named, and the line is gone. */
static void test_a_line_that_does_not_fit(void **state)
{
    (void)state;
    struct aob_journal journal;
    struct aob_error error = {{0}};
    struct rlimit before, narrow;
    size_t size, after;
    assert_true(aob_journal_open(&journal, path, &error));
    append(&journal, "first", 1);
    char *bytes = aob_file_read(path, 1 << 20, &size, &error);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    narrow = (struct rlimit){size + 9, before.rlim_max};
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &narrow), 0);
    json_t *record = json_pack("{s:s}", "key", "second");
    assert_false(aob_journal_append(&journal, record, &error));
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
    assert_contains(error.text, "cannot write: File too large");
    char *rest = aob_file_read(path, 1 << 20, &after, &error);
    assert_int_equal(after, size);
    assert_memory_equal(rest, bytes, size);
    assert_true(aob_journal_append(&journal, record, &error)); /* there is room again */
    json_t *records = aob_journal_read(path, NULL, &error);
    assert_int_equal(json_array_size(records), 2);
    json_decref(records);
    json_decref(record);
    aob_journal_close(&journal);
    free(bytes);
    free(rest);
}

/* Bytes as they stand in the file, of the line that counts, whatever is left out of the record. */
static void test_lines_as_they_stand(void **state)
{
    (void)state;
    static const char *const paths[] = {"key", NULL};
    static const char text[] = "{ \"key\":\"a\", \"value\":1}\nrubbish\n{\"value\":[2.50],\"key\":\"b\"}\n"
                               "{\"key\":\"c\"}\0{\"key\":\"a\",\"value\":3}\n{\"key\":\"torn\"}";
    static const char *const wanted[] = {"{\"key\":\"a\",\"value\":3}", "{\"value\":[2.50],\"key\":\"b\"}",
                                         "{\"key\":\"c\"}"};
    struct aob_journal_lines lines = {0};
    struct aob_error damage = {{0}}, error;
    assert_true(aob_file_write(path, text, sizeof text - 1, &error));
    json_t *records = aob_journal_read_lines(path, paths, &lines, &damage, &error);
    assert_contains(damage.text, "2 of 4 lines are damaged");
    assert_int_equal(json_array_size(records), 3);
    for (size_t i = 0; i < 3; i++) {
        assert_int_equal(lines.items[i].size, strlen(wanted[i]));
        assert_memory_equal(lines.items[i].bytes, wanted[i], lines.items[i].size);
        assert_int_equal(json_object_size(json_array_get(records, i)), 1);
    }
    json_decref(records);
    aob_journal_lines_finish(&lines);
}

/* Who holds a journal keeps writers out, and other holders not; a writer keeps holders out. */
static void test_held(void **state)
{
    (void)state;
    struct aob_journal writer, first, second;
    struct aob_error error;
    assert_false(aob_journal_hold(&first, path, &error));
    assert_contains(error.text, "cannot open");
    assert_true(aob_journal_open(&writer, path, &error));
    assert_false(aob_journal_hold(&first, path, &error));
    assert_contains(error.text, "a run is writing here");
    aob_journal_close(&writer);
    assert_true(aob_journal_hold(&first, path, &error));
    assert_true(aob_journal_hold(&second, path, &error));
    assert_false(aob_journal_open(&writer, path, &error));
    aob_journal_close(&first);
    aob_journal_close(&second);
    assert_true(aob_journal_open(&writer, path, &error));
    aob_journal_close(&writer);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_last_line_of_a_key_stands, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_torn_anywhere, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_one_writer, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_damaged_lines_are_told_and_passed_over, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_zeros_cost_what_they_cover, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_file_that_is_taken_away_is_noticed, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_line_that_does_not_fit, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_lines_as_they_stand, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_held, set_up, tear_down)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
