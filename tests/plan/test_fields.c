/* Every field that a case is made of, changed in turn: which of them the key sees, and which the series. */
#include <stdlib.h>
#include "made.h"
#include "plan/key.h"

static const char text[] = "name: t\n"
                           "scenes: [{name: corner, eye: [0, 1, 4], target: [0, 1, 0], shift: [0.25, 0.5],\n"
                           "          previous: {eye: [0.5, 1, 4], target: [0, 1, 0.5]}}]\n"
                           "resolutions: [8x16]\n"
                           "backends: [null]\n"
                           "options: {guard_band: 4, near: 0.5, far: 64}\n"
                           "techniques: [{name: gtao, params: {slices: 2}}]\n"
                           "target: [{radius: 1}, {radius: 2}]\n"
                           "reference: {spp: 64, thickness: 0.5}\n";

static struct aob_config config;
static struct aob_plan plan;
static struct aob_technique_info technique; /* of the case: a copy that may be changed */

static void identify(char key[AOB_KEY_SIZE], char series[AOB_KEY_SIZE])
{
    aob_plan_make_keys(&plan);
    assert_int_equal(plan.case_count, 1);
    strcpy(key, plan.cases[0].key);
    aob_case_series(&plan.cases[0], "cpu", series);
}

static void expect(const char *what, bool changes_key, bool changes_series)
{
    static char key[AOB_KEY_SIZE], series[AOB_KEY_SIZE]; /* of the case as it is */
    char changed_key[AOB_KEY_SIZE], changed_series[AOB_KEY_SIZE];
    identify(changed_key, changed_series);
    if (!*key) {
        strcpy(key, changed_key);
        strcpy(series, changed_series);
    }
    if ((strcmp(key, changed_key) != 0) != changes_key)
        fail_msg("%s: the key is %s", what, changes_key ? "the same" : "another");
    if ((strcmp(series, changed_series) != 0) != changes_series)
        fail_msg("%s: the series is %s", what, changes_series ? "the same" : "another");
}

static void change_number(const char *what, double *value, bool key, bool series)
{
    double kept = *value;
    *value = kept * (1 + 1e-6) + 1e-9;
    expect(what, key, series);
    *value = kept;
}

static void change_count(const char *what, int *value, bool key, bool series)
{
    (*value)++;
    expect(what, key, series);
    (*value)--;
}

static void change_text(const char *what, char *value, bool key, bool series)
{
    value[0] ^= 1;
    expect(what, key, series);
    value[0] ^= 1;
}

static void test_camera(void **state)
{
    (void)state;
    struct aob_camera *c = &plan.scenes[0].camera;
    double *const numbers[] = {&c->eye.x,
                               &c->eye.y,
                               &c->eye.z,
                               &c->target.x,
                               &c->target.y,
                               &c->target.z,
                               &c->fov_deg,
                               &c->ortho_height,
                               &c->shift[0],
                               &c->shift[1],
                               &c->previous_eye.x,
                               &c->previous_eye.y,
                               &c->previous_eye.z,
                               &c->previous_target.x,
                               &c->previous_target.y,
                               &c->previous_target.z};
    assert_true(c->moves);
    expect("nothing", false, false);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        char what[32];
        snprintf(what, sizeof what, "number %zu of the camera", i);
        change_number(what, numbers[i], true, true);
    }
    c->moves = false;
    expect("a camera that stands still", true, true);
    c->moves = true;
    plan.scenes[0].framed = true;
    expect("a framed camera", true, true);
    plan.scenes[0].framed = false;
}

static void test_scene(void **state)
{
    (void)state;
    struct aob_plan_scene *s = &plan.scenes[0];
    expect("nothing", false, false);
    change_text("the digest of the scene", s->digest, true, false);
    change_text("the geometry of the scene", s->geometry, false, true);
    change_text("the name of the scene", s->name, false, false);
    change_text("the name of the view", s->view, false, false);
    assert_int_equal(s->target_count, 2);
    for (size_t i = 0; i < s->target_count; i++) {
        change_number("the radius of a target", &s->targets[i].radius, true, false);
        s->targets[i].uniform = true;
        expect("the weighting of a target", true, false);
        s->targets[i].uniform = false;
    }
    s->target_count = 1;
    expect("one target less", true, false);
    s->target_count = 2;
}

/* Where its output is wanted the parameter makes another case of another history. */
static void expect_of_wanted(struct aob_case *c, size_t param, int output)
{
    char key[2][AOB_KEY_SIZE], series[2][AOB_KEY_SIZE];
    double *option = &c->options[AOB_OPTION_FIRST_OUTPUT + output - 1];
    *option = 1;
    identify(key[0], series[0]);
    c->params[param] += 1;
    identify(key[1], series[1]);
    c->params[param] -= 1;
    *option = 0;
    assert_string_not_equal(key[0], key[1]);
    assert_string_not_equal(series[0], series[1]);
}

static void test_case(void **state)
{
    (void)state;
    struct aob_case *c = &plan.cases[0];
    expect("nothing", false, false);
    change_count("the width", &c->width, true, true);
    change_count("the height", &c->height, true, true);
    const char *backend = c->backend;
    c->backend = "gl-egl";
    expect("the backend", true, true);
    c->backend = backend;
    for (size_t i = 0; i < technique.param_count; i++) {
        int output = technique.params[i].output; /* counts where that is wanted */
        c->params[i] += 1;
        expect(technique.params[i].name, !output, !output);
        c->params[i] -= 1;
        if (output)
            expect_of_wanted(c, i, output);
    }
    for (size_t i = 0; i < AOB_OPTION_COUNT; i++) {
        c->options[i] += 1;
        expect(aob_option_params[i].name, true, true);
        c->options[i] -= 1;
    }
    change_number("the reference radius", &c->reference_radius, false, false); /* it follows from the rest */
}

static void test_technique(void **state)
{
    (void)state;
    expect("nothing", false, false);
    change_text("the digest of the technique", technique.digest, true, false);
    technique.revision++;
    expect("the revision of the technique", true, false);
    technique.revision--;
    char *name = technique.name;
    technique.name = "other";
    expect("the name of the technique", true, true);
    technique.name = name;
}

static void test_config(void **state)
{
    (void)state;
    expect("nothing", false, false);
    config.spp += 2;
    expect("the rays a pixel", true, false);
    config.spp -= 2;
    change_number("the thickness", &config.thickness, true, false);
    change_number("the seconds", &config.seconds, false, false);
    change_text("the name of the run", config.name, false, false);
    change_text("the hash of the config", config.hash, false, false);
    bool *const wishes[] = {&config.measure_time, &config.measure_error, &config.images};
    for (size_t i = 0; i < sizeof wishes / sizeof *wishes; i++) {
        *wishes[i] = !*wishes[i];
        expect("a wish", false, false);
        *wishes[i] = !*wishes[i];
    }
}

static int make_plan(void **state)
{
    struct aob_error error;
    set_up(state);
    if (!make(text, &config, &plan, &error)) {
        printf("%s\n", error.text);
        return 1;
    }
    technique = *plan.cases[0].technique;
    plan.cases[0].technique = &technique;
    return 0;
}

static int finish_plan(void **state)
{
    aob_plan_finish(&plan);
    aob_config_finish(&config);
    return tear_down(state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_camera), cmocka_unit_test(test_scene),
                                       cmocka_unit_test(test_case), cmocka_unit_test(test_technique),
                                       cmocka_unit_test(test_config)};
    return cmocka_run_group_tests(tests, make_plan, finish_plan);
}
