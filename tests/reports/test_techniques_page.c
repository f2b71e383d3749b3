/* The page of techniques from a small run made by hand: what is there, what is missing, and hostile names. */
#include "reports/page/techniques_page.h"
#include <stdlib.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "check.h"

static char folder[64];

static void put(const char *name, const char *text)
{
    char *path = aob_path_join(folder, name);
    assert_true(aob_file_write(path, text, strlen(text), NULL));
    free(path);
}

static char *make_page(struct aob_techniques_summary *summary)
{
    struct aob_error error = {""};
    char *file = aob_path_join(folder, "out/page.md");
    if (!aob_techniques_page_write(&(struct aob_techniques_desc){folder, file, NULL}, summary, &error))
        fail_msg("%s", error.text);
    char *text = aob_file_read(file, 1 << 20, NULL, &error);
    assert_non_null(text);
    free(file);
    return text;
}

#define PARAM                                                                                                \
    "{\"name\":\"radius\",\"doc\":\"Reach | of "                                                             \
    "it\",\"type\":\"float\",\"unit\":\"scene_units\",\"scale\":\"log2\","                                   \
    "\"stage\":\"uniform\",\"min\":0.1,\"max\":9,\"initial\":0.5}"
#define CHOICE                                                                                               \
    "{\"name\":\"weighting\",\"doc\":\"Of "                                                                  \
    "directions\",\"unit\":\"none\",\"min\":0,\"max\":0,\"initial\":0,\"choices\":["                         \
    "\"cosine\",\"uniform\"]}"

static void write_run(const char *technique)
{
    struct aob_text info = {0};
    aob_text_add(&info,
                 "{\"name\":\"docs\",\"cases\":4,\"date\":\"2026-01-02\",\"program\":\"0.1.0\","
                 "\"techniques\":[{\"name\":\"%s\","
                 "\"title\":\"A <b>title</b>\",\"citation\":\"Who, *What*\",\"notes\":\"a_b, "
                 "_c_\",\"sampling\":\"slices\","
                 "\"sequence\":\"stratified\",\"params\":[" PARAM "," CHOICE "]}]}",
                 technique);
    put("run.json", info.data);
    aob_text_finish(&info);
}

static void add_case(struct aob_text *journal, const char *scene, double radius, const char *status,
                     const char *score)
{
    aob_text_add(
        journal,
        "{\"key\":\"%s%g\",\"scene\":\"%s\",\"view\":\"v\",\"technique\":\"t\",\"params\":{\"radius\":%g,"
        "\"weighting\":\"cosine\"},\"options\":{\"guard_band\":64},\"backend\":\"vulkan\",\"width\":64,"
        "\"height\":32,"
        "\"status\":\"%s\",\"reason\":\"no | way\",\"image\":\"images/a.exr\",\"definition\":{\"radius\":0.5,"
        "\"weighting\":\"uniform\",\"falloff\":[1,0.75,0.5,0.25,0],\"mapped\":true},\"time\":{\"ratio_to_"
        "ref\":2,"
        "\"ci_low\":1.9,\"ci_high\":2.2},\"error\":{\"rmse\":0.05,\"band_rmse\":0.07,\"bias\":-0.0123%s},"
        "\"memory_bytes\":2048,\"fingerprint\":{\"cpu\":\"a processor\",\"cores\":2,\"device\":\"d\"}}\n",
        scene, radius, scene, radius, status, score);
}

