/* Damaged captures: none brings the harness down, and none is loaded wrongly. The bench runs ten times as many. */
#include "damaged_captures.h"

static void test_damaged_captures(void **state)
{
    (void)state;
    struct damaged_counts counts = {0};
    damaged_captures(36, 1, &counts);
    damaged_print("captures", &counts);
    assert_int_equal(counts.faults, 0);
    printf("%zu files, %zu load: %zu alike for both readers, %zu as before the damage\n",
           damaged_totals.files, damaged_totals.loaded, damaged_totals.alike, damaged_totals.mended);
    assert_int_equal(damaged_totals.other, 0);
    assert_int_equal(damaged_totals.crashes, 0);
    assert_true(damaged_totals.alike > damaged_totals.files / 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_damaged_captures)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
