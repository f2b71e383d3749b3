#include <string.h>
#include "base/error.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "check.h"

static void test_parts_are_joined(void **state)
{
    (void)state;
    struct aob_text text = {0};
    aob_text_add(&text, "%s", "");
    assert_int_equal(text.size, 0);
    for (int i = 0; i < 1000; i++) {
        aob_text_add_bytes(&text, "ab", 2);
        aob_text_add(&text, "%d", i % 10);
    }
    assert_int_equal(text.size, 3000);
    assert_int_equal(strlen(text.data), 3000);
    assert_memory_equal(text.data + 2994, "ab8ab9", 7);
    aob_text_finish(&text);
    assert_null(text.data);
}

/* What fits is whole; what does not ends in dots, and nothing is written behind the array. */
static void test_lines_that_are_cut_say_so(void **state)
{
    (void)state;
    char line[9] = "????????";
    aob_line_print(line, 8, "%s", "1234567");
    assert_string_equal(line, "1234567");
    line[8] = '!';
    aob_line_print(line, 8, "%s", "12345678");
    assert_string_equal(line, "1234...");
    assert_int_equal(line[8], '!');
    struct aob_error error;
    char cause[sizeof error.text + 100];
    memset(cause, 'x', sizeof cause - 1);
    cause[sizeof cause - 1] = '\0';
    aob_fail(&error, "%s", cause);
    assert_int_equal(strlen(error.text), sizeof error.text - 1);
    assert_string_equal(error.text + sizeof error.text - 6, "xx...");
    aob_fail_in(&error, "%s", "where");
    assert_memory_equal(error.text, "where: xx", 9);
    assert_string_equal(error.text + sizeof error.text - 6, "xx...");
    aob_fail(&error, "no room");
    aob_fail_in(&error, "%s", cause);
    assert_string_equal(error.text + sizeof error.text - 15, "xx...: no room");
}

/* What stands on the right is all that a terminal is sent. Characters at the borders of UTF-8's ranges pass; what lies
 * just beyond them is bytes. */
static void test_what_may_be_shown(void **state)
{
    (void)state;
    static const struct {
        const char *given, *line, *lines;
    } rows[] = {
        {"plain ~", "plain ~", "plain ~"},
        {"\033[2J\a\177\001", "\\u001b[2J\\u0007\\u007f\\u0001", "\\u001b[2J\\u0007\\u007f\\u0001"},
        {"a\nb\r\tc", "a b  c", "a\nb  c"},
        {"\302\233m \302\237 \302\240 \303\251", "\\u009bm \\u009f \302\240 \303\251", NULL},
        {"\342\200\251\342\200\252\342\200\256\342\200\257", "\342\200\251\\u202a\\u202e\342\200\257", NULL},
        {"\342\201\245\342\201\246\342\201\251\342\201\252", "\342\201\245\\u2066\\u2069\342\201\252", NULL},
        {"\233m \377", "\\x9bm \\xff", NULL},
        {"\337\277 \340\240\200 \355\237\277 \357\277\277", "\337\277 \340\240\200 \355\237\277 \357\277\277",
         NULL},
        {"\360\220\200\200 \364\217\277\277", "\360\220\200\200 \364\217\277\277", NULL},
        {"\300\233 \301\233", "\\xc0\\x9b \\xc1\\x9b", NULL},
        {"\340\202\233", "\\xe0\\x82\\x9b", NULL},
        {"\355\240\200", "\\xed\\xa0\\x80", NULL},
        {"\360\217\277\277 \364\220\200\200", "\\xf0\\x8f\\xbf\\xbf \\xf4\\x90\\x80\\x80", NULL},
        {"\365\200\200\200", "\\xf5\\x80\\x80\\x80", NULL},
        {"\342\202", "\\xe2\\x82", NULL}, /* the text ends within a character */
        {"\342\202\033", "\\xe2\\x82\\u001b", NULL},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int lines = 0; lines < 2; lines++) {
            struct aob_text text = {0};
            const char *wanted = lines && rows[i].lines ? rows[i].lines : rows[i].line;
            aob_text_add_shown(&text, rows[i].given, strlen(rows[i].given), lines);
            assert_string_equal(text.data, wanted);
            aob_text_finish(&text);
        }
    struct aob_text text = {0};
    aob_text_add_shown(&text, "a\0b", 3, true);
    assert_string_equal(text.data, "a\\u0000b");
    aob_text_add_line(&text, "%s|%d", "\033\n", 7);
    assert_string_equal(text.data, "a\\u0000b\\u001b |7\n");
    aob_text_finish(&text);
}

