#include "check.h"
#include "base/table.h"

static void test_first_number_stays(void **state)
{
    (void)state;
    struct aob_table table = {0};
    size_t number = 99;
    assert_false(aob_table_find(&table, "a", &number));
    assert_int_equal(aob_table_put(&table, "a", 7), 7);
    assert_int_equal(aob_table_put(&table, "a", 8), 7);
    assert_int_equal(aob_table_put(&table, "", 9), 9);
    assert_false(aob_table_find(&table, "b", &number));
    assert_int_equal(number, 99);
    assert_true(aob_table_find(&table, "", &number));
    assert_int_equal(number, 9);
    assert_true(aob_table_find(&table, "a", NULL));
    assert_int_equal(table.count, 2);
    aob_table_finish(&table);
    assert_false(aob_table_find(&table, "a", &number));
}

/* The caller's text may change or go: the table has its own. */
static void test_texts_are_copied(void **state)
{
    (void)state;
    struct aob_table table = {0};
    char text[] = "one";
    size_t number;
    aob_table_put(&table, text, 1);
    text[0] = 'O';
    assert_true(aob_table_find(&table, "one", &number));
    assert_false(aob_table_find(&table, "One", &number));
    aob_table_finish(&table);
}

/* Through several growths every text keeps its own number, and none that was not put is found. */
static void test_many(void **state)
{
    (void)state;
    struct aob_table table = {0};
    char text[32];
    size_t number;
    for (size_t i = 0; i < 5000; i++) {
        snprintf(text, sizeof text, "text %zu", i);
        assert_int_equal(aob_table_put(&table, text, i), i);
    }
    assert_int_equal(table.count, 5000);
    for (size_t i = 0; i < 10000; i++) {
        snprintf(text, sizeof text, "text %zu", i);
        assert_int_equal(aob_table_find(&table, text, &number), i < 5000);
        if (i < 5000)
            assert_int_equal(number, i);
    }
    aob_table_finish(&table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_first_number_stays),
        cmocka_unit_test(test_texts_are_copied),
        cmocka_unit_test(test_many),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
