/* The line of a case: what tells it from the plan's others, and what is not at its default. */
#include <stdlib.h>
#include "made.h"

static void check_lines(const char *text, const char *filter, const char *const *lines)
{
    struct aob_config config;
    struct aob_plan plan;
    struct aob_error error;
    if (!make(text, &config, &plan, &error))
        fail_msg("%s", error.text);
    if (filter)
        aob_plan_filter(&plan, filter);
    for (size_t i = 0; i < plan.case_count; i++) {
        struct aob_text line = {0};
        assert_non_null(lines[i]);
        aob_case_describe(&plan, &plan.cases[i], &line);
        assert_string_equal(line.data, lines[i]);
        aob_text_finish(&line);
    }
    assert_null(lines[plan.case_count]);
    aob_plan_finish(&plan);
    aob_config_finish(&config);
}

#define LINES(...) ((const char *const[]){__VA_ARGS__, NULL})

static void test_what_varies(void **state)
{
    (void)state;
    check_lines("name: t\nscenes: [{name: corner}]\nresolutions: [8x8]\nbackends: [null]\ntechniques: "
                "[{name: gtao}]\n",
                NULL, LINES("gtao"));
    /* a value at its default stands where it varies, one that does not vary stands where it is not at its default */
    check_lines(
        "name: t\nscenes: [{name: corner, views: [front, far]}]\nresolutions: [8x8]\nbackends: [null]\n"
        "techniques: [{name: gtao, params: {slices: [2, 3], blur: 0}}]\n",
        NULL,
        LINES("corner/front gtao slices=2 blur=0", "corner/front gtao slices=3 blur=0",
              "corner/far gtao slices=2 blur=0", "corner/far gtao slices=3 blur=0"));
    check_lines("name: t\nscenes: [{name: corner}]\nresolutions: [8x8, 4x4]\nbackends: [null, vulkan]\n"
                "techniques: [{name: none}]\n",
                NULL, LINES("none null 8x8", "none vulkan 8x8", "none null 4x4", "none vulkan 4x4"));
    /* each technique by its own parameters; options after parameters, both before what does not vary */
    check_lines("name: t\nscenes: [{name: corner}]\nresolutions: [8x8]\nbackends: [null]\n"
                "options: {fetch: [sampled, storage], normals: shading}\n"
                "techniques: [{name: gtao, params: {radius: [0.2, 1], blur: 0}}, {name: hbao, params: "
                "{radius: 2}}]\n",
                "fetch=storage ",
                LINES("gtao radius=0.2 fetch=storage blur=0 normals=shading",
                      "gtao radius=1 fetch=storage blur=0 normals=shading",
                      "hbao fetch=storage radius=2 normals=shading"));
}

/* A filter matches what is printed, and what is left is described as before. The space ends the value. */
static void test_filter(void **state)
{
    (void)state;
    static const char text[] = "name: t\nscenes: [{name: corner}]\nresolutions: [8x8]\nbackends: [null]\n"
                               "techniques: [{name: gtao, params: {radius: [0.5, 0.55, 1]}}]\n";
    check_lines(text, "radius=0.5", LINES("gtao radius=0.5", "gtao radius=0.55"));
    check_lines(text, "radius=0.5 ", LINES("gtao radius=0.5"));
    check_lines(text, "corner", (const char *const[]){NULL});
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_what_varies), cmocka_unit_test(test_filter)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