/* A line goes into a record as it is, so it is always UTF-8: cut between characters, and bytes as escapes. */
static void test_a_line_is_text(void **state)
{
    (void)state;
    static const char given[] =
        "a\303\251\342\202\254\360\237\230\200z\303\251\303\251"; /* 1, 2, 3, 4, 1, 2, 2 bytes */
    static const struct {
        size_t size; /* of the array */
        const char *line;
    } rows[] = {
        {5, "a..."},
        {6, "a..."},
        {7, "a\303\251..."},
        {9, "a\303\251..."},
        {10, "a\303\251\342\202\254..."},
        {13, "a\303\251\342\202\254..."},
        {14, "a\303\251\342\202\254\360\237\230\200..."},
        {15, "a\303\251\342\202\254\360\237\230\200z..."}, /* one byte too small */
        {16, given},
    };
    char line[64];
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        memset(line, '!', sizeof line);
        aob_line_print(line, rows[i].size, "%s", given);
        assert_string_equal(line, rows[i].line);
        assert_int_equal(line[rows[i].size], '!');
    }
    struct aob_error error;
    aob_fail(&error, "'%s' is \033[1mbad", "\351t\351");
    assert_string_equal(error.text, "'\\xe9t\\xe9' is \\u001b[1mbad");
    aob_fail_in(&error, "%s", "fran\303\247ais\303");
    assert_string_equal(error.text, "fran\303\247ais\\xc3: '\\xe9t\\xe9' is \\u001b[1mbad");
    json_t *text = aob_json_text("caf\303\251 caf\351");
    assert_string_equal(json_string_value(text), "caf\303\251 caf\\xe9");
    json_decref(text);
}

/* A path gives way in its middle, between characters, so that the cause behind it stays. */
static void test_a_long_path_leaves_its_cause(void **state)
{
    (void)state;
    char path[1024] = "/", line[128], wanted[128];
    for (int i = 0; i < 400; i++)
        strcat(path, "\303\244");
    strcat(path, "/box.obj");
    for (size_t size = 110; size < 114; size++) {
        aob_line_print(line, size, "the loader: %s: it has no triangle in it", path);
        assert_true(strlen(line) >= size - 4 && strlen(line) < size);
        assert_memory_equal(line, "the loader: /\303\244", 15);
        assert_contains(line, "\303\244...\303\244");
        assert_contains(line, "\303\244/box.obj: it has no triangle in it");
    }
    memset(path, 'x', 200);
    strcpy(path + 200, "/z");
    aob_line_print(line, sizeof line, "%s: %s", path, path);
    snprintf(wanted, sizeof wanted, "%.32s...%.30s/z: ", path, path);
    assert_memory_equal(line, wanted, 30);
    assert_contains(line, "x...x");
    assert_contains(line, "x/z: x");
    struct aob_error error;
    aob_fail(&error, "no triangle");
    memset(path, 'x', 1000);
    strcpy(path + 1000, "/b.obj");
    aob_fail_in(&error, "%s", path);
    assert_string_equal(error.text + sizeof error.text - 1 - 20, "x/b.obj: no triangle");
}

static void test_a_percentage_has_its_sign(void **state)
{
    (void)state;
    static const char *const bad[] = {
        "", "%", "3", "3 %", "3%%", "3% ", "x%", "nan%", "0.000000000000000000000000000001%"};
    double share = 7;
    for (size_t i = 0; i < AOB_COUNT(bad); i++) {
        assert_false(aob_parse_percent(bad[i], &share));
        assert_true(share == 7);
    }
    assert_true(aob_parse_percent("3%", &share));
    assert_float_equal(share, 0.03, 1e-15);
    assert_true(aob_parse_percent("0.5%", &share));
    assert_float_equal(share, 0.005, 1e-15);
    assert_true(aob_parse_percent("-200%", &share)); /* bounds are the caller's */
    assert_float_equal(share, -2, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_parts_are_joined),
                                       cmocka_unit_test(test_lines_that_are_cut_say_so),
                                       cmocka_unit_test(test_what_may_be_shown),
                                       cmocka_unit_test(test_a_line_is_text),
                                       cmocka_unit_test(test_a_long_path_leaves_its_cause),
                                       cmocka_unit_test(test_a_percentage_has_its_sign)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
