#include <math.h>
#include "base/memory.h"
#include "history/line.h"
#include "night_folder.h"

static struct aob_history *history;
static struct aob_lines lines;

static int make(void **state)
{
    lines = (struct aob_lines){0};
    int made = night_folder_make(state);
    history = history_open(AOB_HISTORY_WRITE);
    return made;
}

static int remove_all(void **state)
{
    aob_lines_finish(&lines);
    aob_history_close(history);
    return night_folder_remove(state);
}

static void read_lines(bool figures)
{
    aob_lines_finish(&lines);
    assert_true(aob_lines_read(history, &(struct aob_lines_ask){.figures = figures}, &lines, &error));
}

/* One record as the journal of a night. */
static int64_t keep_record(json_t *record)
{
    journal_write(&record, 1);
    info_write(json_pack("[o]", json_of(technique_text)));
    return night_keep(history, "nightly", true);
}

static void check_point(const struct aob_point *p)
{
    assert_near(p->ratio, 5, 1e-12);
    assert_near(p->low, 4.9, 1e-8);
    assert_near(p->high, 5.15, 1e-8);
    assert_near(p->cost_ms, 3.25, 0);
    assert_near(p->ref_ms, .625, 0);
    assert_near(p->memory_bytes, 1036800, 0);
    assert_near(p->rmse, .06, 0);
    assert_near(p->band_rmse, .11, 0);
    assert_near(p->reference_se, .003, 0);
    assert_near(p->band_pixels, 1558, 0);
    assert_near(p->target_radius, .5, 0);
    assert_string_equal(p->target_weighting, "cosine");
    assert_string_equal(p->reference, "ray-traced");
    assert_string_equal(p->key, key_of(1002));
    assert_string_equal(p->build, "000000000000000000000000000000d1");
    assert_string_equal(p->image, "00000000000000000000000000000abc");
    assert_string_equal(p->status, "ok");
    assert_int_equal(p->verdict, AOB_NIGHT_NONE);
}

static void test_values(void **state)
{
    (void)state;
    run_write(3, 2);
    int64_t first = night_keep(history, "nightly", true);
    run_write(3, 2.5);
    int64_t second = night_keep(history, "nightly", false);
    read_lines(true);
    assert_int_equal(lines.count, 3);
    const struct aob_line *line = &lines.items[1];
    assert_int_equal(line->count, 2);
    assert_int_equal(line->points[0].night, first);
    assert_int_equal(line->points[1].night, second);
    assert_string_equal(line->series, key_of(2));
    assert_string_equal(line->config, "nightly");
    assert_string_equal(line->params, "radius=0.5 slices=2");
    assert_string_equal(line->options, "guard_band=0 fetch=sampled threads=0");
    assert_string_equal(line->text, "corner/front gtao slices=2 vulkan 480x270");
    assert_string_equal(line->class_name,
                        "cpu, 2 x Xeon, llvmpipe, Mesa 22.3, fixed pass 1, 2 threads, cpu time");
    check_point(&line->points[1]);
    const json_t *figures = line->points[1].figures;
    assert_int_equal(json_object_size(figures), 11);
    assert_near(aob_json_to_number(json_object_get(figures, "flip")), .05, 0);
    assert_near(aob_json_to_number(json_object_get(figures, "definition_missing")), -.004, 0);
    assert_near(aob_json_to_number(json_object_get(figures, "cache.ps4.l1.most.miss_ratio")), .2, 0);
    assert_null(json_object_get(figures, "cache.ps4.l1.most.fills_per_pixel"));
    read_lines(false);
    assert_null(lines.items[1].points[1].figures);
}

static void check_nights(const char *name, size_t count)
{
    struct aob_nights nights = {0};
    assert_true(aob_nights_read(history, name, &nights, &error));
    assert_int_equal(nights.count, count);
    aob_nights_finish(&nights);
}

