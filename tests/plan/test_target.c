/* What cases are compared with: the config's targets, or each radius of the sweep. */
#include <math.h>
#include "base/memory.h"
#include "made.h"

static struct aob_config config;
static struct aob_plan plan;

static void plan_of(const char *text)
{
    struct aob_error error;
    if (!make(text, &config, &plan, &error))
        fail_msg("%s", error.text);
}

static void finish(void)
{
    aob_plan_finish(&plan);
    aob_config_finish(&config);
}

static void refuse(const char *text, const char *place, const char *says)
{
    struct aob_error error;
    if (make(text, &config, &plan, &error))
        fail_msg("accepted: %s", text);
    assert_contains(error.text, path);
    assert_contains(error.text, place);
    assert_contains(error.text, says);
}

#define HEAD        "name: t\nscenes: [{name: corner}]\nresolutions: [8x8]\nbackends: [null]\n"
#define RADII(list) "techniques: [{name: none}, {name: gtao, params: {radius: " list "}}]\n"

/* Each radius once, in the order of the sweep; a case's own target is the one of its radius. */
static void test_radii_of_the_sweep(void **state)
{
    (void)state;
    plan_of(HEAD "techniques: [{name: none}, {name: gtao, params: {radius: [0.5, 0.3, 0.5]}},\n"
                 "  {name: alchemy, params: {radius: [0.3, 2]}}]\n");
    const struct aob_plan_scene *scene = &plan.scenes[0];
    assert_int_equal(scene->target_count, 3);
    assert_true(scene->targets[0].radius == 0.5 && scene->targets[1].radius == (double)0.3f);
    assert_true(scene->targets[2].radius == 2 && !scene->targets[2].uniform);
    static const size_t own[] = {0, 0, 1, 1, 2};
    assert_int_equal(plan.case_count, 5);
    for (size_t i = 0; i < 5; i++) {
        assert_int_equal(aob_case_own_target(&plan.cases[i]), own[i]);
        assert_true(plan.cases[i].reference_radius == scene->targets[own[i]].radius);
    }
    assert_true(isnan(aob_case_radius(&plan.cases[0])));
    assert_true(aob_case_radius(&plan.cases[4]) == 2);
    finish();
}

/* Without any radius the target is what stands for a metre in each scene. */
static void test_a_metre(void **state)
{
    (void)state;
    plan_of("name: t\nscenes: [{name: corner}, {name: cornell_box}]\nresolutions: [8x8]\nbackends: [null]\n"
            "techniques: [{name: none}]\n");
    assert_int_equal(plan.scenes[0].target_count, 1);
    assert_true(plan.scenes[0].targets[0].radius == 1);
    assert_int_equal(plan.scenes[1].target_count, 1);
    assert_true(plan.scenes[1].targets[0].radius == 278);
    assert_true(plan.cases[1].reference_radius == 278);
    finish();
}

/* A capture states its unit as a mesh file does. What loads it is not part of the plan. */
static void test_metre_of_a_capture(void **state)
{
    (void)state;
    static const char text[] =
        "name: t\nscenes: [{capture: frame.exr, fov_deg: 50, metres_per_unit: 0.001}]\n"
        "backends: [null]\ntechniques: [{name: gtao}]\n";
    struct aob_error error = {""};
    assert_true(aob_file_write(path, text, strlen(text), &error));
    assert_true(aob_config_read(&config, path, &error));
    config.scenes[0].gbuffer = aob_strdup("gbuffer.exr");
    config.scenes[0].width = config.scenes[0].height = 8;
    if (!aob_plan_create(&plan, &config, &techniques, &error))
        fail_msg("%s", error.text);
    assert_true(plan.scenes[0].metre == 1000);
    assert_true(aob_case_radius(&plan.cases[0]) == 500);
    finish();
}

/* A radius by default is metres, a stated target scene units: where a metre is not one unit, a line says both. */
static void test_mixed_units(void **state)
{
    (void)state;
    static const struct {
        const char *scene, *radius, *target;
        bool mixed;
    } cases[] = {
        {"cornell_box", "", "target: {radius: 0.5}", true},
        {"corner", "", "target: {radius: 2}", false},
        {"cornell_box", "", "", false},
        {"cornell_box", "", "target: {radius: 139}", false},
        {"cornell_box", "", "target: {radius: inf}", false},
        {"cornell_box", "radius: 3", "target: {radius: 0.5}", false},
        {"cornell_box", "", "target: [{radius: 0.5}, {radius: 139}]", false},
        {"cornell_box", "", "target: {radius: 0.5}\nmeasure: {error: false}", false},
    };
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        char text[400];
        struct aob_error line = {""};
        snprintf(text, sizeof text,
                 "name: t\nscenes: [{name: %s}]\nresolutions: [8x8]\nbackends: [null]\n"
                 "techniques: [{name: none}, {name: gtao, params: {%s}}]\n%s\n",
                 cases[i].scene, cases[i].radius, cases[i].target);
        plan_of(text);
        assert_false(aob_case_mixes_units(&plan.cases[0], &config, &line)); /* it has no radius */
        assert_int_equal(aob_case_mixes_units(&plan.cases[1], &config, &line), cases[i].mixed);
        if (cases[i].mixed)
            assert_string_equal(
                line.text,
                "cornell_box: gtao looks 139 scene units far, since its default radius is 0.5 m, and "
                "is compared with the target of 0.5 scene units, which is 0.0018 m: state both in "
                "scene units (a metre is 278)");
        finish();
    }
}

