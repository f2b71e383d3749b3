/* What changes a case's key and what its series, each by one thing that is changed. */
#include <stdlib.h>
#include "made.h"

struct identity {
    char key[AOB_KEY_SIZE], series[AOB_KEY_SIZE];
};

static struct identity identify(const char *text, const char *device_class)
{
    struct aob_config config;
    struct aob_plan plan;
    struct aob_error error;
    struct identity id;
    if (!make(text, &config, &plan, &error))
        fail_msg("%s: %s", error.text, text);
    strcpy(id.key, plan.cases[0].key);
    aob_case_series(&plan.cases[0], device_class, id.series);
    aob_plan_finish(&plan);
    aob_config_finish(&config);
    return id;
}

#define NAME      "name: t\n"
#define SCENE     "scenes: [{name: corner, eye: [0, 1, 4], target: [0, 1, 0]}]\n"
#define SIZE      "resolutions: [8x8]\n"
#define BACKEND   "backends: [null]\n"
#define TECHNIQUE "techniques: [{name: gtao, params: {slices: 2}}]\n"
#define ALL       NAME SCENE SIZE BACKEND TECHNIQUE

static const struct {
    const char *text;
    bool key, series; /* whether it changes */
} changes[] = {
    /* names and wishes */
    {"name: other\n" SCENE SIZE BACKEND TECHNIQUE, false, false},
    {ALL "measure: {time: false}\n", false, false},
    {ALL "measure: {error: false}\n", false, false},
    {ALL "measure: {images: false}\n", false, false},
    {ALL "measure: {seconds: 7}\n", false, false},
    /* what is said already */
    {ALL "target: {radius: 0.5}\n", false, false},
    {ALL "reference: {spp: 256}\n", false, false},
    {ALL "options: {fetch: sampled}\n", false, false},
    /* the question */
    {ALL "target: {radius: 1}\n", true, false},
    {ALL "target: {radius: 0.5, weighting: uniform}\n", true, false},
    {ALL "target: [{radius: 0.5}, {radius: 1}]\n", true, false},
    {NAME SCENE SIZE BACKEND
     "techniques: [{name: gtao, params: {slices: 2}}, {name: hbao, params: {radius: 3}}]\n",
     true, false},
    {ALL "reference: {spp: 64}\n", true, false},
    {ALL "reference: {thickness: 0.5}\n", true, false},
    /* the case */
    {NAME SCENE SIZE BACKEND "techniques: [{name: gtao, params: {slices: 3}}]\n", true, true},
    {NAME SCENE SIZE BACKEND "techniques: [{name: none}]\n", true, true},
    {ALL "options: {fetch: storage}\n", true, true},
    {ALL "options: {bent_normal: on}\n", true, true},
    {ALL "options: {irradiance: on}\n", true, true},
    {NAME SCENE "resolutions: [8x9]\n" BACKEND TECHNIQUE, true, true},
    {NAME SCENE SIZE "backends: [vulkan]\n" TECHNIQUE, true, true},
    {NAME "scenes: [{name: corner, eye: [0, 1, 4], target: [0, 1, 0], fov_deg: 61}]\n" SIZE BACKEND TECHNIQUE,
     true, true},
    {NAME "scenes: [{name: spheres, eye: [0, 1, 4], target: [0, 1, 0]}]\n" SIZE BACKEND TECHNIQUE, true,
     true},
    {NAME "scenes: [{name: corner, eye: [0, 1, 4], target: [0, 1, 0], motion: {frames: 2}}]\n" SIZE BACKEND
         TECHNIQUE,
     true, true},
};

/* How many frames there are, and where the camera comes from; both say where the last frame is seen from. */
static void test_motion(void **state)
{
    (void)state;
    static const char *const scenes[] = {
        "eye: [0, 1, 4], target: [0, 1, 0]",
        "eye: [0, 1, 5], target: [0, 1, 0], motion: {frames: 4, eye: [0, 1, 4], target: [0, 1, 0]}",
        "eye: [0, 1, 5], target: [0, 1, 0], motion: {frames: 5, eye: [0, 1, 4], target: [0, 1, 0]}",
        "eye: [0, 1, 6], target: [0, 1, 0], motion: {frames: 4, eye: [0, 1, 4], target: [0, 1, 0]}",
        "eye: [0, 1, 4], target: [0, 1, 0], motion: {frames: 4}"};
    struct identity ids[5];
    for (int i = 0; i < 5; i++) {
        char text[1024];
        snprintf(text, sizeof text, NAME "scenes: [{name: corner, %s}]\n" SIZE BACKEND TECHNIQUE, scenes[i]);
        ids[i] = identify(text, "cpu");
        for (int k = 0; k < i; k++) {
            assert_string_not_equal(ids[i].key, ids[k].key);
            assert_string_not_equal(ids[i].series, ids[k].series);
        }
    }
}

