#include "reports/page/page.h"
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "store/image.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cmocka.h>

struct fixture {
    char folder[128], out[160];
};

static void put(const struct fixture *f, const char *name, const char *text)
{
    char *path = aob_path_join(f->folder, name);
    struct aob_error error = {0};
    if (!aob_file_write(path, text, strlen(text), &error))
        fail_msg("%s", error.text);
    free(path);
}

static char *make_page(const struct fixture *f, const char *program, struct aob_page_summary *summary)
{
    const char *const folders[] = {f->folder, NULL};
    struct aob_error error = {0};
    if (!aob_page_write(&(struct aob_page_desc){folders, f->out, program, summary}, &error))
        fail_msg("%s", error.text);
    char *path = aob_path_join(f->out, "index.html");
    char *text = aob_file_read(path, 1 << 26, NULL, &error);
    assert_non_null(text);
    free(path);
    return text;
}

static size_t count_text(const char *text, const char *part)
{
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, part)); at += strlen(part))
        count++;
    return count;
}

/* A good case; `samples` and `cost` vary. */
static void add_case(struct aob_text *journal, const char *key, const char *backend, int samples, double cost)
{
    aob_text_add(
        journal,
        "{\"key\":\"%s\",\"scene\":\"corner\",\"view\":\"front\",\"technique\":\"gtao\",\"revision\":1,"
        "\"params\":{\"radius\":0.5,\"slices\":%d,\"steps\":2},\"options\":{\"fetch\":\"sampled\"},"
        "\"backend\":\"%s\",\"width\":64,\"height\":32,\"status\":\"ok\",\"image\":\"images/a.exr\",\"time\":"
        "{\"clock\":\"cpu\",\"cpu_ms\":%g,\"wall_ms\":null,\"ratio_to_ref\":2,\"ci_low\":1.9,\"ci_high\":2.2}"
        ","
        "\"error\":{\"rmse\":0.05,\"band_rmse\":%g,\"bias\":-0.0123,\"p95\":null},\"memory_bytes\":1048576,"
        "\"fingerprint\":{\"cpu\":\"a processor\",\"device\":\"llvmpipe\",\"driver\":\"Mesa\"}}\n",
        key, samples, backend, cost, 0.1 / cost);
}

static void test_good_run(void **state)
{
    struct aob_text journal = {0};
    struct aob_page_summary summary;
    add_case(&journal, "a", "vulkan", 1, 1.5);
    add_case(&journal, "b", "vulkan", 2, 2.5);
    add_case(&journal, "c", "gl-egl", 1, 1.75);
    put(*state, "journal.jsonl", journal.data);
    put(*state, "run.json", "{\"name\":\"demo\",\"cases\":3,\"date\":\"2026-01-02\",\"program\":\"0.1.0\"}");
    char *page = make_page(*state, NULL, &summary);
    assert_int_equal(summary.cases, 3);
    assert_int_equal(summary.ok, 3);
    assert_int_equal(summary.planned, 3);
    assert_int_equal(summary.drawn, 0);
    assert_null(strstr(page, "Incomplete"));
    assert_null(strstr(page, "What did not run"));
    assert_non_null(strstr(page, "2.000 <small>[1.900, 2.200]</small>"));
    assert_non_null(strstr(page, "\u22120.0123"));
    assert_non_null(strstr(page, "a processor"));
    assert_int_equal(count_text(page, "<tr><td"), 3);
    /* One triptych, of the first backend, and one height field; a quality and a samples chart. */
    assert_int_equal(count_text(page, "this figure was not drawn"), 4);
    assert_int_equal(summary.figures, 4 + 2 * 2);
    assert_non_null(strstr(page, "2 cases on the Pareto front"));
    assert_null(strstr(page, "http://"));
    assert_null(strstr(page, "https://"));
    free(page);
    aob_text_finish(&journal);
}

/* The line of a case whose error is `error`, JSON. */
static void add_scored(struct aob_text *journal, const char *technique, const char *error)
{
    aob_text_add(
        journal,
        "{\"key\":\"%s\",\"scene\":\"corner\",\"view\":\"front\",\"technique\":\"%s\",\"backend\":"
        "\"vulkan\",\"width\":64,\"height\":32,\"status\":\"ok\",\"image\":\"images/a.exr\",\"error\":%s}\n",
        technique, technique, error);
}

