/* Several targets in one run: each has its own front, its own most accurate cases and its own table. And what else is
 * read off all cases: labels, cases.csv, whether backends agree. */
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "check.h"
#include "reports/page/gallery_plan.h"
#include "reports/page/page.h"
#include "store/image.h"

static char folder[64];

static void put(const char *name, const char *text)
{
    char *path = aob_path_join(folder, name);
    assert_true(aob_file_write(path, text, strlen(text), NULL));
    free(path);
}

static char *get(const char *name)
{
    char *path = aob_path_join(folder, name), *text = aob_file_read(path, 1 << 24, NULL, NULL);
    assert_non_null(text);
    free(path);
    return text;
}

static char *make_page(void)
{
    const char *const folders[] = {folder, NULL};
    char *out = aob_path_join(folder, "report");
    struct aob_error error = {""};
    if (!aob_page_write(&(struct aob_page_desc){.folders = folders, .out = out}, &error))
        fail_msg("%s", error.text);
    free(out);
    return get("report/index.html");
}

/* Against 0.25 and 1, by the cases' own radius. */
static void add_case(struct aob_text *journal, const char *key, const char *technique, double radius,
                     double cost, double small, double large)
{
    char near[128], far[128];
    snprintf(near, sizeof near,
             "\"target\":{\"radius\":0.25,\"weighting\":\"cosine\"},\"rmse\":%g,\"band_rmse\":%g", small / 2,
             small);
    snprintf(far, sizeof far,
             "\"target\":{\"radius\":1,\"weighting\":\"cosine\"},\"rmse\":%g,\"band_rmse\":%g", large / 2,
             large);
    aob_text_add(
        journal,
        "{\"key\":\"%s\",\"scene\":\"corner\",\"view\":\"front\",\"technique\":\"%s\","
        "\"params\":{\"radius\":%g,\"steps\":6,\"blur\":0},\"options\":{\"fetch\":\"sampled\",\"guard_band\":"
        "64},"
        "\"backend\":\"vulkan\",\"width\":64,\"height\":32,\"status\":\"ok\",\"image\":\"images/%s.exr\","
        "\"time\":{\"clock\":\"cpu\",\"cpu_ms\":%g},\"error\":{%s},"
        "\"errors\":[{%s,\"truth\":\"truths/near.exr\"},{%s,\"truth\":\"truths/far.exr\"}]}\n",
        key, technique, radius, key, cost, radius == 1 ? far : near, near, far);
}

/* a: the best against 0.25; b: against 1; c: another technique, the cheapest, made for 0.25. */
static void write_run(void)
{
    struct aob_text journal = {0};
    add_case(&journal, "a", "gtao", 0.25, 2, 0.01, 0.3);
    add_case(&journal, "b", "gtao", 1, 4, 0.2, 0.02);
    add_case(&journal, "c", "hbao", 0.25, 1, 0.05, 0.4);
    put("journal.jsonl", journal.data);
    put("run.json", "{\"name\":\"two\",\"cases\":3,\"techniques\":[{\"name\":\"gtao\",\"params\":["
                    "{\"name\":\"radius\",\"initial\":0.25},{\"name\":\"steps\",\"initial\":6},{\"name\":"
                    "\"blur\",\"initial\":5}]}]}");
    aob_text_finish(&journal);
}

static void read_rows(struct aob_rows *rows)
{
    const char *const folders[] = {folder};
    struct aob_error error = {""};
    if (!aob_rows_read(rows, folders, 1, &error))
        fail_msg("%s", error.text);
}

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

static size_t count_text(const char *text, const char *part)
{
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, part)); at += strlen(part))
        count++;
    return count;
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

