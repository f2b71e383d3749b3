#include <math.h>
#include <sqlite3.h>
#include "history/line.h"
#include "open_history.h"

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

static bool judge(int64_t line, int64_t night, enum aob_night_verdict verdict, int64_t since,
                  const char *said)
{
    const struct aob_line_verdict one = {line, verdict, since, said};
    return aob_lines_judge(history, night, &one, 1, &error);
}

static void test_values(void **state)
{
    (void)state;
    run_write(3, 2);
    int64_t first = night_keep(history, "nightly", true);
    run_write(3, 2.5);
    int64_t second = night_keep(history, "nightly", false);
    lines_read(true);
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
    lines_read(false);
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

/* As program versions before the clock, the targets and the modules wrote it. */
static void test_older_record(void **state)
{
    (void)state;
    json_t *record = json_of(
        "{'key':'k','series':'s','scene':'corner','technique':'gtao','status':'ok','time':{'cpu_ms':2,"
        "'wall_ms':9,'ratio_to_ref':3},'error':{'rmse':0.1},'reference_radius':0.5}");
    journal_write(&record, 1);
    night_keep(history, "nightly", true);
    lines_read(true);
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
    lines_read(false);
    assert_int_equal(lines.count, 2);
    assert_string_equal(lines.items[1].series, key_of(3));
}

static void test_taken_again(void **state)
{
    (void)state;
    run_write(3, 2);
    int64_t night = night_keep(history, "nightly", false);
    lines_read(false);
    assert_true(judge(lines.items[0].id, night, AOB_NIGHT_SLOWER, 1, "it is"));
    run_write(2, 4);
    size_t taken = 0;
    assert_true(aob_night_take(history, night, &taken, &error));
    assert_int_equal(taken, 2);
    lines_read(true);
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

/* Beside a good journal: nothing is taken, and what the night held stays. */
static void test_damaged_plan(void **state)
{
    (void)state;
    static const char *const bad[] = {"", "{\"name\": \"nightly\", \"keys\": [", "[]"};
    size_t taken = 0;
    run_write(2, 2);
    int64_t night = night_keep(history, "nightly", false);
    run_write(3, 2);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        write_file("run.json", bad[i], strlen(bad[i]));
        assert_false(aob_night_take(history, night, NULL, &error));
        assert_contains(error.text, "/run.json: is damaged (");
    }
    lines_read(false);
    assert_int_equal(lines.count, 2);
    info_write(json_pack("[o]", json_of(technique_text)));
    assert_true(aob_night_take(history, night, &taken, &error));
    assert_int_equal(taken, 3);
}

/* Figures of the second of three nights are lost: the others' stay where they are. */
static void test_lost_figures(void **state)
{
    (void)state;
    for (int night = 1; night <= 3; night++) {
        json_t *record = record_make(1, 2);
        json_object_set_new(json_object_get(record, "error"), "flip", json_real(night));
        record_keep(record);
    }
    sqlite3 *db = NULL;
    assert_int_equal(sqlite3_open(path, &db), SQLITE_OK);
    assert_int_equal(sqlite3_exec(db, "DELETE FROM figures WHERE night = 2", NULL, NULL, NULL), SQLITE_OK);
    sqlite3_close(db);
    lines_read(true);
    assert_int_equal(lines.items[0].count, 3);
    for (int i = 0; i < 3; i++) {
        const json_t *figures = lines.items[0].points[i].figures;
        if (i == 1)
            assert_null(figures);
        else
            assert_true(aob_json_to_number(json_object_get(figures, "flip")) == i + 1);
    }
}

static void test_verdicts(void **state)
{
    (void)state;
    run_write(1, 2);
    int64_t night = night_keep(history, "nightly", true);
    lines_read(false);
    int64_t line = lines.items[0].id;
    for (int verdict = 0; verdict < AOB_NIGHT_VERDICTS; verdict++) {
        assert_true(judge(line, night, (enum aob_night_verdict)verdict, verdict, "said"));
        lines_read(false);
        assert_int_equal(lines.items[0].points[0].verdict, verdict);
        assert_int_equal(lines.items[0].points[0].since, verdict);
        assert_string_equal(lines.items[0].points[0].said, "said");
    }
    assert_false(judge(line, night + 1, AOB_NIGHT_OPEN, 0, ""));
    assert_contains(error.text, "line 1 has no point in night 2");
    const struct aob_line_verdict both[] = {{line, AOB_NIGHT_SLOWER, 7, "half"},
                                            {line + 1, AOB_NIGHT_NONE, 0, NULL}};
    assert_false(aob_lines_judge(history, night, both, 2, &error));
    lines_read(false);
    assert_int_equal(lines.items[0].points[0].verdict, AOB_NIGHT_VERDICTS - 1);
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

#define TEST(test) cmocka_unit_test_setup_teardown(test, history_make, history_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_values),       TEST(test_nights),
        TEST(test_older_record), TEST(test_only_planned_cases),
        TEST(test_taken_again),  TEST(test_folder_without_a_run),
        TEST(test_damaged_plan), TEST(test_lost_figures),
        TEST(test_verdicts),     TEST(test_chosen_lines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