/* 0.1^2 = 0.06^2 + 0.1^2 + 0.02^2 - 2 x 0.002: 36 + 100 + 4 - 40 %. */
static const char SPLIT[] =
    "{\"rmse\":0.1,\"band_rmse\":0.1,\"border_share\":0.25,\"definition_rmse\":0.06,\"missing_rmse\":0.1,"
    "\"estimator_rmse\":0.02,\"covariance\":{\"definition_missing\":-0.001,\"definition_estimator\":0.0005,"
    "\"missing_estimator\":-0.0015}}";

static void test_where_errors_come_from(void **state)
{
    struct aob_text journal = {0};
    struct aob_page_summary summary;
    add_scored(&journal, "gtao", SPLIT);
    add_scored(&journal, "none", "{\"rmse\":0.2,\"band_rmse\":0.2,\"estimator_rmse\":null}");
    add_scored(&journal, "old", "{\"rmse\":0.3,\"band_rmse\":0.3}");
    add_scored(&journal, "unscored", "null");
    add_scored(&journal, "captured",
               "{\"reference\":\"screen\",\"rmse\":0.1,\"band_rmse\":0.1,\"definition_rmse\":0,"
               "\"missing_rmse\":0,\"estimator_rmse\":0.1,\"covariance\":{}}");
    put(*state, "journal.jsonl", journal.data);
    char *page = make_page(*state, NULL, &summary);
    char *split = strstr(page, "Where the error comes from");
    assert_non_null(split);
    assert_non_null(strstr(split, "0.0600 <small>36\u00a0%</small>"));
    assert_non_null(strstr(split, "0.1000 <small>100\u00a0%</small>"));
    assert_non_null(strstr(split, "0.0200 <small>4\u00a0%</small>"));
    assert_non_null(strstr(split, "\u22120.0040 <small>\u221240\u00a0%</small>"));
    assert_non_null(strstr(split, "data-v=\"0.25\">0.2500</td>"));
    assert_int_equal(count_text(page, "not split: it has no definition"), 1);
    assert_int_equal(count_text(page, "not split: an older record"), 1);
    assert_int_equal(count_text(page, "image: there is no reference"), 1);
    assert_int_equal(count_text(page, "not known of a capture"), 1);
    /* Five triptychs and .vti, four maps, two splits, a landscape for each of the two targets, since the capture's bound
     * is one of its own; the unscored one is in both tables of all cases only. */
    assert_int_equal(summary.figures, 5 + 5 + 4 + 2 + 2);
    assert_int_equal(count_text(page, "<tr><td"), 4 + 4 + 2);
    free(page);
    aob_text_finish(&journal);
}

/* Once beside the device, whichever of its cases says it. */
static void test_a_clock_that_is_not_trusted(void **state)
{
    struct aob_page_summary summary;
    put(*state, "run.json", "{\"name\":\"clock\",\"cases\":3}");
    put(*state, "journal.jsonl",
        "{\"key\":\"1\",\"status\":\"failed\",\"backend\":\"vulkan\",\"fingerprint\":{\"device\":\"one\"}}\n"
        "{\"key\":\"2\",\"status\":\"ok\",\"backend\":\"vulkan\",\"fingerprint\":{\"device\":\"one\"},"
        "\"time\":{\"clock\":\"wall\",\"clock_reason\":\"it is <b>late</b>\"}}\n"
        "{\"key\":\"3\",\"status\":\"ok\",\"backend\":\"gl-egl\",\"fingerprint\":{\"device\":\"one\"},"
        "\"time\":{\"clock\":\"device\",\"clock_reason\":\"\"}}\n");
    char *page = make_page(*state, NULL, &summary);
    assert_int_equal(count_text(page, "costs are wall time: it is &lt;b&gt;late&lt;/b&gt;</dd>"), 1);
    assert_int_equal(count_text(page, "costs are wall time"), 1);
    assert_int_equal(count_text(page, "<dt>vulkan</dt>"), 1);
    free(page);
}

