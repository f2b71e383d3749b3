/* The part of a page that is about sequences: its figures are those of the journal, beside the target that they are against. */
#include "reports/page/gallery_plan.h"
#include "run_text.h"

/* A case whose own target is a radius of 1, the second of two. */
static void add_sequence(struct aob_text *journal, const char *key, const char *technique,
                         const char *sequence)
{
    static const char far[] =
        "\"target\":{\"radius\":1,\"weighting\":\"cosine\"},\"rmse\":0.25,\"band_rmse\":0.5";
    aob_text_add(
        journal,
        "{\"key\":\"%s\",\"scene\":\"corner\",\"view\":\"front-3-frames\",\"technique\":\"%s\","
        "\"camera\":{\"eye\":[1,2,3.5],\"target\":[0,0,0]},\"motion\":{\"frames\":3,\"eye\":[0.25,2,3.5],"
        "\"target\":[0,0,0]},\"backend\":\"vulkan\",\"width\":64,\"height\":32,\"status\":\"ok\",\"time\":{"
        "\"clock\":\"cpu\","
        "\"cpu_ms\":2.5},\"sequence\":%s,\"error\":{%s,\"flicker\":0.0375},\"errors\":["
        "{\"target\":{\"radius\":0.25,\"weighting\":\"cosine\"},\"rmse\":0.5,\"band_rmse\":0.5,"
        "\"flicker\":0.0625},{%s,\"flicker\":0.0375}]}\n",
        key, technique, sequence, far, far);
}

static const char one[] =
    "{\"frames\":3,\"error\":[0.125,0.1875,0.25],\"error_mean\":0.1875,\"flicker\":0.0375,"
    "\"truth_change\":0.0125,\"compared\":0.96}";

static void test_the_table(void **state)
{
    struct aob_text journal = {0};
    (void)state;
    add_sequence(&journal, "a", "gtao", one);
    add_sequence(&journal, "b", "hbao", "null");
    put("run.json", "{}");
    put("journal.jsonl", journal.data);
    char *page = make_page(), *part = strstr(page, "<h4>Over time</h4>");
    assert_non_null(part);
    assert_int_equal(count_text(page, "<h4>Over time</h4>"), 1); /* of the case's own target only */
    assert_true(part > strstr(page, "within 1 scene unit"));
    assert_non_null(strstr(part, "goes from (0.25, 2, 3.5) to (1, 2, 3.5), and looks at (0, 0, 0) first"));
    char *end = strstr(part, "</table>");
    *end = '\0';
    assert_int_equal(count_text(part, "<tr><td"), 1);
    assert_non_null(strstr(part, "2.50"));
    assert_non_null(strstr(part, "0.1875"));
    assert_non_null(strstr(part, "0.0375"));
    assert_non_null(strstr(part, "0.0125"));
    assert_non_null(strstr(part, "96.0\u00a0%"));
    assert_null(strstr(part, "0.0625"));
    assert_non_null(strstr(end + 1, "0.0625")); /* the table of cases has the other target's flicker */
    free(page);
    aob_text_finish(&journal);
}

/* By the time of a frame; what has no flicker has no point. */
static void check_flicker(const json_t *series)
{
    const json_t *points = json_array_get(series, 0);
    assert_int_equal(json_array_size(series), 1);
    assert_string_equal(json_string_value(json_object_get(points, "name")), "gtao");
    assert_true(json_number_value(json_array_get(json_object_get(points, "x"), 0)) == 2.5);
    assert_true(json_number_value(json_array_get(json_object_get(points, "y"), 0)) == 0.0375);
}

static void test_the_chart(void **state)
{
    struct aob_text journal = {0};
    struct aob_rows rows;
    struct aob_gallery gallery;
    size_t charts = 0;
    (void)state;
    add_sequence(&journal, "a", "gtao", one);
    add_sequence(&journal, "b", "hbao", "{\"error\":[0.5,null,1]}");
    put("run.json", "{}");
    put("journal.jsonl", journal.data);
    read_rows(&rows);
    aob_gallery_plan(&gallery, &rows);
    for (size_t i = 0; i < gallery.count; i++) {
        const json_t *series = json_object_get(gallery.figures[i].job, "series"), *second;
        if (gallery.figures[i].kind != AOB_FIGURE_OVER_TIME)
            continue;
        charts++;
        if (json_array_size(json_object_get(json_array_get(series, 0), "y")) == 1) {
            check_flicker(series);
            continue;
        }
        assert_int_equal(json_array_size(series), 2);
        assert_string_equal(json_string_value(json_object_get(json_array_get(series, 0), "name")), "gtao");
        json_t *y = json_object_get(json_array_get(series, 0), "y");
        assert_true(json_number_value(json_array_get(y, 0)) == 0.125 &&
                    json_number_value(json_array_get(y, 2)) == 0.25);
        second = json_array_get(series, 1); /* a frame without a number is left out */
        assert_int_equal(json_array_size(json_object_get(second, "y")), 2);
        assert_int_equal(json_integer_value(json_array_get(json_object_get(second, "x"), 1)), 2);
    }
    assert_int_equal(charts, 4); /* the error and the flicker, as SVG and as PNG */
    aob_gallery_finish(&gallery);
    aob_rows_finish(&rows);
    aob_text_finish(&journal);
}

static void test_pictures_have_none(void **state)
{
    struct aob_text journal = {0};
    (void)state;
    add_case(&journal, "a", "gtao", 1, 2, 0.1, 0.2);
    put("run.json", "{}");
    put("journal.jsonl", journal.data);
    char *page = make_page();
    assert_null(strstr(page, "Over time"));
    free(page);
    aob_text_finish(&journal);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_the_table), cmocka_unit_test(test_the_chart),
                                       cmocka_unit_test(test_pictures_have_none)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
