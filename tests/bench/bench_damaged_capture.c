/* Five thousand damaged captures, a row each of what became of them: `NAME VALUE UNIT`. */
#include "gbuffer/damaged_captures.h"

static void run(void **state)
{
    (void)state;
    damaged_captures(358, 99);
    fprintf(stderr, "damaged_captures %zu files\n", damaged_totals.files);
    fprintf(stderr, "damaged_captures_loaded %zu files\n", damaged_totals.loaded);
    fprintf(stderr, "damaged_captures_alike %zu files\n", damaged_totals.alike);
    fprintf(stderr, "damaged_captures_mended %zu files\n", damaged_totals.mended);
    fprintf(stderr, "damaged_captures_other %zu files\n", damaged_totals.other);
    fprintf(stderr, "damaged_captures_crashes %zu files\n", damaged_totals.crashes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(run)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
