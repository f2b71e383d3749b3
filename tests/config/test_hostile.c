/* Configs of a megabyte that would take minutes or all memory: read or refused with one line that says what is wrong.
 * Without the bound that a row is about, the row runs into the time limit of the test. */
#include <stdlib.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "check.h"
#include "config/config.h"

static char path[256];
enum { MEGABYTE = 1 << 20 };

static void refuse(struct aob_text *text, const char *place, const char *says)
{
    struct aob_config config;
    struct aob_error error = {{0}};
    assert_true(text->size <= MEGABYTE);
    assert_true(aob_file_write(path, text->data, text->size, &error));
    assert_false(aob_config_read(&config, path, &error));
    assert_contains(error.text, path);
    assert_contains(error.text, place);
    assert_contains(error.text, says);
    aob_text_finish(text);
}

static void repeat(struct aob_text *text, const char *part, size_t end)
{
    while (text->size + strlen(part) < end)
        aob_text_add_bytes(text, part, strlen(part));
}

static void test_nesting(void **state)
{
    (void)state;
    static const char *const parts[] = {"[", "[a, ", "{a: ", "- ", "? ", "a: ["};
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        struct aob_text text = {0};
        repeat(&text, parts[i], MEGABYTE);
        refuse(&text, ":1:", "32 lists and mappings");
    }
    struct aob_text text = {0};
    aob_text_add(&text, "name: ");
    repeat(&text, "[", 6 + 33); /* the last of the 31 that the mapping leaves is at column 37 */
    refuse(&text, ":1:38: ", "32 lists and mappings");
}

static void test_anchors(void **state)
{
    (void)state;
    struct aob_text text = {0};
    aob_text_add(&text, "name: t\nscenes:\n");
    for (int i = 0; text.size < MEGABYTE - 20; i++)
        aob_text_add(&text, "- &a%d x\n", i);
    refuse(&text, ":259:3", "256 anchors");
    repeat(&text, "%TAG !a! tag:x\n", MEGABYTE / 2);
    refuse(&text, ":1:", "%TAG");
}

/* A million values by ten lines: 100 axes of 10,000 values each, again and again. */
static void test_aliases(void **state)
{
    (void)state;
    struct aob_text text = {0};
    aob_text_add(&text, "name: t\ntechniques:\n- &t {name: gtao, sweep: [&s {param: radius, values: &v [");
    repeat(&text, "1,", 20000);
    aob_text_add(&text, "1]}");
    repeat(&text, ", *s", 20400);
    aob_text_add(&text, "]}\n");
    repeat(&text, "- *t\n", MEGABYTE);
    refuse(&text, ":3:", "the aliases stand for more than 1000000 values");
}

static void test_many_keys(void **state)
{
    (void)state;
    struct aob_text text = {0};
    aob_text_add(&text, "name: t\noptions: {");
    for (int i = 0; text.size < MEGABYTE - 40; i++)
        aob_text_add(&text, "k%06d: 1, ", i);
    aob_text_add(&text, "k: 1}\n");
    refuse(&text, ":2:12011: ", "a mapping of more than 1000 keys");
    aob_text_add(&text, "name: t\noptions: {");
    for (int i = 0; i < 1000; i++)
        aob_text_add(&text, "k%06d: 1, ", i);
    aob_text_add(&text, "}\nscenes: []\n");
    refuse(&text, "", "'scenes' is missing");
    aob_text_add(&text, "name: t\noptions: {k0: 1, k1: 1, k0: 1}\n");
    refuse(&text, ":2:25: ", "key 'k0' stands here twice");
}

/* As a whole number of 64 bits the product is 0. */
static void test_products_that_overflow(void **state)
{
    (void)state;
    struct aob_text text = {0};
    aob_text_add(&text, "name: t\nscenes: [{name: corner}]\nresolutions: [8x8]\nbackends: [null]\n"
                        "techniques:\n- name: gtao\n  sweep:\n");
    for (int i = 0; i < 64; i++)
        aob_text_add(&text, "  - {param: k%d, values: [1, 1]}\n", i);
    refuse(&text, ":8:5: ", "more than 20000 cases, namely 1.84467e+19");
}

static void test_long_values(void **state)
{
    (void)state;
    struct aob_text text = {0};
    aob_text_add(&text, "name: t\nscenes: [{name: ");
    repeat(&text, "x", MEGABYTE / 2);
    aob_text_add(&text, ", views: [");
    repeat(&text, "a,", MEGABYTE - 10);
    aob_text_add(&text, "a]}]\n");
    refuse(&text, ":2:17", "4096 bytes");
    aob_text_add(&text, "name: t\nscenes: [{name: corner, views: [");
    repeat(&text, "a,", MEGABYTE - 10);
    aob_text_add(&text, "a]}]\n");
    refuse(&text, ":2:10", "20000 views");
}

