/* The table of modelled rows, from records that were written by hand: which rows count, their sums, the pairs, what
 * cannot be run. */
#include "check.h"
#include "papers/modelled_table.h"

/* Modelled 2, 8 and 1.5 ms. Of the last the texture alone takes anything. */
static const char records[] =
    "["
    "{\"technique\": \"t\", \"params\": {\"a\": 1}, \"status\": \"ok\", \"width\": 8, \"cache\": {\"dev\": "
    "{\"modelled\": {\"passes\": [{\"name\": \"p\", \"ms\": 2, \"low_ms\": 1, \"high_ms\": 3, \"launch_ms\": "
    "0,"
    " \"resources\": {\"alu\": 1, \"texture\": 0.5}}]}}}},"
    "{\"technique\": \"t\", \"params\": {\"a\": 2}, \"status\": \"ok\", \"width\": 8, \"cache\": {\"dev\": "
    "{\"modelled\": {\"passes\": [{\"name\": \"p\", \"ms\": 8, \"low_ms\": 4, \"high_ms\": 9, \"launch_ms\": "
    "0,"
    " \"resources\": {\"alu\": 4, \"texture\": 2}}]}}}},"
    "{\"technique\": \"t\", \"params\": {\"a\": 3}, \"status\": \"ok\", \"width\": 8, \"cache\": {\"dev\": "
    "{\"modelled\": {\"passes\": [{\"name\": \"p\", \"ms\": 1.5, \"low_ms\": 1, \"high_ms\": 2, "
    "\"launch_ms\": 0,"
    " \"resources\": {\"texture\": 1}}]}}}}]";

#define ROW(key, value, time)                                                                                \
    .name = key, .text = "text", .config = "c", .width = 8, .technique = "t", .values = "a=" value,          \
    .profile = "dev", .ms = (time), .low = (time)-0.5, .high = (time) + 0.5, .setup = "stub"

static const struct aob_modelled_row rows[] = {
    {ROW("x-one", "1", 1)},                    /* ratio 2 */
    {ROW("x-two", "2", 16)},                   /* ratio .5 */
    {ROW("x-three", "3", 1), .open = "a | b"}, /* 1.5, and does not count */
    {ROW("x-gone", "4", 1)},
    {.name = "y-none", .text = "text", .setup = "", .open = "the text prints no time"},
    {0},
};
/* In the text 16, modelled 4; in the text 1, modelled 1.33 and .75, of which the second is a quarter off. */
static const struct aob_modelled_pair pairs[] = {
    {"x-two", "x-one"}, {"x-one", "x-three"}, {"x-three", "x-one"}, {"x-gone", "x-one"}, {0}};

static struct aob_modelled_table make(bool quick, const char *filter)
{
    const struct aob_papers_desc desc = {.quick = quick};
    struct aob_paper_runs runs = {
        .desc = &desc, .out = "/nowhere", .ran = json_pack("{s:o}", "c", json_loads(records, 0, NULL))};
    struct aob_modelled_table table;
    aob_modelled_table_init(&table, &(struct aob_modelled_table_desc){rows, pairs, &runs, filter});
    json_decref(runs.ran);
    return table;
}

static double number(const json_t *document, const char *object, const char *name)
{
    const json_t *value = json_object_get(json_object_get(document, object), name);
    assert_true(json_is_number(value));
    return json_number_value(value);
}

static void test_rows(void **state)
{
    (void)state;
    struct aob_modelled_table table = make(false, NULL);
    const json_t *all = json_object_get(table.document, "rows");
    static const bool counted[] = {true, true, false, false, false};
    assert_int_equal(json_array_size(all), 5);
    for (size_t i = 0; i < 5; i++)
        assert_int_equal(json_is_true(json_object_get(json_array_get(all, i), "counted")), counted[i]);
    assert_near(json_number_value(json_object_get(json_array_get(all, 1), "ratio")), 0.5, 1e-12);
    assert_true(json_is_null(json_object_get(json_array_get(all, 3), "ratio")));
    assert_contains(json_string_value(json_object_get(json_array_get(all, 3), "reason")), "no such case");
    assert_int_equal(table.failed, 1); /* a row that runs nothing has not failed */
    assert_contains(table.text.data,
                    "| x-two | text | dev | 16 [15.5, 16.5] | 8 [4, 9] | 0.50 | alu | stub |  |");
    assert_contains(table.text.data, "| stub | a \\| b |");
    aob_modelled_table_finish(&table);
}

static void test_sums(void **state)
{
    (void)state;
    struct aob_modelled_table table = make(false, NULL);
    const json_t *alone = json_object_get(table.document, "alone");
    assert_near(number(table.document, "counted", "rows"), 2, 0);
    assert_near(number(table.document, "counted", "mean"), 1, 1e-12);
    assert_near(number(table.document, "counted", "within_2x"), 1, 1e-12);
    assert_near(number(table.document, "all", "rows"), 3, 0);
    assert_near(number(table.document, "all", "mean"), 1.1447142, 1e-6); /* the third root of 1.5 */
    assert_near(number(alone, "alu", "mean"), 0.5, 1e-6);                /* 1 of 1, 4 of 16 */
    assert_near(number(alone, "texture", "mean"), 0.25, 1e-6);           /* .5 of 1, 2 of 16 */
    assert_near(number(alone, "memory", "rows"), 0, 0);
    assert_contains(table.text.data,
                    "| the rows that count | 2 | 1.00 | x2.67 | 100 % |"); /* exp(sqrt(2) ln 2) */
    aob_modelled_table_finish(&table);
}

static void test_pairs(void **state)
{
    (void)state;
    struct aob_modelled_table table = make(false, NULL);
    assert_int_equal(json_array_size(json_object_get(table.document, "pairs")), 3);
    assert_contains(table.text.data, "| x-two / x-one | 16.00 | 4.00 | -75 % |");
    assert_contains(table.text.data, "| x-one / x-three | 1.00 | 1.33 | +33 % |");
    assert_contains(table.text.data, "\n1 of 3 lie within 25 % of the text's.\n");
    assert_near(json_number_value(json_object_get(table.document, "pairs_within")), 1.0 / 3, 1e-12);
    aob_modelled_table_finish(&table);
}

static void test_parts_of_it(void **state)
{
    (void)state;
    struct aob_modelled_table table = make(true, NULL);
    assert_contains(table.text.data, "This was a look");
    assert_null(json_object_get(table.document, "counted"));
    assert_null(json_object_get(table.document, "pairs_within"));
    assert_null(strstr(table.text.data, "geometric mean"));
    aob_modelled_table_finish(&table);
    table = make(false, "y-");
    assert_int_equal(json_array_size(json_object_get(table.document, "rows")), 1);
    assert_null(strstr(table.text.data, "geometric mean"));
    assert_null(strstr(table.text.data, "variants on one device"));
    aob_modelled_table_finish(&table);
    table = make(false, "nothing");
    assert_int_equal(table.text.size, 0);
    aob_modelled_table_finish(&table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_rows), cmocka_unit_test(test_sums),
                                       cmocka_unit_test(test_pairs), cmocka_unit_test(test_parts_of_it)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