/* The config's own, in its order, whatever the sweep has. Whose radius is none of them is compared with the first; the
 * weighting does not decide which is a case's own. */
static void test_named_targets(void **state)
{
    (void)state;
    plan_of(
        HEAD
        "target: [{radius: 1}, {radius: 0.3, weighting: uniform}, {radius: inf, weighting: cosine}]\n" RADII(
            "[0.3, 0.5]"));
    const struct aob_plan_scene *scene = &plan.scenes[0];
    assert_int_equal(scene->target_count, 3);
    assert_true(scene->targets[0].radius == 1 && !scene->targets[0].uniform);
    assert_true(scene->targets[1].radius == (double)0.3f && scene->targets[1].uniform);
    assert_true(isinf(scene->targets[2].radius) && !scene->targets[2].uniform);
    assert_int_equal(aob_case_own_target(&plan.cases[0]), 0);
    assert_int_equal(aob_case_own_target(&plan.cases[1]), 1);
    assert_int_equal(aob_case_own_target(&plan.cases[2]), 0);
    assert_true(plan.cases[1].reference_radius == (double)0.3f && plan.cases[2].reference_radius == 1);
    finish();
    plan_of(HEAD "target: {radius: 2}\n" RADII("[0.3]"));
    assert_int_equal(plan.scenes[0].target_count, 1);
    assert_true(plan.cases[1].reference_radius == 2);
    finish();
}

static void test_none_without_an_error(void **state)
{
    (void)state;
    plan_of(HEAD "measure: {error: false}\ntarget: {radius: 2}\n" RADII("[0.3]"));
    assert_int_equal(plan.scenes[0].target_count, 0);
    assert_true(plan.cases[1].reference_radius == 0);
    finish();
}

/* 64 radii are targets; 65 need a question, or no error to be measured. */
static void test_too_many(void **state)
{
    (void)state;
    struct aob_error error;
#define SWEEP(to) "techniques: [{name: gtao, sweep: [{param: radius, from: 1, to: " to ", step: 1}]}]\n"
    plan_of(HEAD SWEEP("64"));
    assert_int_equal(plan.scenes[0].target_count, 64);
    assert_int_equal(aob_case_own_target(&plan.cases[63]), 63);
    finish();
    assert_false(make(HEAD SWEEP("65"), &config, &plan, &error));
    assert_contains(error.text, "65 radii");
    assert_contains(error.text, "target: {radius: R}");
    plan_of(HEAD "target: {radius: 3}\n" SWEEP("65"));
    finish();
    plan_of(HEAD "measure: {error: false}\n" SWEEP("65"));
    finish();
}

static void test_refusals(void **state)
{
    (void)state;
    refuse(HEAD "target: {radius: 0}\n" RADII("1"), ":5:18", "outside");
    refuse(HEAD "target: {radius: far}\n" RADII("1"), ":5:18", "not a number");
    refuse(HEAD "target: {weighting: cosine}\n" RADII("1"), ":5:9", "needs radius");
    refuse(HEAD "target: {radius: 1, weighting: flat}\n" RADII("1"), ":5:32", "cosine, uniform");
    refuse(HEAD "target: {radius: 1, falloff: 2}\n" RADII("1"), ":5:21", "unknown key 'falloff'");
    refuse(HEAD "target: [{radius: 0.5}, {radius: 1}, {radius: 0.50, weighting: cosine}]\n" RADII("1"),
           ":5:38", "given twice");
    refuse(HEAD "target: []\n" RADII("1"), ":5:9", "empty");
    refuse(HEAD "reference: {spp: 2, radius: 0.5}\n" RADII("1"), ":5:29", "target: {radius: R}");
    refuse(HEAD "reference: {rays: 2}\n" RADII("1"), ":5:13", "known here: spp, thickness");
    plan_of(HEAD "target: [{radius: 0.5}, {radius: 0.5, weighting: uniform}]\n" RADII("1"));
    finish();
}

/* As the command line gives them. */
static void test_texts(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    aob_config_init(&config);
    assert_true(aob_config_add_targets(&config, "0.5,inf", "cosine", &error));
    assert_true(aob_config_add_targets(&config, "0.5", "uniform", &error));
    assert_int_equal(config.target_count, 3);
    assert_true(config.targets[0].radius == 0.5 && isinf(config.targets[1].radius));
    assert_true(!config.targets[1].uniform && config.targets[2].uniform);
    assert_false(aob_config_add_targets(&config, "1,", "cosine", &error));
    assert_contains(error.text, "'' is not a radius");
    assert_false(aob_config_add_targets(&config, "-1", "cosine", &error));
    assert_contains(error.text, "'-1' is not a radius");
    assert_false(aob_config_add_targets(&config, "inf", "cosine", &error));
    assert_contains(error.text, "given twice");
    assert_false(aob_config_add_targets(&config, "3", "round", &error));
    assert_contains(error.text, "'round' is not one of cosine, uniform");
    aob_config_finish(&config);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_radii_of_the_sweep),
                                       cmocka_unit_test(test_a_metre),
                                       cmocka_unit_test(test_metre_of_a_capture),
                                       cmocka_unit_test(test_mixed_units),
                                       cmocka_unit_test(test_named_targets),
                                       cmocka_unit_test(test_none_without_an_error),
                                       cmocka_unit_test(test_too_many),
                                       cmocka_unit_test(test_refusals),
                                       cmocka_unit_test(test_texts)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
