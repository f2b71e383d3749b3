/* Several targets in one run: each has its own front, its own most accurate cases and its own table. */
#include <math.h>
#include "reports/page/gallery_plan.h"
#include "run_text.h"

static const struct aob_figure *find(const struct aob_gallery *g, enum aob_figure_kind kind, size_t target,
                                     const char *technique)
{
    for (size_t i = 0; i < g->count; i++)
        if (g->figures[i].kind == kind && g->figures[i].target == target &&
            (!technique || strcmp(g->figures[i].row->technique, technique) == 0))
            return &g->figures[i];
    fail_msg("no such figure");
    return NULL;
}

static const char *member(const struct aob_figure *figure, const char *name)
{
    return aob_member_text(figure->job, name);
}

static void test_the_most_accurate_is_of_a_target(void **state)
{
    struct aob_rows rows;
    struct aob_gallery gallery;
    (void)state;
    write_run();
    read_rows(&rows);
    aob_gallery_plan(&gallery, &rows);
    assert_int_equal(rows.target_count, 2);
    const struct aob_figure *near = find(&gallery, AOB_FIGURE_TRIPTYCH, 0, "gtao"),
                            *far = find(&gallery, AOB_FIGURE_TRIPTYCH, 1, "gtao"),
                            *other = find(&gallery, AOB_FIGURE_TRIPTYCH, 1, "hbao");
    assert_string_equal(near->row->key, "a");
    assert_string_equal(far->row->key, "b");
    assert_string_equal(other->row->key, "c");
    assert_string_equal(find(&gallery, AOB_FIGURE_HEIGHT, 0, NULL)->row->key, "a");
    assert_string_equal(find(&gallery, AOB_FIGURE_HEIGHT, 1, NULL)->row->key, "b");
    /* An image has its own truth; another target's is in the file beside it. */
    char *truth = aob_path_join(folder, "truths/far.exr");
    assert_string_equal(member(near, "reference_image"), "");
    assert_string_equal(member(far, "reference_image"), "");
    assert_string_equal(member(other, "reference_image"), truth);
    assert_string_equal(member(find(&gallery, AOB_FIGURE_MAP, 1, "hbao"), "reference_image"), truth);
    free(truth);
    /* Colours are shared within a target only, and each caption names its own. */
    assert_string_not_equal(member(near, "limit_group"), member(far, "limit_group"));
    assert_string_equal(member(far, "limit_group"), member(other, "limit_group"));
    assert_non_null(strstr(member(near, "subtitle"), "against the truth within 0.25 scene units"));
    assert_non_null(
        strstr(member(other, "subtitle"), "against the truth within 1 scene unit \u00b7 RMSE 0.2000"));
    aob_gallery_finish(&gallery);
    aob_rows_finish(&rows);
}

/* The y values of the chart's series. */
static void assert_series(const struct aob_figure *chart, size_t series, const double *values, size_t count)
{
    const json_t *y = json_object_get(json_array_get(json_object_get(chart->job, "series"), series), "y");
    assert_int_equal(json_array_size(y), count);
    for (size_t i = 0; i < count; i++)
        assert_float_equal(json_number_value(json_array_get(y, i)), values[i], 1e-12);
}

static void test_no_chart_joins_targets(void **state)
{
    struct aob_rows rows;
    struct aob_gallery gallery;
    (void)state;
    write_run();
    read_rows(&rows);
    aob_gallery_plan(&gallery, &rows);
    const struct aob_figure *near = find(&gallery, AOB_FIGURE_CHART, 0, NULL),
                            *far = find(&gallery, AOB_FIGURE_CHART, 1, NULL);
    /* Series: gtao, hbao, the front; by cost c, a, b. */
    assert_series(near, 0, (const double[]){0.01, 0.2}, 2);
    assert_series(near, 1, (const double[]){0.05}, 1);
    assert_series(near, 2, (const double[]){0.05, 0.01}, 2);
    assert_series(far, 0, (const double[]){0.3, 0.02}, 2);
    assert_series(far, 1, (const double[]){0.4}, 1);
    assert_series(far, 2, (const double[]){0.4, 0.3, 0.02}, 3);
    assert_string_equal(near->title, "What accuracy costs, against the truth within 0.25 scene units");
    assert_int_equal(near->front_count, 2);
    assert_int_equal(far->front_count, 3);
    aob_gallery_finish(&gallery);
    aob_rows_finish(&rows);
}

static void test_a_perfect_case_is_not_passed_over(void **state)
{
    struct aob_rows rows;
    struct aob_gallery gallery;
    struct aob_text journal = {0};
    (void)state;
    add_case(&journal, "a", "gtao", 0.25, 2, 0, 0.3);
    add_case(&journal, "b", "hbao", 0.25, 4, 0.2, 0.02);
    put("run.json", "{}");
    put("journal.jsonl", journal.data);
    read_rows(&rows);
    aob_gallery_plan(&gallery, &rows);
    const struct aob_figure *near = find(&gallery, AOB_FIGURE_CHART, 0, NULL),
                            *far = find(&gallery, AOB_FIGURE_CHART, 1, NULL);
    assert_non_null(
        strstr(member(near, "subtitle"), "1 cases; lower left is better; 1 more left out: error 0"));
    assert_null(strstr(member(far, "subtitle"), "left out"));
    aob_gallery_finish(&gallery);
    aob_rows_finish(&rows);
    aob_text_finish(&journal);
}

