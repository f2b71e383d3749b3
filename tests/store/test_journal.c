#include "check.h"
#include <fcntl.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>
#include "base/file.h"
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
    json_t *records = aob_journal_read(path, &error);
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
        json_t *records = aob_journal_read(path, &error);
        size_t expected = cut == size ? 2 : cut >= first_line ? 1 : 0;
        assert_int_equal(json_array_size(records), expected);
        json_decref(records);
        assert_true(aob_journal_open(&journal, path, &error));
        append(&journal, "third", 3);
        aob_journal_close(&journal);
        records = aob_journal_read(path, &error);
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

static void test_rubbish_lines_are_passed_over(void **state)
{
    (void)state;
    static const char text[] = "\n{\n[1]\n{\"key\": 5}\n{\"no\": \"key\"}\n\xff\xfe\n{\"key\": \"a\", "
                               "\"key\": \"b\"}\n{\"key\": \"good\"}\n";
    struct aob_error error;
    assert_true(aob_file_write(path, text, sizeof text - 1, &error));
    json_t *records = aob_journal_read(path, &error);
    assert_int_equal(json_array_size(records), 1);
    json_decref(records);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_last_line_of_a_key_stands, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_torn_anywhere, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_one_writer, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_rubbish_lines_are_passed_over, set_up, tear_down)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