static void test_hostile_and_broken_lines(void **state)
{
    struct aob_page_summary summary;
    put(*state, "run.json",
        "{\"name\":\"<script>alert(1)</script>\",\"cases\":40,\"date\":7,\"program\":\"\\\"><img src=x>\"}");
    put(*state, "journal.jsonl",
        "{\"key\":\"1\",\"scene\":\"</td><script>x</script>\",\"view\":\"\\\" "
        "onload='y'\",\"technique\":\"<i>&amp;\","
        "\"params\":{\"<b>\":\"'\\\"\"},\"backend\":\"<u>\",\"width\":1e9,\"height\":-1,\"status\":\"ok\","
        "\"image\":"
        "\"../../"
        "<script>.exr\",\"time\":{\"cpu_ms\":1e308},\"error\":{\"band_rmse\":1e-300,\"bias\":\"inf\"}}\n"
        "{\"key\":\"2\",\"status\":\"failed\",\"reason\":\"crashed: "
        "<script>z</script>\",\"technique\":\"hbao\"}\n"
        "{\"key\":\"3\",\"status\":\"\\\"><script>\",\"time\":[],\"error\":3,\"params\":[1],\"options\":"
        "\"o\","
        "\"fingerprint\":{\"device\":\"<dev>\",\"threads\":{}}}\n"
        "not json\n[1,2]\n\n{\"key\":\"2\",\"status\":\"unsupported\",\"reason\":\"no <b>image</b>\"}\n"
        "{\"key\":\"4\",\"scene\":null,\"width\":null,\"status\":\"invalid\",\"reason\":null}\n"
        "{\"key\":\"5\",\"sce");
    char *page = make_page(*state, NULL, &summary);
    assert_int_equal(summary.cases, 4);
    assert_non_null(strstr(page, "Incomplete: 4 of 40 cases"));
    assert_int_equal(count_text(page, "<script>"), 1);
    assert_non_null(strstr(page, "&lt;script&gt;alert(1)"));
    assert_null(strstr(page, "<b>"));
    assert_null(strstr(page, "<u>"));
    assert_null(strstr(page, "<i>"));
    assert_null(strstr(page, "<dev>"));
    assert_null(strstr(page, "<img src=x"));
    assert_null(strstr(page, "onload='"));
    assert_non_null(strstr(page, "no &lt;b&gt;image"));
    assert_null(strstr(page, "crashed: "));
    free(page);
}

static void test_empty_journal(void **state)
{
    struct aob_page_summary summary;
    put(*state, "journal.jsonl", "");
    put(*state, "run.json", "{\"name\":\"early\",\"cases\":12}");
    char *page = make_page(*state, NULL, &summary);
    assert_non_null(strstr(page, "Incomplete: 0 of 12 cases"));
    assert_int_equal(summary.figures, 0);
    free(page);
}

static void test_no_run_and_no_room(void **state)
{
    struct fixture *f = *state;
    struct aob_error error = {0};
    const char *const none[] = {"/nonexistent/run", NULL}, *const good[] = {f->folder, NULL};
    assert_false(aob_page_write(&(struct aob_page_desc){.folders = none, .out = f->out}, &error));
    assert_non_null(strstr(error.text, "/nonexistent/run"));
    put(f, "journal.jsonl", "");
    assert_false(aob_page_write(&(struct aob_page_desc){.folders = good, .out = "/proc/nowhere"}, &error));
    assert_int_not_equal(error.text[0], 0);
}

/* Without a list of keys nothing is known to be of another state of the program. */
static void test_no_list_of_keys(void **state)
{
    struct aob_text journal = {0};
    struct aob_page_summary summary;
    add_case(&journal, "a", "vulkan", 1, 1.5);
    put(*state, "journal.jsonl", journal.data);
    put(*state, "run.json", "{\"name\":\"demo\",\"cases\":1,\"keys\":null}");
    free(make_page(*state, NULL, &summary));
    assert_int_equal(summary.cases, 1);
    put(*state, "run.json", "{\"name\":\"demo\",\"cases\":1,\"keys\":[\"b\"]}");
    free(make_page(*state, NULL, &summary));
    assert_int_equal(summary.cases, 0);
    aob_text_finish(&journal);
}

