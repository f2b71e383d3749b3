/* The best cases against a budget, case by case as a run stores them. */
#include <jansson.h>
#include <math.h>
#include <stdlib.h>
#include "base/text.h"
#include "check.h"
#include "run/best.h"

static char name[] = "made";
static const struct aob_budget budget = {
    .name = name, .frame_ms = 16, .ao_ms = 2, .error = INFINITY, .width = 64, .height = 32};

/* Against two targets; its interval is 10 % about the time. */
static void take(struct aob_best *best, const char *scene, const char *technique, int width, double ms,
                 double near, double far)
{
    struct aob_text line = {0};
    aob_text_add(
        &line,
        "{\"key\":\"k\",\"scene\":\"%s\",\"view\":\"v\",\"technique\":\"%s\",\"backend\":\"null\",\"width\":%"
        "d,"
        "\"height\":32,\"status\":\"ok\",\"errors\":[{\"target\":{\"radius\":1},\"band_rmse\":%g},{"
        "\"target\":{"
        "\"radius\":2},\"band_rmse\":%g}],\"time\":{\"clock\":\"cpu\",\"cpu_ms\":%g,\"ratio_to_ref\":10,"
        "\"ci_low\":9,\"ci_high\":11}}",
        scene, technique, width, near, far, ms);
    json_t *record = json_loads(line.data, 0, NULL);
    assert_non_null(record);
    aob_best_take(best, record, technique);
    json_decref(record);
    aob_text_finish(&line);
}

static void assert_line(const struct aob_best *best, size_t at, const char *expected)
{
    if (!expected)
        assert_int_equal(best->lines[at].size, 0);
    else
        assert_string_equal(best->lines[at].data, expected);
}

static void test_best_so_far(void **state)
{
    (void)state;
    struct aob_best best;
    aob_best_init(&best, &budget);
    take(&best, "a", "none", 64, 0.5, 0.1, 0.1);
    assert_line(&best, 0, "2 ms: nothing fits yet, against the truth within 1 scene unit");
    take(&best, "a", "dear", 64, 1.9, 0.1, 0.1); /* its upper end is over */
    assert_line(&best, 0, "2 ms: nothing fits yet, against the truth within 1 scene unit");
    take(&best, "a", "first", 64, 1, 0.3, 0.2);
    take(&best, "a", "second", 64, 1.5, 0.2, 0.25); /* better against the one, worse against the other */
    assert_line(&best, 0,
                "2 ms: error 0.2000, 1.5 (1.35 .. 1.65) ms: second, against the truth within 1 scene unit");
    assert_line(&best, 1,
                "2 ms: error 0.2000, 1 (0.9 .. 1.1) ms: first, against the truth within 2 scene units");
    assert_line(&best, 2, NULL);
    take(&best, "b", "third", 64, 1, 0.9, 0.9); /* of another scene */
    assert_line(&best, 0,
                "2 ms: error 0.9000, 1 (0.9 .. 1.1) ms: third, against the truth within 1 scene unit");
    take(&best, "a", "wide", 128, 1, 0.01, 0.01); /* not of the budget's size */
    take(&best, "a", "last", 64, 1, 0.2, 0.2);    /* as accurate as the second, and cheaper */
    assert_line(&best, 0,
                "2 ms: error 0.2000, 1 (0.9 .. 1.1) ms: last, against the truth within 1 scene unit");
    aob_best_finish(&best);
}

/* G-buffer and composite go off the frame as soon as they are known, and what was chosen before is judged anew; those of
 * another size do not. */
static void test_frame_goes_off(void **state)
{
    (void)state;
    struct aob_best best;
    struct aob_budget frame = budget;
    frame.rest_ms = 10;
    frame.ao_ms = INFINITY;
    frame.width = frame.height = 0;
    aob_best_init(&best, &frame);
    take(&best, "a", "cheap", 64, 2, 0.3, 0.3);
    take(&best, "a", "dear", 64, 5, 0.1, 0.1);
    assert_line(&best, 0,
                "6 ms: error 0.1000, 5 (4.5 .. 5.5) ms: dear, against the truth within 1 scene unit");
    take(&best, "a", "deferred", 128, 5, 0.5, 0.5);
    take(&best, "a", "none", 64, 0.5, 0.5, 0.5);
    assert_line(&best, 0,
                "6 ms: error 0.1000, 5 (4.5 .. 5.5) ms: dear, against the truth within 1 scene unit");
    take(&best, "a", "deferred", 64, 2, 0.5, 0.5);
    assert_line(&best, 0,
                "3.8 ms: error 0.3000, 2 (1.8 .. 2.2) ms: cheap, against the truth within 1 scene unit");
    take(&best, "b", "deferred", 64, 10, 0.5, 0.5); /* dearer in another scene */
    take(&best, "a", "none", 64, 0.5, 0.5, 0.5);
    assert_line(&best, 0, "0 ms: nothing fits, against the truth within 1 scene unit");
    aob_best_finish(&best);
}

static void test_no_budget(void **state)
{
    (void)state;
    struct aob_best best;
    aob_best_init(&best, &(struct aob_budget){0});
    take(&best, "a", "first", 64, 1, 0.3, 0.2);
    assert_line(&best, 0, NULL);
    aob_best_finish(&best);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_best_so_far),
                                       cmocka_unit_test(test_frame_goes_off),
                                       cmocka_unit_test(test_no_budget)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