static void test_the_page_shows_one_at_a_time(void **state)
{
    (void)state;
    write_run();
    char *page = make_page();
    assert_int_equal(count_text(page, "<input type=radio name=target"), 2);
    /* A part of the section and a table each, with a heading for readers without script. */
    assert_int_equal(count_text(page, "<div data-target=\"0.25-cosine\">"), 2);
    assert_int_equal(count_text(page, "<div data-target=\"1-cosine\">"), 2);
    assert_int_equal(count_text(page, "Against the truth within 0.25 scene units</h3>"), 2);
    assert_int_equal(count_text(page, "<table class=cases>"), 2);
    const char *table = strstr(strstr(page, "id=cases"), "<div data-target=\"1-cosine\">");
    assert_non_null(strstr(table, "data-v=\"0.3\">0.3000"));
    assert_null(strstr(table, "data-v=\"0.05\">0.0500"));
    assert_null(strstr(page, "Do the backends agree"));
    free(page);
}

/* A journal from before: each radius was its own question. */
static void test_old_records(void **state)
{
    struct aob_rows rows;
    (void)state;
    put("run.json", "{}");
    put("journal.jsonl",
        "{\"key\":\"a\",\"status\":\"ok\",\"reference_radius\":0.3,\"error\":{\"rmse\":0.1,\"ssim\":0.9}}\n"
        "{\"key\":\"b\",\"status\":\"ok\",\"reference_radius\":\"inf\",\"error\":{\"rmse\":0.2}}\n"
        "{\"key\":\"c\",\"status\":\"ok\",\"reference_radius\":0.300000012,\"error\":{\"rmse\":0.3}}\n"
        "{\"key\":\"d\",\"status\":\"failed\",\"reference_radius\":9}\n");
    read_rows(&rows);
    assert_int_equal(rows.target_count, 2);
    assert_float_equal(rows.targets[0].radius, 0.3, 1e-7);
    assert_false(rows.targets[0].uniform);
    assert_true(isinf(rows.targets[1].radius));
    assert_int_equal(rows.list[0].scores[0].target, 0);
    assert_int_equal(rows.list[1].scores[0].target, 1);
    assert_int_equal(rows.list[2].scores[0].target, 0);
    assert_int_equal(rows.list[3].score_count, 0);
    assert_true(rows.list[0].scores[0].own);
    assert_float_equal(rows.list[0].scores[0].metrics.ssim, 0.9, 0);
    assert_true(isnan(rows.list[0].scores[0].metrics.flip));
    aob_rows_finish(&rows);
    put("journal.jsonl",
        "{\"key\":\"a\",\"status\":\"ok\",\"reference_radius\":0.5,\"error\":{\"rmse\":0.1}}\n");
    char *page = make_page();
    assert_null(strstr(page, "id=targets"));
    assert_non_null(strstr(page, "Against the truth within 0.5 scene units</h3>"));
    free(page);
}

/* The bound of a capture and the traced truth are two questions at one radius; so are two radii that six digits do not
 * tell apart. */
static void test_each_target_has_its_name(void **state)
{
    struct aob_rows rows;
    (void)state;
    put("run.json", "{}");
    put("journal.jsonl",
        "{\"key\":\"a\",\"status\":\"ok\",\"reference_radius\":1,\"error\":{\"rmse\":0.1}}\n"
        "{\"key\":\"b\",\"status\":\"ok\",\"reference_radius\":1,"
        "\"error\":{\"rmse\":0.2,\"reference\":\"screen\"}}\n"
        "{\"key\":\"c\",\"status\":\"ok\",\"reference_radius\":1.0000002,\"error\":{\"rmse\":0.3}}\n");
    read_rows(&rows);
    assert_int_equal(rows.target_count, 3);
    static const char *const said[] = {"the truth within 1 scene unit",
                                       "the screen-space bound within 1 scene unit",
                                       "the truth within 1.0000002 scene units"};
    static const char *const slugs[] = {"1-cosine", "1-cosine-screen", "1.0000002-cosine"};
    for (size_t i = 0; i < 3; i++) {
        char *name = aob_target_say(&rows.targets[i]), *slug = aob_target_slug(&rows.targets[i]);
        assert_string_equal(name, said[i]);
        assert_string_equal(slug, slugs[i]);
        free(name);
        free(slug);
    }
    aob_rows_finish(&rows);
    char *page = make_page();
    assert_non_null(
        strstr(strstr(page, "id=cases"), "Against the screen-space bound within 1 scene unit</h3>"));
    free(page);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_most_accurate_is_of_a_target),
        cmocka_unit_test(test_no_chart_joins_targets),
        cmocka_unit_test(test_a_perfect_case_is_not_passed_over),
        cmocka_unit_test(test_the_page_shows_one_at_a_time),
        cmocka_unit_test(test_old_records),
        cmocka_unit_test(test_each_target_has_its_name),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