static void the_page_says_what_the_run_holds(void **state)
{
    (void)state;
    struct aob_text journal = {0};
    struct aob_techniques_summary summary;
    write_run("t");
    add_case(&journal, "hall", 9, "ok", ",\"oops\":1");
    add_case(&journal, "hall", 0.5, "ok", "");
    add_case(&journal, "yard", 0.5, "failed", "");
    add_case(&journal, "corner", 0.5, "ok",
             ",\"oracle\":{\"name\":\"O2\",\"claim\":\"V = "
             "*1*\",\"rmse\":0.01,\"band_rmse\":0.0345,\"bias\":0.002,"
             "\"reference_rmse\":0.001,\"reference_band_rmse\":0.0027,\"pixels\":99,\"band_pixels\":33}");
    put("journal.jsonl", journal.data);
    char *page = make_page(&summary);
    assert_int_equal(summary.techniques, 1);
    assert_int_equal(summary.planned, 4);
    assert_int_equal(summary.ok, 3);
    assert_int_equal(summary.figures,
                     1); /* of the case at defaults; neither the oracle's nor the failed one's */
    assert_int_equal(summary.drawn, 0);
    assert_contains(page, "## `t`: A &#60;b&#62;title&#60;/b&#62;\n");
    assert_contains(page, "Who, &#42;What&#42;");
    assert_contains(page, "a_b, &#95;c&#95;");
    assert_contains(page, "| `radius` | 0.5 m | 0.1 .. 9 | scene units | Reach &#124; of it |\n");
    assert_contains(page, "| `weighting` | `cosine` | `cosine`, `uniform` | \u2013 | Of directions |\n");
    assert_contains(
        page,
        "directions weighted evenly, occluders up to 0.5 scene units away; one counts 1, 0.75, 0.5, 0.25, 0");
    assert_contains(page, "the result is mapped.");
    assert_contains(page, "`hall/v`: the picture was not drawn: aobudget-plot is not there");
    assert_contains(page, "`yard/v`: failed, no &#124; way");
    assert_contains(page,
                    "| `hall/v` | 2.000 [1.900, 2.200] | 2 | 0.0500 | 0.0700 | \u22120.0123 | \u2013 |\n");
    assert_contains(page, "- **O2**, `corner/v`: V = &#42;1&#42;\n");
    assert_contains(page, "| *ray-traced truth* | 0.0027 |\n| `t` | 0.0345 |\n");
    assert_contains(page, "| O2 | `corner/v` | 99 | 0.0100 | 33 | 0.0345 | 0.0020 |\n");
    assert_contains(page, "Measured on a processor (2 cores), `vulkan`: d");
    assert_null(strstr(page, "oops"));
    assert_null(strstr(page, "<b>"));
    free(page);
    aob_text_finish(&journal);
}

static void an_empty_journal_and_hostile_names_make_a_page(void **state)
{
    (void)state;
    struct aob_techniques_summary summary;
    write_run("<script>|`x`](y)");
    put("journal.jsonl", "");
    char *page = make_page(&summary);
    assert_contains(page, "Incomplete: 0 of 4 cases");
    assert_contains(page, "No case of this run has a closed form");
    assert_contains(page, "## &#60;script&#62;&#124;&#96;x&#96;&#93;(y): ");
    assert_null(strstr(page, "<script>"));
    free(page);
}

static void what_is_no_such_run_is_refused(void **state)
{
    (void)state;
    struct aob_error error = {""};
    struct aob_techniques_summary summary;
    put("run.json", "{\"name\":\"old\",\"cases\":1}");
    assert_false(
        aob_techniques_page_write(&(struct aob_techniques_desc){folder, "x.md", NULL}, &summary, &error));
    assert_contains(error.text, "describes no techniques");
    assert_false(
        aob_techniques_page_write(&(struct aob_techniques_desc){folder, "x.html", NULL}, &summary, &error));
    assert_contains(error.text, "ends in .md");
    assert_false(aob_techniques_page_write(&(struct aob_techniques_desc){"/nonexistent", "x.md", NULL},
                                           &summary, &error));
    assert_contains(error.text, "/nonexistent");
}

static int set_up(void **state)
{
    (void)state;
    snprintf(folder, sizeof folder, "/tmp/aob-test-techniques-%ld", (long)getpid());
    return aob_folder_create(folder, NULL) ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    char command[128];
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    return system(command);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(the_page_says_what_the_run_holds, set_up, tear_down),
        cmocka_unit_test_setup_teardown(an_empty_journal_and_hostile_names_make_a_page, set_up, tear_down),
        cmocka_unit_test_setup_teardown(what_is_no_such_run_is_refused, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