static void test_nights(void **state)
{
    (void)state;
    struct aob_nights nights = {0};
    run_write(2, 2);
    const struct aob_night_desc desc = {
        .name = "nightly", .config_hash = "c1", .folder = folder, .date = 1780279201};
    int64_t night = aob_night_begin(history, &desc, &error);
    assert_int_equal(night, 1);
    assert_true(aob_nights_read(history, NULL, &nights, &error));
    assert_string_equal(nights.items[0].date, "2026-06-01T02:00:01Z");
    assert_string_equal(nights.items[0].build, "");
    assert_string_equal(nights.items[0].folder, folder);
    assert_string_equal(nights.items[0].modules, "");
    assert_int_equal(nights.items[0].cases, 0);
    aob_nights_finish(&nights);
    size_t taken = 0;
    assert_true(aob_night_take(history, night, &taken, &error));
    assert_int_equal(taken, 2);
    assert_true(aob_night_end(history, night, "{\"line\": \"calm\"}", &error));
    night_keep(history, "other", false);
    assert_true(aob_nights_read(history, NULL, &nights, &error));
    assert_string_equal(nights.items[0].build, "b1");
    assert_string_equal(nights.items[0].summary, "{\"line\": \"calm\"}");
    assert_true(nights.items[0].whole);
    assert_false(nights.items[1].whole);
    assert_string_equal(nights.items[1].modules, "m1");
    assert_int_equal(nights.items[1].cases, 2);
    assert_int_equal(nights.items[1].ok, 2);
    aob_nights_finish(&nights);
    check_nights("other", 1);
    check_nights("none of this name", 0);
}

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
    keep_record(record_make(1, 2));
    for (size_t i = 0; i < AOB_COUNT(others); i++) {
        char text[64];
        json_t *record = record_make(1, 2);
        snprintf(text, sizeof text, "[%s]", others[i].value);
        json_t *value = json_of(text);
        json_object_set(json_object_get(record, others[i].object), others[i].member,
                        json_array_get(value, 0));
        json_decref(value);
        keep_record(record);
    }
    json_t *record = record_make(1, 2);
    journal_write(&record, 1);
    night_keep(history, "another", true);
    keep_record(record_make(1, 2));
    read_lines(false);
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
    keep_record(record_make(1, 2));
    json_t *record = record_make(1, 2);
    record_set(json_object_get(record, "fingerprint"), "program", "0.2.0");
    record_set(json_object_get(record, "fingerprint"), "mhz", "2400");
    keep_record(record);
    read_lines(false);
    assert_int_equal(lines.count, 1);
}

static void test_untimed(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        json_t *record = record_make(1, 2);
        json_object_del(record, "time");
        keep_record(record);
    }
    read_lines(false);
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
    read_lines(false);
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
    read_lines(false);
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

/* Two builds of a technique in one night have one series. Alone, each night's build goes on with the same line. */
static void test_builds(void **state)
{
    (void)state;
    keep_record(record_of_build(key_of(1), NULL, 2));
    keep_record(record_of_build(key_of(2), "a.so", 3));
    json_t *records[] = {record_of_build(key_of(1), NULL, 4), record_of_build(key_of(3), "b.so", 5)};
    journal_write(records, 2);
    night_keep(history, "nightly", true);
    read_lines(false);
    assert_int_equal(lines.count, 2);
    assert_int_equal(lines.items[0].count, 3);
    assert_string_equal(lines.items[0].points[1].module, "a.so");
    assert_near(lines.items[0].points[2].ratio, 4, 1e-12);
    assert_string_equal(lines.items[1].module, "b.so");
    assert_string_equal(lines.items[1].text, "corner/front gtao (b.so) radius=0.5 slices=1 vulkan 480x270");
    assert_near(lines.items[1].points[0].ratio, 5, 1e-12);
}

/* As program versions before the clock, the targets and the modules wrote it. */
static void test_older_record(void **state)
{
    (void)state;
    json_t *record = json_of(
        "{'key':'k','series':'s','scene':'corner','technique':'gtao','status':'ok','time':{'cpu_ms':2,"
        "'wall_ms':9,'ratio_to_ref':3},'error':{'rmse':0.1},'reference_radius':0.5}");
    journal_write(&record, 1);
    night_keep(history, "nightly", true);
    read_lines(true);
    assert_int_equal(lines.count, 1);
    assert_string_equal(lines.items[0].text, "corner/ gtao");
    const struct aob_point *p = &lines.items[0].points[0];
    assert_near(p->cost_ms, 2, 0);
    assert_near(p->ratio, 3, 0);
    assert_true(isnan(p->low) && isnan(p->memory_bytes) && isnan(p->band_rmse));
    assert_near(p->target_radius, .5, 0);
    assert_string_equal(p->target_weighting, "cosine");
    assert_string_equal(p->build, "");
    assert_string_equal(p->image, "");
    assert_int_equal(json_object_size(p->figures), 1);
}