/* Varying first (radius, of gtao only), then what is not at its default (blur; not steps), options likewise. */
static void test_labels(void **state)
{
    struct aob_rows rows;
    (void)state;
    write_run();
    read_rows(&rows);
    assert_string_equal(rows.list[0].label, "radius=0.25 blur=0 guard_band=64");
    assert_string_equal(rows.list[1].label, "radius=1 blur=0 guard_band=64");
    assert_string_equal(rows.list[2].label,
                        "guard_band=64"); /* run.json has no hbao: its defaults are not known */
    aob_rows_finish(&rows);
    char *page = make_page();
    assert_non_null(
        strstr(page, "title=\"radius=0.25 steps=6 blur=0 fetch=sampled guard_band=64\">radius=0.25 blur=0"));
    free(page);
}

static char *concat(const char *format, const char *a, const char *b, const char *c)
{
    struct aob_text text = {0};
    aob_text_add(&text, format, a, b, c);
    return text.data;
}

/* The lines of cases.csv from the second on, up to the metrics after band_rmse, which are empty. */
static void test_csv(void **state)
{
    (void)state;
    put("run.json", "{}");
    put("journal.jsonl",
        "{\"key\":\"k\",\"series\":\"s\",\"scene\":\"a \\\"b\\\", "
        "c\",\"view\":\"two\\nlines\",\"technique\":\"gtao\","
        "\"params\":{\"radius\":0.5,\"mode\":\"x\"},\"backend\":\"vulkan\",\"width\":64,"
        "\"height\":32,\"status\":\"ok\",\"options\":{\"fetch\":\"sampled\",\"guard_band\":64},"
        "\"memory_bytes\":2048,\"time\":{\"clock\":\"wall\",\"wall_ms\":1.5,\"ratio_to_"
        "ref\":2,\"ci_low\":1.75,\"ci_high\":"
        "null},\"errors\":[{\"target\":{\"radius\":\"inf\",\"weighting\":\"uniform\"},"
        "\"reference\":\"screen\",\"rmse\":0.125,\"pixels\":2048},"
        "{\"target\":{\"radius\":0.1,\"weighting\":\"cosine\"},\"rmse\":0.25}]}\n"
        "{\"key\":\"l\",\"status\":\"failed\",\"reason\":\"no image\"}\n");
    free(make_page());
    char *csv = get("report/cases.csv"), *line = strstr(csv, "\r\n");
    static const char head[] =
        "key,series,run,scene,view,technique,params,options,backend,size,status,reason,target_radius,"
        "target_weighting,reference,time_ms,ratio_to_ref,ci_low,ci_high,memory_bytes,rmse,band_rmse,";
    static const char *const parts[] = {
        ",\"a \"\"b\"\", c\",\"two\nlines\",gtao,radius=0.5 mode=x,fetch=sampled "
        "guard_band=64,vulkan,64x32,ok,,",
        "0.1,cosine,ray-traced,1.5,2,1.75,,2048,0.25,,",
        "inf,uniform,screen,1.5,2,1.75,,2048,0.125,,",
    };
    char *first = concat("\r\nk,s,%s%s%s", folder, parts[0], parts[1]),
         *second = concat("\r\nk,s,%s%s%s", folder, parts[0], parts[2]),
         *third = concat("\r\nl,,%s%s%s", folder, ",,,,,,,,failed,no image,,,,,,,,,,", "");
    assert_memory_equal(csv, head, sizeof head - 1);
    assert_memory_equal(line, first, strlen(first));
    line = strstr(line + 2, "\r\n");
    assert_memory_equal(line, second, strlen(second));
    line = strstr(line + 2, "\r\n");
    assert_memory_equal(line, third, strlen(third));
    assert_string_equal(strstr(line + 2, "\r\n"), "\r\n");
    /* As many fields in the last line as names in the first. */
    size_t commas[2] = {0};
    for (const char *c = csv; *c != '\r'; c++)
        commas[0] += *c == ',';
    for (const char *c = line + 2; *c != '\r'; c++)
        commas[1] += *c == ',';
    assert_int_equal(commas[0], commas[1]);
    free(csv);
    free(first);
    free(second);
    free(third);
}

