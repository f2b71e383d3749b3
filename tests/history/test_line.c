/* Whose line a record is on. */
#include <math.h>
#include "base/memory.h"
#include "history/line.h"
#include "open_history.h"

/* The same series: clock, threads, device and config decide whose line a point is on. */
static void test_classes_never_mix(void **state)
{
    (void)state;
    static const struct {
        const char *object, *member, *value;
    } others[] = {{"time", "clock", "'wall'"},
                  {"time", "threads", "4"},
                  {"fingerprint", "driver", "'Mesa 23'"},
                  {"fingerprint", "device", "'lavapipe'"},
                  {"fingerprint", "cpu", "'EPYC'"},
                  {"fingerprint", "cores", "4"},
                  {"fingerprint", "class", "'discrete'"},
                  {"fingerprint", "fixed_pass", "2"}};
    record_keep(record_make(1, 2));
    for (size_t i = 0; i < AOB_COUNT(others); i++) {
        char text[64];
        json_t *record = record_make(1, 2);
        snprintf(text, sizeof text, "[%s]", others[i].value);
        json_t *value = json_of(text);
        json_object_set(json_object_get(record, others[i].object), others[i].member,
                        json_array_get(value, 0));
        json_decref(value);
        record_keep(record);
    }
    json_t *record = record_make(1, 2);
    journal_write(&record, 1);
    night_keep(history, "another", true);
    record_keep(record_make(1, 2));
    lines_read(false);
    assert_int_equal(lines.count, 2 + AOB_COUNT(others));
    assert_int_equal(lines.items[0].count, 2);
    assert_string_equal(lines.items[1].class_name,
                        "cpu, 2 x Xeon, llvmpipe, Mesa 22.3, fixed pass 1, 2 threads, wall time");
    assert_near(lines.items[1].points[0].cost_ms, 2.5, 0);
}

/* A speed of the processor that another night's fingerprint might tell is no class of its own. */
static void test_program_is_no_class(void **state)
{
    (void)state;
    record_keep(record_make(1, 2));
    json_t *record = record_make(1, 2);
    record_set(json_object_get(record, "fingerprint"), "program", "0.2.0");
    record_set(json_object_get(record, "fingerprint"), "mhz", "2400");
    record_keep(record);
    lines_read(false);
    assert_int_equal(lines.count, 1);
}

static void test_untimed(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        json_t *record = record_make(1, 2);
        json_object_del(record, "time");
        record_keep(record);
    }
    lines_read(false);
    assert_int_equal(lines.count, 1);
    assert_string_equal(lines.items[0].class_name, "cpu, 2 x Xeon, llvmpipe, Mesa 22.3, fixed pass 1");
    const struct aob_point *p = &lines.items[0].points[1];
    assert_true(isnan(p->ratio) && isnan(p->low) && isnan(p->high) && isnan(p->cost_ms) && isnan(p->ref_ms));
    assert_near(p->rmse, .06, 0);
    assert_near(p->memory_bytes, 1036800, 0);
}

/* It failed behind its set-up: as the run's other cases were timed, whatever was there before. */
static void test_failed_case_stays_on_its_line(void **state)
{
    (void)state;
    for (int night = 0; night < 2; night++) {
        json_t *records[] = {record_make(1, 2), record_make(2, 3)};
        json_object_del(records[night], "time");
        record_set(records[night], "status", "failed");
        record_set(records[night], "reason", "it broke");
        journal_write(records, 2);
        night_keep(history, "nightly", true);
    }
    lines_read(false);
    assert_int_equal(lines.count, 2);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(lines.items[i].count, 2);
        int broken = strcmp(lines.items[i].series, key_of(1)) == 0 ? 0 : 1;
        assert_string_equal(lines.items[i].points[broken].status, "failed");
        assert_string_equal(lines.items[i].points[broken].reason, "it broke");
        assert_string_equal(lines.items[i].points[!broken].status, "ok");
    }
}

static json_t *record_without_device(int series)
{
    json_t *record = record_make(series, 2);
    json_object_del(record, "series");
    json_object_del(record, "time");
    json_object_del(record, "error");
    json_object_set_new(record, "fingerprint", json_of("{'program':'0.1.0','cpu':'Xeon','cores':2}"));
    record_set(record, "key", key_of(77));
    record_set(record, "status", "unsupported");
    return record;
}

static void test_case_without_device(void **state)
{
    (void)state;
    run_write(2, 2);
    night_keep(history, "nightly", true);
    json_t *records[] = {record_without_device(2), record_without_device(5)};
    record_set(records[1], "key", key_of(78));
    journal_write(records, 2);
    night_keep(history, "nightly", true);
    lines_read(false);
    assert_int_equal(lines.count, 3);
    assert_int_equal(lines.items[0].count, 1);
    assert_int_equal(lines.items[1].count, 2);
    assert_string_equal(lines.items[1].points[1].status, "unsupported");
    assert_string_equal(lines.items[1].points[1].key, key_of(77));
    assert_string_equal(lines.items[2].series, key_of(78));
    assert_string_equal(lines.items[2].class_name, "no device");
    assert_string_equal(lines.items[2].points[0].target_weighting, "");
}

static json_t *record_of_build(const char *key, const char *module, double ratio)
{
    json_t *record = record_make(1, ratio);
    record_set(record, "key", key);
    record_set(record, "module", module);
    return record;
}

/* What keeping the run's folder as a night says. */
static char *stderr_of_night(void)
{
    stderr_begin();
    night_keep(history, "nightly", true);
    return stderr_end();
}