/* What the run's plan does not have any more is of an earlier state of a module. */
static void test_only_planned_cases(void **state)
{
    (void)state;
    run_write(3, 2);
    json_t *info = json_pack("{s:s, s:[s, s]}", "build", "b1", "keys", key_of(1001), key_of(1003));
    char *text = json_dumps(info, 0);
    write_file("run.json", text, strlen(text));
    free(text);
    json_decref(info);
    night_keep(history, "nightly", true);
    read_lines(false);
    assert_int_equal(lines.count, 2);
    assert_string_equal(lines.items[1].series, key_of(3));
}

static void test_taken_again(void **state)
{
    (void)state;
    run_write(3, 2);
    int64_t night = night_keep(history, "nightly", false);
    read_lines(false);
    assert_true(aob_line_judge(history, lines.items[0].id, night, AOB_NIGHT_SLOWER, 1, "it is", &error));
    run_write(2, 4);
    size_t taken = 0;
    assert_true(aob_night_take(history, night, &taken, &error));
    assert_int_equal(taken, 2);
    read_lines(true);
    assert_int_equal(lines.count, 2); /* a line without a point is none */
    assert_int_equal(lines.items[0].count, 1);
    assert_near(lines.items[0].points[0].ratio, 4, 1e-12);
    assert_int_equal(lines.items[0].points[0].verdict, AOB_NIGHT_NONE);
    assert_true(aob_night_end(history, night, "{}", &error));
    assert_false(aob_night_take(history, night, NULL, &error));
    assert_contains(error.text, "night 1 has ended: begin another one");
    assert_false(aob_night_take(history, 9, NULL, &error));
    assert_contains(error.text, "has no night 9");
    assert_false(aob_night_end(history, 9, "{}", &error));
    assert_contains(error.text, "has no night 9");
}

static void test_folder_without_a_run(void **state)
{
    (void)state;
    const struct aob_night_desc desc = {.name = "nightly", .config_hash = "c1", .folder = folder};
    int64_t night = aob_night_begin(history, &desc, &error);
    assert_false(aob_night_take(history, night, NULL, &error));
    assert_contains(error.text, "is not the folder of a run: it has no journal.jsonl");
}

static void test_verdicts(void **state)
{
    (void)state;
    run_write(1, 2);
    int64_t night = night_keep(history, "nightly", true);
    read_lines(false);
    int64_t line = lines.items[0].id;
    for (int verdict = 0; verdict < AOB_NIGHT_VERDICTS; verdict++) {
        assert_true(
            aob_line_judge(history, line, night, (enum aob_night_verdict)verdict, verdict, "said", &error));
        read_lines(false);
        assert_int_equal(lines.items[0].points[0].verdict, verdict);
        assert_int_equal(lines.items[0].points[0].since, verdict);
        assert_string_equal(lines.items[0].points[0].said, "said");
    }
    assert_false(aob_line_judge(history, line, night + 1, AOB_NIGHT_OPEN, 0, "", &error));
    assert_contains(error.text, "line 1 has no point in night 2");
}

static void test_chosen_lines(void **state)
{
    (void)state;
    size_t count = 0, points = 0;
    run_write(3, 2);
    night_keep(history, "nightly", true);
    run_write(1, 2);
    int64_t second = night_keep(history, "nightly", true);
    night_keep(history, "weekly", true);
    assert_true(aob_lines_read(history, &(struct aob_lines_ask){.night = second}, &lines, &error));
    assert_int_equal(lines.count, 1);
    assert_int_equal(lines.items[0].count, 2);
    aob_lines_finish(&lines);
    assert_true(aob_lines_read(history, &(struct aob_lines_ask){.config = "weekly"}, &lines, &error));
    assert_int_equal(lines.count, 1);
    assert_int_equal(lines.items[0].count, 1);
    assert_true(aob_lines_count(history, NULL, &count, &points, &error));
    assert_int_equal(count, 4);
    assert_int_equal(points, 5);
    assert_true(aob_lines_count(history, "weekly", &count, &points, &error));
    assert_int_equal(count, 1);
    assert_int_equal(points, 1);
}

#define TEST(test) cmocka_unit_test_setup_teardown(test, make, remove_all)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_values),
        TEST(test_nights),
        TEST(test_classes_never_mix),
        TEST(test_program_is_no_class),
        TEST(test_untimed),
        TEST(test_failed_case_stays_on_its_line),
        TEST(test_case_without_device),
        TEST(test_builds),
        TEST(test_older_record),
        TEST(test_only_planned_cases),
        TEST(test_taken_again),
        TEST(test_folder_without_a_run),
        TEST(test_verdicts),
        TEST(test_chosen_lines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
