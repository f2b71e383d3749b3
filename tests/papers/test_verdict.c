/* The rules of the verdict, on figures made by hand: what clears its bar, what misses it, what an interval leaves
 * open. */
#include <math.h>
#include "check.h"
#include "figure_between.h"
#include "papers/row.h"

#define EXACT(v)                                                                                             \
    {                                                                                                        \
        (v), (v), (v)                                                                                        \
    }

static enum aob_paper_verdict judge(double a, double b)
{
    struct aob_paper_row row = {.figures = {1, 2}, .count = 2};
    struct aob_paper_result result = {.measured = {EXACT(a), EXACT(b)}};
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

/* Of a single figure of 2: within 1.5 .. 2.5 it is reproduced, from 1 up it has the text's order. */
static void intervals(void **state)
{
    (void)state;
    static const struct {
        double low, high;
        enum aob_paper_verdict verdict;
    } rows[] = {
        {1.6, 2.4, AOB_PAPER_REPRODUCED},
        {1.5, 2.5, AOB_PAPER_REPRODUCED},
        {1.4, 1.6, AOB_PAPER_NOT_JUDGED},
        {2.4, 2.6, AOB_PAPER_NOT_JUDGED},
        {1.2, 3, AOB_PAPER_NOT_JUDGED},
        {1.2, 1.4, AOB_PAPER_SHAPE},
        {2.6, 7, AOB_PAPER_SHAPE},
        {0.9, 1.1, AOB_PAPER_NOT_JUDGED},
        {0.5, 0.9, AOB_PAPER_NOT_REPRODUCED},
        {0.5, 1, AOB_PAPER_NOT_REPRODUCED},
        {-INFINITY, INFINITY, AOB_PAPER_NOT_JUDGED},
    };
    struct aob_paper_row row = {.figures = {2}, .count = 1},
                         left_open = {.count = 1, .figures = {2}, .open = "?"};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct aob_paper_result result = {.measured = {BETWEEN(2, rows[i].low, rows[i].high)}};
        assert_int_equal(aob_paper_judge(&row, &result), rows[i].verdict);
        assert_int_equal(aob_paper_judge(&left_open, &result), AOB_PAPER_NOT_JUDGED);
    }
}

/* The order of two figures is open while their intervals meet; it is none where the text's digits leave none. */
static void order(void **state)
{
    (void)state;
    struct aob_paper_row row = {.figures = {5, 4}, .count = 2}, blurred = row;
    struct aob_paper_result apart = {.measured = {BETWEEN(3, 2.9, 3.1), BETWEEN(2, 1.9, 2.1)}},
                            meet = {.measured = {BETWEEN(3, 2, 4), BETWEEN(2, 1.5, 2.5)}},
                            wrong = {.measured = {BETWEEN(2, 1.9, 2.1), BETWEEN(2.5, 2.4, 2.6)}};
    assert_int_equal(aob_paper_judge(&row, &apart), AOB_PAPER_SHAPE);
    assert_int_equal(aob_paper_judge(&row, &meet), AOB_PAPER_NOT_JUDGED);
    assert_int_equal(aob_paper_judge(&row, &wrong), AOB_PAPER_NOT_REPRODUCED);
    blurred.rounding = 0.12; /* 5 x 0.88 < 4 x 1.12 */
    assert_int_equal(aob_paper_judge(&blurred, &wrong), AOB_PAPER_SHAPE);
    blurred.rounding = 0.1;
    assert_int_equal(aob_paper_judge(&blurred, &wrong), AOB_PAPER_NOT_REPRODUCED);
}

static void claims(void **state)
{
    (void)state;
    static const enum aob_paper_verdict wanted[3][3] = {
        /* shape: no, open, yes */
        {AOB_PAPER_NOT_REPRODUCED, AOB_PAPER_NOT_JUDGED, AOB_PAPER_SHAPE},
        {AOB_PAPER_NOT_JUDGED, AOB_PAPER_NOT_JUDGED, AOB_PAPER_NOT_JUDGED},
        {AOB_PAPER_REPRODUCED, AOB_PAPER_REPRODUCED, AOB_PAPER_REPRODUCED},
    };
    struct aob_paper_row row = {.count = 1};
    for (int holds = 0; holds < 3; holds++)
        for (int shape = 0; shape < 3; shape++) {
            struct aob_paper_result result = {.holds = (enum aob_paper_answer)holds,
                                              .shape = (enum aob_paper_answer)shape};
            assert_int_equal(aob_paper_judge(&row, &result), wanted[holds][shape]);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(figures),
        cmocka_unit_test(intervals),
        cmocka_unit_test(order),
        cmocka_unit_test(claims),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