/* What libyaml's reader refuses is told where it stands. */
static void test_bytes_that_are_no_text(void **state)
{
    (void)state;
    static const char *const cases[][2] = {
        {"name: t\nscenes: [{name: cor\033[31mner}]\n", ":2:20: not YAML: control characters"},
        {"name: t\n\n# \303\251\303\251\a\n", ":3:5: not YAML: control characters"},
        {"\001name: t\n", ":1:1: not YAML: control characters"},
        {"name: t\nscenes: [\377]\n", ":2:10: not YAML: invalid leading UTF-8"},
        {"\377\376%", ":1:1: not YAML: invalid leading UTF-8"}, /* how UTF-16 begins */
    };
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_text text = {0};
        aob_text_add(&text, "%s", cases[i][0]);
        refuse(&text, cases[i][1], "not YAML");
    }
}

/* Whatever list is the longest is named where it stands, though every axis has one value. */
static void test_the_longest_list_is_named(void **state)
{
    (void)state;
    static const struct {
        const char *text, *repeated, *end, *place, *says;
        int count;
    } cases[] = {
        {"name: t\nscenes: [{name: corner}]\nbackends: [null]\ntechniques: [{name: gtao, params: {radius: "
         "1}}]\n"
         "options: {near: 0}\nresolutions: [",
         "8x8, ", "8x8]\n", ":6:15: ", "20002: make a list shorter, such as 'resolutions' with its 20002",
         20001},
        {"name: t\nresolutions: [8x8, 9x9, 7x7]\nbackends: [null]\noptions: {near: [0, 1]}\n"
         "techniques: [{name: gtao, params: {radius: [1, 2], blur: 0}}]\nscenes: [{name: corner, views: [",
         "far, ", "far]}]\n", ":6:10: ", "'scenes' with its 5001", 5000},
        {"name: t\nscenes: [{name: corner}]\nresolutions: [8x8]\nbackends: [null]\n"
         "options: {near: 0, far: 0}\ntechniques: [{name: gtao, params: {steps: 1}}, ",
         "{name: none}, ", "{name: none}]\n", ":6:21: ", "'techniques' with its 20002", 20000},
        {"name: t\nscenes: [{name: corner}]\nresolutions: [8x8]\n"
         "techniques: [{name: gtao, params: {radius: 1, blur: 0}, backends: [",
         "null, ", "null]}]\n", ":4:68: ", "'backends' with its 20002", 20001},
    };
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_text text = {0};
        aob_text_add(&text, "%s", cases[i].text);
        for (int k = 0; k < cases[i].count; k++)
            aob_text_add(&text, "%s", cases[i].repeated);
        aob_text_add(&text, "%s", cases[i].end);
        refuse(&text, cases[i].place, cases[i].says);
    }
}

/* As many cases as are allowed. */
static void test_the_bound_is_read(void **state)
{
    (void)state;
    struct aob_text text = {0};
    struct aob_config config;
    struct aob_error error = {{0}};
    aob_text_add(&text, "name: t\nscenes: [{name: corner}]\nbackends: [null]\ntechniques: [{name: gtao}]\n"
                        "options: {near: [0, 1], far: [2, 3]}\nresolutions: [");
    for (int i = 0; i < AOB_CONFIG_MAX_CASES / 4; i++)
        aob_text_add(&text, "8x8, ");
    aob_text_add(&text, "]\n");
    assert_true(aob_file_write(path, text.data, text.size, &error));
    assert_true(aob_config_read(&config, path, &error));
    assert_int_equal(config.size_count, 5000);
    aob_config_finish(&config);
    aob_text_finish(&text);
}

/* One anchor, used as people do, is no hostility. */
static void test_an_alias_is_read(void **state)
{
    (void)state;
    static const char text[] = "name: t\nscenes: [{name: corner}]\nresolutions: [8x8]\nbackends: [null]\n"
                               "techniques:\n- {name: gtao, params: {radius: &r [1, 2]}}\n"
                               "- {name: hbao, params: {radius: *r}}\n";
    struct aob_config config;
    struct aob_error error = {{0}};
    assert_true(aob_file_write(path, text, strlen(text), &error));
    assert_true(aob_config_read(&config, path, &error));
    assert_int_equal(config.techniques[1].axes[0].count, 2);
    assert_string_equal(config.techniques[1].axes[0].values[1].text, "2");
    aob_config_finish(&config);
}

static int set_up(void **state)
{
    (void)state;
    snprintf(path, sizeof path, "/tmp/aobudget-hostile-%ld.yaml", (long)getpid());
    return 0;
}
static int tear_down(void **state)
{
    (void)state;
    return unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_nesting),
                                       cmocka_unit_test(test_anchors),
                                       cmocka_unit_test(test_aliases),
                                       cmocka_unit_test(test_many_keys),
                                       cmocka_unit_test(test_long_values),
                                       cmocka_unit_test(test_bytes_that_are_no_text),
                                       cmocka_unit_test(test_the_longest_list_is_named),
                                       cmocka_unit_test(test_the_bound_is_read),
                                       cmocka_unit_test(test_an_alias_is_read),
                                       cmocka_unit_test(test_products_that_overflow)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
