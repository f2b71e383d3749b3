#include <string.h>
#include "base/error.h"
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
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_parts_are_joined),
                                       cmocka_unit_test(test_lines_that_are_cut_say_so)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
