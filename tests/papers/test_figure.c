/* Figures with their intervals: how they are reckoned with, and how they are found in the records of a run. */
#include <math.h>
#include "check.h"
#include "figure_between.h"
#include "papers/row.h"

/* By numbers that were worked out apart: the widest that the two intervals allow. */
static void arithmetic(void **state)
{
    (void)state;
    const struct aob_paper_figure a = BETWEEN(3, 2, 4), b = BETWEEN(2, 1, 5), around = BETWEEN(1, -2, 3);
    const struct {
        struct aob_paper_figure got, wanted;
    } rows[] = {
        {aob_paper_sum(a, b), BETWEEN(5, 3, 9)},
        {aob_paper_difference(a, b), BETWEEN(1, -3, 3)},
        {aob_paper_quotient(a, b), BETWEEN(1.5, 0.4, 4)},
        {aob_paper_quotient(around, b), BETWEEN(0.5, -2, 3)},
        {aob_paper_quotient(a, around), BETWEEN(3, -INFINITY, INFINITY)},
        {aob_paper_scaled(a, -2), BETWEEN(-6, -8, -4)},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        assert_true(rows[i].got.value == rows[i].wanted.value);
        assert_true(rows[i].got.low == rows[i].wanted.low);
        assert_true(rows[i].got.high == rows[i].wanted.high);
    }
    assert_int_equal(aob_paper_above(a, 1.9), AOB_PAPER_YES);
    assert_int_equal(aob_paper_above(a, 3), AOB_PAPER_OPEN);
    assert_int_equal(aob_paper_above(a, 4), AOB_PAPER_NO);
    assert_int_equal(aob_paper_below(a, 4.1), AOB_PAPER_YES);
    assert_int_equal(aob_paper_below(a, 3), AOB_PAPER_OPEN);
    assert_int_equal(aob_paper_below(a, 2), AOB_PAPER_NO);
}

static void records(void **state)
{
    (void)state;
    json_t *all = json_loads(
        "[{\"technique\":\"t\",\"params\":{\"a\":1e-6,\"b\":\"on\"},\"options\":{},\"camera\":{\"eye\":[0,1."
        "5,2]},\"status\":\"ok\",\"time\":{\"ratio_to_ref\":5.5,\"ci_low\":5.0,\"ci_high\":6.0,\"passes\":["
        "{\"name\":\"ao\",\"ratio_to_ref\":3.0,\"ci_low\":2.5,\"ci_high\":3.25},"
        "{\"name\":\"blur_x1\",\"ratio_to_ref\":0.5,\"ci_low\":0.25,\"ci_high\":0.75},"
        "{\"name\":\"blur_y1\",\"ratio_to_ref\":1.5,\"ci_low\":null,\"ci_high\":null}]}},"
        "{\"technique\":\"t\",\"params\":{\"a\":2,\"b\":\"on\"},"
        "\"options\":{},\"status\":\"failed\",\"reason\":\"broke\"}]",
        0, NULL);
    struct aob_paper_run run = {.records = all};
    struct aob_error error = {{0}};
    const json_t *found = aob_paper_find(&run, "t", "a=1e-6 b=on", &error);
    assert_non_null(found);
    struct aob_paper_figure ao = aob_paper_cost(found, "ao"), blur = aob_paper_cost(found, "blur"),
                            frame = aob_paper_cost(found, NULL);
    assert_true(ao.value == 3 && ao.low == 2.5 && ao.high == 3.25);
    assert_true(blur.value == 2 && blur.low == -INFINITY && blur.high == INFINITY); /* too few rounds */
    assert_true(frame.value == 5.5 && frame.low == 5 && frame.high == 6);
    assert_ptr_equal(aob_paper_find(&run, "t", "eye=0,1.5,2", &error), found);
    assert_null(aob_paper_find(&run, "t", "eye=0,1.5,3", &error));
    assert_null(aob_paper_find(&run, "t", "eye=0,1.5", &error));
    assert_null(aob_paper_find(&run, "t", "eye=0,1.5,2,1", &error));
    error.text[0] = '\0';
    assert_null(aob_paper_find(&run, "t", "a=2", &error));
    assert_non_null(strstr(error.text, "broke"));
    assert_null(aob_paper_find(&run, "t", "a=3", &error));
    assert_non_null(strstr(error.text, "no such case"));
    json_decref(all);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arithmetic),
        cmocka_unit_test(records),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