static void test_a_folder_twice(void **state)
{
    struct fixture *f = *state;
    struct aob_error error = {0};
    char *again = aob_path_join(f->folder, ".");
    const char *const folders[] = {f->folder, again, NULL};
    put(f, "journal.jsonl", "");
    assert_false(aob_page_write(&(struct aob_page_desc){.folders = folders, .out = f->out}, &error));
    assert_non_null(strstr(error.text, "is the same folder as"));
    assert_non_null(strstr(error.text, again));
    free(again);
}

/* A plotter that draws one figure's worth of answers and dies. */
static void test_crashing_plotter(void **state)
{
    struct fixture *f = *state;
    struct aob_text journal = {0};
    struct aob_page_summary summary;
    add_case(&journal, "a", "vulkan", 1, 1.5);
    put(f, "journal.jsonl", journal.data);
    put(f, "aobudget-plot",
        "#!/bin/sh\ncat >/dev/null\necho '{\"out\":\"x\",\"error\":null}'\necho "
        "'{\"out\":\"y\",\"error\":\"no <room>\"}'\n"
        "echo nonsense\nkill -SEGV $$\n");
    char *plotter = aob_path_join(f->folder, "aobudget-plot"),
         *program = aob_path_join(f->folder, "aobudget");
    chmod(plotter, 0755);
    char *page = make_page(f, program, &summary);
    assert_int_equal(summary.drawn, 1);
    assert_non_null(strstr(page, "signal 11"));
    assert_non_null(strstr(page, "no &lt;room&gt;"));
    assert_int_equal(count_text(page, "<img "), 1);
    unlink(plotter);
    free(plotter);
    free(program);
    free(page);
    aob_text_finish(&journal);
}

static void write_image(const struct fixture *f)
{
    static const char *const names[] = {"technique.AO", "reference.AO", "error.AO", "definition.AO",
                                        "screen.AO"};
    struct aob_image image = {.width = 64, .height = 32};
    for (size_t c = 0; c < AOB_COUNT(names); c++) {
        float *pixels = aob_image_add(&image, names[c]);
        for (int i = 0; i < 64 * 32; i++)
            pixels[i] = c == 2 ? 0.001f * (float)(i % 64 - 32) : 0.5f + 0.005f * (float)(i % 64);
    }
    char *folder = aob_path_join(f->folder, "images"), *path = aob_path_join(folder, "a.exr");
    assert_true(aob_folder_create(folder, NULL) && aob_image_write(&image, path, NULL));
    free(folder);
    free(path);
    aob_image_finish(&image);
}

static void test_real_plotter(void **state)
{
    struct aob_text journal = {0};
    struct aob_page_summary summary;
    const char *build = getenv("AOBUDGET_BUILD");
    char *program = aob_path_join(build ? build : ".", "aobudget");
    char *plotter = aob_path_join(build ? build : ".", "aobudget-plot");
    if (aob_file_exists(plotter)) {
        add_case(&journal, "a", "vulkan", 1, 1.5);
        add_case(&journal, "b", "vulkan", 2, 2.5);
        add_scored(&journal, "hbao", SPLIT);
        put(*state, "journal.jsonl", journal.data);
        write_image(*state);
        char *page = make_page(*state, program, &summary);
        assert_int_equal(summary.figures, 8 + 4);
        assert_int_equal(summary.drawn, 8 + 4);
        assert_int_equal(count_text(page, "-hbao-split.png\"><img"), 1);
        assert_null(strstr(page, "-gtao-split.png"));
        assert_null(strstr(page, "this figure was not drawn"));
        free(page);
    }
    free(program);
    free(plotter);
    aob_text_finish(&journal);
}

static int set_up(void **state)
{
    struct fixture *f = AOB_NEW(struct fixture);
    snprintf(f->folder, sizeof f->folder, "/tmp/aob-test-page-%ld", (long)getpid());
    snprintf(f->out, sizeof f->out, "%s/report", f->folder);
    *state = f;
    return aob_folder_create(f->folder, NULL) ? 0 : -1;
}

static int tear_down(void **state)
{
    struct fixture *f = *state;
    char command[256];
    snprintf(command, sizeof command, "rm -r '%s'", f->folder);
    int code = system(command);
    free(f);
    return code;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_good_run, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_where_errors_come_from, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_clock_that_is_not_trusted, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_hostile_and_broken_lines, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_empty_journal, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_no_run_and_no_room, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_no_list_of_keys, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_a_folder_twice, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_crashing_plotter, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_real_plotter, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
