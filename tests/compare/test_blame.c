#include "check.h"
#include "compare/blame.h"

static struct aob_blame_couple couple(enum aob_verdict verdict, double ratio, bool same_build)
{
    return (struct aob_blame_couple){{ratio, ratio * 0.99, ratio * 1.01, true}, verdict, 0.02, same_build};
}

/* Everything is 10 % dearer, the old modules too: the new one is not to blame. One that is dearer than that is. */
static void test_all_moved(void **state)
{
    (void)state;
    struct aob_blame blames[5];
    const struct aob_blame_couple couples[] = {
        couple(AOB_VERDICT_SLOWER, 1.10, true), couple(AOB_VERDICT_SLOWER, 1.09, true),
        couple(AOB_VERDICT_SLOWER, 1.115, false), couple(AOB_VERDICT_SLOWER, 1.2, false),
        couple(AOB_VERDICT_SLOWER, 1.12, true)};
    aob_blame_find(couples, 5, true, blames);
    assert_contains(blames[0].text, "the machine is to blame");
    assert_true(blames[0].excused && blames[1].excused && blames[2].excused && blames[4].excused);
    assert_contains(blames[2].text, "3 cases");
    assert_contains(blames[2].text, "x 1.100");
    assert_contains(blames[2].text, "not the module");
    assert_false(blames[3].excused);
    assert_string_equal(blames[3].text, "");
    aob_blame_find(couples, 5, false, blames);
    assert_contains(blames[0].text, "machine or the harness");
    assert_false(blames[0].excused); /* the programs are what is compared */
}

/* The controls stayed where they were, or there are none: a slower module is slower. */
static void test_module(void **state)
{
    (void)state;
    struct aob_blame blames[3];
    const struct aob_blame_couple couples[] = {couple(AOB_VERDICT_SAME, 1.005, true),
                                               couple(AOB_VERDICT_SLOWER, 1.1, false),
                                               couple(AOB_VERDICT_FASTER, 0.9, false)};
    aob_blame_find(couples, 3, true, blames);
    for (int i = 0; i < 3; i++)
        assert_true(!*blames[i].text && !blames[i].excused);
    aob_blame_find(couples + 1, 2, true, blames);
    assert_true(!*blames[0].text && !*blames[1].text);
}

/* What became faster beside controls that became faster as well; a control without a verdict is none. */
static void test_faster(void **state)
{
    (void)state;
    struct aob_blame blames[3];
    const struct aob_blame_couple couples[] = {couple(AOB_VERDICT_FASTER, 0.8, true),
                                               couple(AOB_VERDICT_FASTER, 0.79, false),
                                               couple(AOB_VERDICT_FASTER, 0.6, false)};
    aob_blame_find(couples, 3, true, blames);
    assert_true(blames[1].excused);
    assert_false(blames[2].excused);
    const struct aob_blame_couple invalid[] = {couple(AOB_VERDICT_INVALID, 0.8, true),
                                               couple(AOB_VERDICT_FASTER, 0.79, false)};
    aob_blame_find(invalid, 2, true, blames);
    assert_false(blames[1].excused);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_all_moved), cmocka_unit_test(test_module),
                                       cmocka_unit_test(test_faster)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