/* The night of these records, which it takes over, planned with these module files ("": built in). */
static void keep_planned(json_t **records, size_t count, const char *first, const char *second)
{
    json_t *plan = json_array();
    const char *const modules[] = {first, second};
    for (size_t i = 0; i < AOB_COUNT(modules); i++)
        if (modules[i]) {
            json_t *technique = json_of(technique_text);
            if (*modules[i])
                record_set(technique, "module", modules[i]);
            json_array_append_new(plan, technique);
        }
    journal_write(records, count);
    info_write(plan);
    free(stderr_of_night());
}

/* Two builds of a technique in one night have one series. Alone, each night's build goes on with the same line. */
static void test_builds(void **state)
{
    (void)state;
    record_keep(record_of_build(key_of(1), NULL, 2));
    keep_planned((json_t *[]){record_of_build(key_of(2), "a.so", 3)}, 1, "a.so", NULL);
    keep_planned((json_t *[]){record_of_build(key_of(1), NULL, 4), record_of_build(key_of(3), "b.so", 5)}, 2,
                 "", "b.so");
    lines_read(false);
    assert_int_equal(lines.count, 2);
    assert_int_equal(lines.items[0].count, 3);
    assert_string_equal(lines.items[0].points[1].module, "a.so");
    assert_near(lines.items[0].points[2].ratio, 4, 1e-12);
    assert_string_equal(lines.items[1].module, "b.so");
    assert_string_equal(lines.items[1].text, "corner/front gtao (b.so) slices=1 vulkan 480x270");
    assert_near(lines.items[1].points[0].ratio, 5, 1e-12);
}

/* The night was planned with two, and the record of one lacks: the other stays on its own line. */
static void test_one_of_two_builds(void **state)
{
    (void)state;
    keep_planned((json_t *[]){record_of_build(key_of(1), "a.so", 2), record_of_build(key_of(2), "b.so", 3)},
                 2, "a.so", "b.so");
    keep_planned((json_t *[]){record_of_build(key_of(2), "b.so", 4)}, 1, "a.so", "b.so");
    lines_read(false);
    assert_int_equal(lines.count, 2);
    assert_string_equal(lines.items[1].module, "b.so");
    assert_int_equal(lines.items[0].count, 1);
    assert_int_equal(lines.items[1].count, 2);
    assert_near(lines.items[1].points[1].ratio, 4, 1e-12);
}

/* A journal alone tells of its builds itself. */
static void test_builds_without_a_plan(void **state)
{
    (void)state;
    json_t *records[] = {record_of_build(key_of(1), "a.so", 2), record_of_build(key_of(2), "b.so", 3)};
    journal_write(records, 2);
    night_keep(history, "nightly", true);
    lines_read(false);
    assert_int_equal(lines.count, 2);
    assert_string_equal(lines.items[0].module, "a.so");
    assert_string_equal(lines.items[1].module, "b.so");
}

static json_t *record_on(const char *driver, int series)
{
    json_t *record = record_make(series, 2);
    record_set(json_object_get(record, "fingerprint"), "driver", driver);
    return record;
}

/* The driver was another one for a night. What breaks later is on the line of the latest night, or of the machine that the
 * run's other cases name, and not on the line that began last. */
static void test_broken_on_the_latest_line(void **state)
{
    (void)state;
    static const char *const drivers[] = {"Mesa 1", "Mesa 2", "Mesa 1", "Mesa 1", "Mesa 1"};
    for (size_t i = 0; i < AOB_COUNT(drivers); i++)
        record_keep(record_on(drivers[i], 1));
    record_keep(record_without_device(1));
    lines_read(false);
    assert_int_equal(lines.count, 2);
    assert_int_equal(lines.items[0].count, 5);
    assert_string_equal(lines.items[0].points[4].status, "unsupported");
    assert_int_equal(lines.items[1].count, 1);
    json_t *untimed = record_make(1, 2);
    json_object_del(untimed, "time");
    json_object_set_new(untimed, "fingerprint", json_object());
    record_keep(untimed); /* by its series, as well */
    lines_read(false);
    assert_int_equal(lines.items[0].count, 6);
    keep_planned((json_t *[]){record_on("Mesa 2", 2), record_without_device(1)}, 2, "", NULL);
    lines_read(false);
    assert_int_equal(lines.count, 3);
    assert_int_equal(lines.items[0].count, 6);
    assert_int_equal(lines.items[1].count, 2);
    assert_string_equal(lines.items[1].points[1].status, "unsupported");
}

/* Two cases that nothing tells apart: the night is kept, the first has the point, and the other one is told of. */
static void test_two_cases_of_one_line(void **state)
{
    (void)state;
    json_t *records[] = {record_of_build(key_of(1), NULL, 2), record_of_build(key_of(2), NULL, 3),
                         record_make(4, 5)};
    journal_write(records, 3);
    info_write(json_pack("[o]", json_of(technique_text)));
    char *said = stderr_of_night();
    assert_contains(said,
                    "1 of its cases (the first has the key 00000000000000000000000000000002) would be a "
                    "second point of a line in one night");
    free(said);
    lines_read(true);
    assert_int_equal(lines.count, 2);
    assert_int_equal(lines.items[0].count, 1);
    assert_near(lines.items[0].points[0].ratio, 2, 1e-12);
    assert_non_null(lines.items[0].points[0].figures);
    assert_near(lines.items[1].points[0].ratio, 5, 1e-12);
}

#define TEST(test) cmocka_unit_test_setup_teardown(test, history_make, history_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_classes_never_mix),
        TEST(test_program_is_no_class),
        TEST(test_untimed),
        TEST(test_failed_case_stays_on_its_line),
        TEST(test_case_without_device),
        TEST(test_builds),
        TEST(test_one_of_two_builds),
        TEST(test_builds_without_a_plan),
        TEST(test_broken_on_the_latest_line),
        TEST(test_two_cases_of_one_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
