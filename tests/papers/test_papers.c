/* The rules of the verdict, on figures and journals made by hand. */
#include "check.h"
#include "papers/row.h"

static enum aob_paper_verdict judge(double a, double b)
{
    struct aob_paper_row row = {.figures = {1, 2}, .count = 2};
    struct aob_paper_result result = {.measured = {a, b}};
    return aob_paper_judge(&row, &result);
}

static void figures(void **state)
{
    (void)state;
    assert_int_equal(judge(1, 2.49), AOB_PAPER_REPRODUCED);
    assert_int_equal(judge(1, 1.51), AOB_PAPER_REPRODUCED);
    assert_int_equal(judge(1, 2.51), AOB_PAPER_SHAPE);
    assert_int_equal(judge(1, 1.2), AOB_PAPER_SHAPE);
    assert_int_equal(judge(1, 0.9), AOB_PAPER_NOT_REPRODUCED);
}

static void one_figure_and_none(void **state)
{
    (void)state;
    struct aob_paper_row row = {.figures = {2}, .count = 1}, shape = {.count = 1};
    struct aob_paper_result more = {.measured = {1.2}}, less = {.measured = {0.8}, .holds = true},
                            most = {.measured = {5.1}}, partly = {.shape = true};
    assert_int_equal(aob_paper_judge(&row, &more), AOB_PAPER_SHAPE);
    assert_int_equal(aob_paper_judge(&row, &less), AOB_PAPER_NOT_REPRODUCED);
    assert_int_equal(aob_paper_judge(&row, &most), AOB_PAPER_NOT_REPRODUCED);
    assert_int_equal(aob_paper_judge(&shape, &partly), AOB_PAPER_SHAPE);
    assert_int_equal(aob_paper_judge(&shape, &less), AOB_PAPER_REPRODUCED);
    assert_int_equal(aob_paper_judge(&shape, &more), AOB_PAPER_NOT_REPRODUCED);
}

static void records(void **state)
{
    (void)state;
    json_t *all = json_loads(
        "[{\"technique\":\"t\",\"params\":{\"a\":1e-6,\"b\":\"on\"},\"options\":{},\"camera\":{\"eye\":[0,1."
        "5,2]},\"status\":\"ok\","
        "\"time\":"
        "{\"ref_cpu_ms\":2.0,\"passes\":[{\"name\":\"ao\",\"cpu_ms\":6.0},{\"name\":\"blur_x1\",\"cpu_ms\":1."
        "0},"
        "{\"name\":\"blur_y1\",\"cpu_ms\":3.0}]}},{\"technique\":\"t\",\"params\":{\"a\":2,\"b\":\"on\"},"
        "\"options\":{},\"status\":\"failed\",\"reason\":\"broke\"}]",
        0, NULL);
    struct aob_paper_run run = {.records = all};
    struct aob_error error = {{0}};
    const json_t *found = aob_paper_find(&run, "t", "a=1e-6 b=on", &error);
    assert_non_null(found);
    assert_float_equal(aob_paper_cost(found, "ao"), 3, 1e-12);
    assert_float_equal(aob_paper_cost(found, "blur"), 2, 1e-12);
    assert_float_equal(aob_paper_cost(found, NULL), 5, 1e-12);
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

/* A row that may fail to be reproduced must be able to say why. */
static void rows_have_reasons(void **state)
{
    (void)state;
    for (const struct aob_paper_row *row = aob_paper_rows; row->name; row++) {
        assert_non_null(row->why);
        assert_true((row->config != NULL) == (row->measure != NULL));
        assert_true((row->config != NULL) == (row->count > 0));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(figures), cmocka_unit_test(one_figure_and_none),
                                       cmocka_unit_test(records), cmocka_unit_test(rows_have_reasons)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