static void test_changes_of_a_config(void **state)
{
    (void)state;
    struct identity first = identify(ALL, "cpu");
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        struct identity id = identify(changes[i].text, "cpu");
        if ((strcmp(id.key, first.key) != 0) != changes[i].key)
            fail_msg("the key is %s by: %s", changes[i].key ? "not changed" : "changed", changes[i].text);
        if ((strcmp(id.series, first.series) != 0) != changes[i].series)
            fail_msg("the series is %s by: %s", changes[i].series ? "not changed" : "changed",
                     changes[i].text);
    }
    struct identity other = identify(ALL, "discrete");
    assert_string_equal(other.key, first.key);
    assert_string_not_equal(other.series, first.series);
}

/* The light is a part of the question where an output depends on it, and nowhere else. */
static void test_light(void **state)
{
    (void)state;
    static const char *const outputs[] = {"", "options: {visibility_rgb: on, specular: on}\n",
                                          "options: {irradiance: on}\n"};
    for (int o = 0; o < 3; o++) {
        char plain[1024], lit[1024];
        snprintf(plain, sizeof plain, "%s%s", ALL, outputs[o]);
        snprintf(lit, sizeof lit,
                 NAME "scenes: [{name: corner, eye: [0, 1, 4], target: [0, 1, 0], light: sky}]\n" SIZE BACKEND
                     TECHNIQUE "%s",
                 outputs[o]);
        struct identity a = identify(plain, "cpu"), b = identify(lit, "cpu");
        assert_true((strcmp(a.key, b.key) != 0) == (o == 2));
        assert_true((strcmp(a.series, b.series) != 0) == (o == 2));
    }
}

/* Keys of the time before an output was an option last: one that is off is not named in what they are made of. */
static void test_outputs_that_are_off(void **state)
{
    (void)state;
    for (int on = 0; on < 2; on++) {
        struct aob_config config;
        struct aob_plan plan;
        struct aob_error error;
        struct aob_text settings = {0};
        assert_true(make(on ? ALL "options: {bent_normal: on}\n" : ALL, &config, &plan, &error));
        aob_case_settings(&plan.cases[0], &settings);
        assert_true((strstr(settings.data, "bent_normal") != NULL) == on);
        aob_text_finish(&settings);
        aob_plan_finish(&plan);
        aob_config_finish(&config);
    }
}

/* Another build of a technique is another case of the same history. */
static void test_changes_of_a_technique(void **state)
{
    (void)state;
    struct identity first = identify(ALL, "cpu"), changed;
    for (size_t i = 0; i < techniques.count; i++) {
        struct aob_technique_info *t = &techniques.items[i];
        if (strcmp(t->name, "gtao") != 0)
            continue;
        t->revision++;
        changed = identify(ALL, "cpu");
        t->revision--;
        assert_string_not_equal(changed.key, first.key);
        assert_string_equal(changed.series, first.series);
        t->digest[0] ^= 1;
        changed = identify(ALL, "cpu");
        t->digest[0] ^= 1;
        assert_string_not_equal(changed.key, first.key);
        assert_string_equal(changed.series, first.series);
    }
    changed = identify(ALL, "cpu");
    assert_string_equal(changed.key, first.key);
}

/* The version of what reads a mesh is in the digest and not in the geometry; the file's bytes are in both. A camera
 * that is known only once the mesh is loaded changes no series then. */
static void test_meshes(void **state)
{
    (void)state;
    struct aob_config config;
    struct aob_plan plan;
    struct aob_error error;
    char mesh[256], text[512], geometry[2][AOB_KEY_SIZE], series[2][AOB_KEY_SIZE];
    snprintf(mesh, sizeof mesh, "/tmp/aobudget-key-%ld.obj", (long)getpid());
    snprintf(text, sizeof text, "name: t\nscenes: [{file: %s}, {name: corner}]\n" SIZE BACKEND TECHNIQUE,
             mesh);
    for (int pass = 0; pass < 2; pass++) {
        assert_true(aob_file_write(mesh, pass ? "v 0 0 1\n" : "v 0 0 0\n", 8, NULL));
        assert_true(make(text, &config, &plan, &error));
        assert_string_not_equal(plan.scenes[0].digest, plan.scenes[0].geometry);
        assert_string_equal(plan.scenes[1].digest, plan.scenes[1].geometry);
        strcpy(geometry[pass], plan.scenes[0].geometry);
        aob_case_series(&plan.cases[0], "cpu", series[0]);
        plan.scenes[0].digest[0] ^= 1;
        plan.scenes[0].camera = plan.scenes[1].camera;
        aob_case_series(&plan.cases[0], "cpu", series[1]);
        assert_string_equal(series[0], series[1]);
        plan.scenes[0].geometry[0] ^= 1;
        aob_case_series(&plan.cases[0], "cpu", series[1]);
        assert_string_not_equal(series[0], series[1]);
        aob_plan_finish(&plan);
        aob_config_finish(&config);
    }
    assert_string_not_equal(geometry[0], geometry[1]);
    unlink(mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_changes_of_a_config),
                                       cmocka_unit_test(test_motion),
                                       cmocka_unit_test(test_light),
                                       cmocka_unit_test(test_outputs_that_are_off),
                                       cmocka_unit_test(test_changes_of_a_technique),
                                       cmocka_unit_test(test_meshes)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