static void write_image(const char *name, float last)
{
    struct aob_image image = {.width = 4, .height = 4};
    float *pixels = aob_image_add(&image, "technique.AO");
    char *images = aob_path_join(folder, "images"), *path = aob_path_join(images, name);
    for (int i = 0; i < 16; i++)
        pixels[i] = i == 15 ? last : 0.5f;
    assert_true(aob_folder_create(images, NULL) && aob_image_write(&image, path, NULL));
    aob_image_finish(&image);
    free(images);
    free(path);
}

static void add_drawn(struct aob_text *journal, const char *backend, int steps, const char *image)
{
    aob_text_add(
        journal,
        "{\"key\":\"%s%d\",\"technique\":\"gtao\",\"params\":{\"steps\":%d},\"backend\":\"%s\",\"width\":4,"
        "\"height\":4,\"status\":\"ok\",\"image\":\"images/%s\"}\n",
        backend, steps, steps, backend, image);
}

static void test_agreement(void **state)
{
    struct aob_text journal = {0};
    (void)state;
    write_image("a.exr", 0.5f);
    write_image("b.exr", 0.25f);
    add_drawn(&journal, "vulkan", 1, "a.exr");
    add_drawn(&journal, "gl-egl", 1, "b.exr"); /* one pixel of 16 by 0.25 */
    add_drawn(&journal, "vulkan", 2, "a.exr");
    add_drawn(&journal, "gl-egl", 3, "b.exr"); /* of another case: no pair */
    add_drawn(&journal, "null", 1, "b.exr");   /* draws nothing */
    put("run.json", "{}");
    put("journal.jsonl", journal.data);
    char *page = make_page();
    assert_non_null(
        strstr(page, "<p>gl-egl and vulkan: 1 pair of images, largest difference 0.25 in any pixel, RMS "
                     "0.0625.</p>"));
    assert_int_equal(count_text(page, "of images"), 1);
    free(page);
    add_drawn(&journal, "vulkan", 4, "a.exr");
    add_drawn(&journal, "gl-egl", 4, "a.exr");
    add_drawn(&journal, "vulkan", 5, "a.exr");
    add_drawn(&journal, "gl-egl", 5, "none.exr");
    put("journal.jsonl", journal.data);
    page = make_page();
    assert_non_null(
        strstr(page, "<p>gl-egl and vulkan: 2 pairs of images, largest difference 0.25 in any pixel, RMS "
                     "0.0442; 1 more could not be read.</p>"));
    free(page);
    aob_text_finish(&journal);
}

/* One case in two runs, each on a backend of its own: a pair all the same. */
static void test_agreement_across_runs(void **state)
{
    struct aob_text first = {0}, second = {0};
    (void)state;
    char *other = aob_path_join(folder, "other"), *out = aob_path_join(folder, "report"),
         *images = aob_path_join(other, "images");
    assert_true(aob_folder_create(other, NULL) && aob_folder_create(images, NULL));
    write_image("a.exr", 0.5f);
    add_drawn(&first, "vulkan", 1, "a.exr");
    add_drawn(&second, "gl-egl", 1, "../../images/a.exr");
    put("run.json", "{}");
    put("journal.jsonl", first.data);
    put("other/journal.jsonl", second.data);
    const char *const folders[] = {folder, other, NULL};
    assert_true(aob_page_write(&(struct aob_page_desc){.folders = folders, .out = out}, NULL));
    char *page = get("report/index.html");
    assert_non_null(
        strstr(page, "<p>gl-egl and vulkan: 1 pair of images, largest difference 0 in any pixel"));
    free(page);
    free(images);
    free(out);
    free(other);
    aob_text_finish(&first);
    aob_text_finish(&second);
}

static int set_up(void **state)
{
    (void)state;
    snprintf(folder, sizeof folder, "/tmp/aob-test-targets-%ld", (long)getpid());
    return aob_folder_create(folder, NULL) ? 0 : -1;
}

static int tear_down(void **state)
{
    char command[128];
    (void)state;
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    return system(command);
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
        cmocka_unit_test(test_labels),
        cmocka_unit_test(test_csv),
        cmocka_unit_test(test_agreement),
        cmocka_unit_test(test_agreement_across_runs),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
