#include <math.h>
#include "history/line.h"
#include "night_folder.h"

static void test_round_trip(void **state)
{
    (void)state;
    run_write(3, 2);
    struct aob_history *history = history_open(AOB_HISTORY_WRITE);
    int64_t first = night_keep(history, "nightly", true);
    run_write(3, 2.5);
    int64_t second = night_keep(history, "nightly", false);
    struct aob_lines lines = {0};
    struct aob_nights nights = {0};
    assert_true(aob_lines_read(history, &(struct aob_lines_ask){.figures = true}, &lines, &error));
    assert_true(aob_nights_read(history, NULL, &nights, &error));
    assert_int_equal(nights.count, 2);
    assert_int_equal(nights.items[0].id, first);
    assert_true(nights.items[0].whole);
    assert_false(nights.items[1].whole);
    assert_int_equal(nights.items[1].cases, 3);
    assert_int_equal(lines.count, 3);
    assert_int_equal(lines.items[1].count, 2);
    assert_string_equal(lines.items[1].text, "corner/front gtao slices=2 vulkan 480x270");
    assert_string_equal(lines.items[1].class_name,
                        "cpu, 2 x Xeon, llvmpipe, Mesa 22.3, fixed pass 1, 2 threads, cpu time");
    const struct aob_point *p = &lines.items[1].points[1];
    assert_int_equal(p->night, second);
    assert_near(p->ratio, 5, 1e-12);
    assert_near(p->low, 4.9, 1e-8);
    assert_near(p->high, 5.15, 1e-8);
    assert_near(p->cost_ms, 3.25, 0);
    assert_near(p->ref_ms, .625, 0);
    assert_near(p->memory_bytes, 1036800, 0);
    assert_near(p->band_rmse, .11, 0);
    assert_near(aob_json_to_number(json_object_get(p->figures, "flip")), .05, 0);
    assert_near(aob_json_to_number(json_object_get(p->figures, "cache.ps4.l1.most.miss_ratio")), .2, 0);
    assert_null(json_object_get(p->figures, "cache.ps4.l1.most.fills_per_pixel"));
    assert_string_equal(p->build, "000000000000000000000000000000d1");
    aob_nights_finish(&nights);
    aob_lines_finish(&lines);
    aob_history_close(history);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_round_trip, night_folder_make, night_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
