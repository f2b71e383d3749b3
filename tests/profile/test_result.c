/* The document of a result, field by field: figures that were set by hand, each another number. */
#include "check.h"
#include "made.h"
#include "streams.h"

static struct aob_cache_pass set_by_hand(void)
{
    return (struct aob_cache_pass){.name = "ao",
                                   .width = 40,
                                   .height = 10,
                                   .pixels = 400,
                                   .invocations = 401,
                                   .fetches = 5000,
                                   .distinct = 4000,
                                   .texels = 4100,
                                   .bytes_asked = 16400,
                                   .bytes_written = 800,
                                   .lanes_busy = 90,
                                   .lanes_issued = 120,
                                   .levels = {{{4100, 1025, 300, 700, 25}, {4100, 2050, 301, 1800, -51}},
                                              {{1025, 205, 100, 60, 45}, {2050, 1640, 110, 1500, 30}}}};
}

static const struct {
    const char *path;
    double value;
} rows[] = {
    {"units", 2},
    {"in_flight", 3},
    {"passes.0.width", 40},
    {"passes.0.height", 10},
    {"passes.0.invocations", 401},
    {"passes.0.fetches", 5000},
    {"passes.0.distinct", 4000},
    {"passes.0.texels", 4100},
    {"passes.0.bytes_asked", 16400},
    {"passes.0.bytes_written", 800},
    {"passes.0.lanes_busy", 0.75},
    {"passes.0.levels.0.one.accesses", 4100},
    {"passes.0.levels.0.one.misses", 1025},
    {"passes.0.levels.0.one.miss_ratio", 0.25},
    {"passes.0.levels.0.most.miss_ratio", 0.5},
    {"passes.0.levels.0.one.fills_per_pixel", 2.5625},
    {"passes.0.levels.0.one.bytes_per_pixel", 164},
    {"passes.0.levels.0.most.bytes_per_pixel", 328},
    {"passes.0.levels.0.one.compulsory", 300},
    {"passes.0.levels.0.one.capacity", 700},
    {"passes.0.levels.0.one.conflict", 25},
    {"passes.0.levels.0.most.conflict", -51},
    {"passes.0.levels.1.one.miss_ratio", 0.2},
    {"passes.0.levels.1.most.miss_ratio", 0.8},
    {"passes.0.levels.1.one.bytes_per_pixel", 65.6},
    {"frame.levels.1.most.misses", 1640},
    {"frame.width", 40},
};

static void test_fields(void **state)
{
    (void)state;
    struct aob_profile profile = made_profile();
    profile.levels[1] = profile.levels[0];
    profile.levels[1].sector = 128;
    profile.level_count = 2;
    struct aob_cache_result result = {.profile = &profile, .split = true};
    *AOB_PUSH(result.passes, result.pass_count, result.pass_capacity) = set_by_hand();
    aob_cache_result_add(&result, &result.passes[0]);
    json_t *document = aob_cache_result_to_json(&result);
    for (size_t i = 0; i < AOB_COUNT(rows); i++)
        assert_near(made_real_at(document, rows[i].path), rows[i].value, 1e-12);
    assert_string_equal(json_string_value(json_object_get(document, "profile")), "made");
    assert_null(json_object_get(json_object_get(document, "frame"), "curve"));
    assert_int_equal(aob_cache_filled(&result, &result.frame, 1, AOB_FLIGHT_MOST), 1640 * 128);
    json_decref(document);
    aob_cache_result_finish(&result);
}

/* What is not known is null, and so is a ratio of nothing. */
static void test_unknown(void **state)
{
    (void)state;
    struct aob_profile profile = made_profile();
    struct aob_cache_result result = {.profile = &profile};
    json_t *document = aob_cache_result_to_json(&result);
    const json_t *frame = json_object_get(document, "frame");
    const json_t *one = json_object_get(json_array_get(json_object_get(frame, "levels"), 0), "one");
    static const char *const names[] = {"capacity", "conflict", "miss_ratio", "fills_per_pixel",
                                        "bytes_per_pixel"};
    for (size_t i = 0; i < AOB_COUNT(names); i++)
        assert_true(json_is_null(json_object_get(one, names[i])));
    assert_true(json_is_null(json_object_get(frame, "lanes_busy")));
    json_decref(document);
}

/* Passes of two sizes: counts are added, the area is the larger one's, and curves have the sum at each size. */
static void test_sum(void **state)
{
    (void)state;
    struct aob_profile profile = made_profile();
    struct aob_cache_result result = {.profile = &profile, .split = true};
    for (int i = 0; i < 2; i++) {
        struct aob_cache_pass *pass = AOB_PUSH(result.passes, result.pass_count, result.pass_capacity);
        *pass = set_by_hand();
        pass->width = i ? 20 : 40;
        pass->pixels = i ? 200 : 400;
        struct aob_curve *curve = &pass->curves[AOB_FLIGHT_ONE];
        *curve = (struct aob_curve){1, AOB_NEW_ARRAY(uint64_t, 1), AOB_NEW_ARRAY(uint64_t, 1)};
        *curve->lines = 1;
        *curve->misses = i ? 11 : 5;
        aob_cache_result_add(&result, pass);
    }
    json_t *document = aob_cache_result_to_json(&result);
    assert_near(made_real_at(document, "frame.width"), 40, 0);
    assert_near(made_real_at(document, "frame.fetches"), 10000, 0);
    assert_near(made_real_at(document, "frame.levels.0.one.misses"), 2050, 0);
    assert_near(made_real_at(document, "frame.levels.0.one.miss_ratio"), 0.25, 0);
    assert_near(made_real_at(document, "frame.levels.0.one.fills_per_pixel"), 2050 / 400.0, 1e-12);
    assert_near(made_real_at(document, "frame.levels.0.most.conflict"), -102, 0);
    assert_near(made_real_at(document, "frame.curve.one.lines.0"), 1, 0);
    assert_near(made_real_at(document, "frame.curve.one.misses.0"), 16, 0);
    json_decref(document);
    aob_cache_result_finish(&result);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fields),
        cmocka_unit_test(test_unknown),
        cmocka_unit_test(test_sum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
