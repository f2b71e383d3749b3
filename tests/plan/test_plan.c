#include <math.h>
#include <stdlib.h>
#include "made.h"
#include "random.h"

#define HEAD                                                                                                 \
    "name: t\nscenes: [{name: corner, views: [front, far]}]\nresolutions: [64x36, 32x18]\nbackends: "        \
    "[vulkan, gl-egl]\n"
#define FIFTY                                                                                                \
    "1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,"
#define NONE "techniques: [{name: none}]\n"

static void test_product_of_axes(void **state)
{
    (void)state;
    struct aob_config config;
    struct aob_plan plan;
    struct aob_error error;
    if (!make(HEAD
              "options: {fetch: [sampled, storage], guard_band: 8, gbuffer: [canonical, raster]}\n"
              "techniques:\n"
              "  - {name: gtao, params: {blur: 0}, sweep: [{param: radius, from: 0.25, to: 2, log2: 1},\n"
              "                                            {param: slices, from: 1, to: 3, step: 1}]}\n"
              "  - name: none\n",
              &config, &plan, &error))
        fail_msg("%s", error.text);
    /* 2 views x 2 sizes x 2 backends x 2 fetches x 2 G-buffers x (4 radii x 3 slices + 1) */
    assert_int_equal(plan.case_count, 2 * 2 * 2 * 2 * 2 * 13);
    for (size_t i = 0; i < plan.case_count; i++) {
        const struct aob_case *c = &plan.cases[i];
        assert_int_equal(aob_case_options(c).guard_band, 8);
        /* a technique without a radius is compared with the first one of the sweep */
        assert_near(c->reference_radius, strcmp(c->technique->name, "none") == 0 ? 0.25 : c->params[0], 0);
        for (size_t j = 0; j < i; j++)
            assert_string_not_equal(c->key, plan.cases[j].key);
        /* cases of one block lie together */
        for (size_t j = i + 2; j < plan.case_count; j++)
            if (aob_case_same_block(c, &plan.cases[j])) {
                assert_int_equal(aob_case_options(c).gbuffer, aob_case_options(&plan.cases[j]).gbuffer);
                assert_true(aob_case_same_block(c, &plan.cases[j - 1]));
            }
    }
    aob_plan_filter(&plan, "radius=0.5 ");
    assert_int_equal(plan.case_count, 2 * 2 * 2 * 2 * 2 * 3);
    aob_plan_finish(&plan);
    aob_config_finish(&config);
}

static void test_twins_are_one_case_and_keys_are_stable(void **state)
{
    (void)state;
    struct aob_config config;
    struct aob_plan plan;
    struct aob_error error;
    char key[AOB_KEY_SIZE];
    assert_true(
        make("name: a\nscenes: [{name: plane}]\nresolutions: [8x8]\nbackends: [null, null]\n"
             "techniques: [{name: gtao, sweep: [{param: slices, values: [3, 3, 1]}]}, {name: gtao}]\n",
             &config, &plan, &error));
    assert_int_equal(plan.case_count, 2);
    strcpy(key, plan.cases[0].key);
    aob_plan_finish(&plan);
    aob_config_finish(&config);
    assert_true(make(
        "name: other\nscenes: [{name: plane, view: front}]\nresolutions: [16x16, 8x8]\nbackends: [null]\n"
        "techniques: [{name: gtao, params: {slices: 3}}]\n",
        &config, &plan, &error));
    assert_string_equal(plan.cases[1].key, key);
    assert_string_not_equal(plan.cases[0].key, key);
    aob_plan_finish(&plan);
    aob_config_finish(&config);
}

/* How many of the plan's cases are of this technique on this backend. */
static size_t count_cases(const struct aob_plan *plan, const char *technique, const char *backend)
{
    size_t count = 0;
    for (size_t i = 0; i < plan->case_count; i++)
        count += strcmp(plan->cases[i].technique->name, technique) == 0 &&
                 strcmp(plan->cases[i].backend, backend) == 0;
    return count;
}

/* An entry's own backends stand in place of the config's; of a case that two entries ask for there is one. */
static void test_backends_of_an_entry(void **state)
{
    (void)state;
    struct aob_config config;
    struct aob_plan plan;
    struct aob_error error;
    if (!make(HEAD "techniques:\n"
                   "  - {name: gtao, backends: [vulkan], sweep: [{param: radius, values: [0.25, 0.5, 1]}]}\n"
                   "  - {name: gtao, backends: [vulkan, gl-osmesa], params: {radius: 0.5}}\n"
                   "  - name: none\n",
              &config, &plan, &error))
        fail_msg("%s", error.text);
    const size_t places = 2 * 2; /* views and sizes */
    assert_int_equal(count_cases(&plan, "gtao", "vulkan"), places * 3);
    assert_int_equal(count_cases(&plan, "gtao", "gl-osmesa"), places);
    assert_int_equal(count_cases(&plan, "none", "vulkan"), places);
    assert_int_equal(count_cases(&plan, "none", "gl-egl"), places);
    assert_int_equal(plan.case_count, places * 6);
    for (size_t i = 0; i < plan.case_count; i++)
        if (strcmp(plan.cases[i].backend, "gl-osmesa") == 0)
            assert_near(aob_case_radius(&plan.cases[i]), 0.5, 0);
    aob_plan_finish(&plan);
    aob_config_finish(&config);
    if (!make("name: t\nscenes: [{name: corner}]\nresolutions: [8x8]\n"
              "techniques: [{name: none, backends: null}, {name: gtao, backends: [vulkan]}]\n",
              &config, &plan, &error))
        fail_msg("%s", error.text);
    assert_int_equal(plan.case_count, 2);
    assert_int_equal(count_cases(&plan, "none", "null"), 1);
    assert_int_equal(count_cases(&plan, "gtao", "vulkan"), 1);
    aob_plan_finish(&plan);
    aob_config_finish(&config);
}

/* Two cases of one view, compared with two targets: what each part adds, in seconds. */
static void test_estimate(void **state)
{
    (void)state;
    static const struct {
        const char *measure, *scene;
        double case_s, view_s;
    } rows[] = {
        /* compiling + further processes + timing + two targets' (pictures + score); the view + 3 traces of its rays */
        {"measure: {seconds: 1.5}\n", "corner", 0.3 + 0.2 + 0.75 + 2 * (0.04 + 0.003),
         0.5 + 3 * 1e4 * 60 / 60e6},
        {"measure: {time: false}\n", "corner", 0.3 + 2 * (0.04 + 0.003), 0.5 + 3 * 1e4 * 60 / 60e6},
        {"measure: {error: false, seconds: 1.5}\n", "corner", 0.3 + 0.2 + 0.75, 0.5},
        /* a view and a trace more for each of four frames; not where nothing moves */
        {"measure: {time: false}\n", "passing_box, motion: {frames: 5}", 0.3 + 2 * (0.04 + 0.003),
         5 * 0.5 + 7 * 1e4 * 60 / 60e6},
        {"measure: {time: false}\n", "corner, motion: {frames: 5}", 0.3 + 2 * (0.04 + 0.003),
         0.5 + 3 * 1e4 * 60 / 60e6},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct aob_config config;
        struct aob_plan plan;
        struct aob_error error;
        char text[512];
        snprintf(text, sizeof text,
                 "name: t\nscenes: [{name: %s}]\nresolutions: [100x100]\nbackends: [null]\n"
                 "techniques: [{name: gtao, params: {radius: [0.5, 1]}}]\nreference: {spp: 60}\n%s",
                 rows[i].scene, rows[i].measure);
        if (!make(text, &config, &plan, &error))
            fail_msg("%s", error.text);
        assert_near(aob_plan_estimate_s(&plan), 2 * rows[i].case_s + rows[i].view_s, 1e-9);
        aob_plan_finish(&plan);
        aob_config_finish(&config);
    }
}

/* Every refusal: one line with file, line and column, and what is wrong. */
#define MOTION(entry) "name: t\nscenes: [{" entry "}]\nresolutions: [8x8]\nbackends: [null]\n" NONE
static const struct {
    const char *text, *place, *says;
} refusals[] = {
    {"", "", "empty"},
    {"[1, 2", ":1:", "not YAML"},
    {"just text", ":1:1", "mapping"},
    {HEAD "technics: []\n", ":5:1", "unknown key 'technics'"},
    {HEAD "name: again\n" NONE, ":5:1", "twice"},
    {"scenes: [{name: corner}]\n" NONE, "", "'name' is missing"},
    {HEAD, "", "'techniques' is missing"},
    {HEAD "techniques: [{name: gtoa}]\n", ":5:21", "unknown technique 'gtoa'"},
    {HEAD "techniques: [{name: gtao, params: {radii: 1}}]\n", ":5:43", "no 'radii'; known: radius"},
    {HEAD "techniques: [{name: gtao, params: {radius: 0.5x}}]\n", ":5:44", "'0.5x' is not a number"},
    {HEAD "techniques: [{name: gtao, params: {radius: -1}}]\n", ":5:44", "outside"},
    {HEAD "techniques: [{name: gtao, params: {slices: 1.5}}]\n", ":5:44", "whole number"},
    {HEAD "techniques: [{name: gtao, sweep: [{param: radius}]}]\n", ":5:35", "from and to"},
    {HEAD "techniques: [{name: gtao, sweep: [{param: radius, from: 2, to: 1, step: 1}]}]\n", ":5:35",
     "empty"},
    {HEAD "techniques: [{name: gtao, sweep: [{param: radius, from: 0, to: 1, step: 1e-9}]}]\n", ":5:35",
     "1000"},
    {HEAD "techniques: [{name: gtao, params: {radius: 1}, sweep: [{param: radius, values: [1]}]}]\n",
     ":5:", "twice"},
    {"name: t\nscenes: [{name: corner}]\nresolutions: [0x0]\nbackends: [null]\n" NONE, ":3:15", "0x0"},
    {"name: t\nscenes: [{name: corner}]\nresolutions: [99999x2]\nbackends: [null]\n" NONE, ":3:15", "16384"},
    {"name: t\nscenes: [{name: crner}]\nresolutions: [8x8]\nbackends: [null]\n" NONE, ":2:10",
     "unknown scene"},
    {"name: t\nscenes: [{name: corner, view: up}]\nresolutions: [8x8]\nbackends: [null]\n" NONE, ":2:10",
     "no view 'up'"},
    {"name: t\nscenes: [{file: /nonexistent.obj}]\nresolutions: [8x8]\nbackends: [null]\n" NONE, ":2:10",
     "cannot open"},
    {"name: t\nscenes: [{name: corner, eye: [0, 0]}]\nresolutions: [8x8]\nbackends: [null]\n" NONE,
     ":2:", "three numbers"},
    {"name: t\nscenes: [{name: corner, eye: [0, 0, 1], target: [0, 0, 1]}]\nresolutions: "
     "[8x8]\nbackends: [null]\n" NONE,
     ":2:", "eye"},
    {"name: t\nscenes: [{name: corner}]\nresolutions: [8x8]\nbackends: [metal]\n" NONE, ":4:12",
     "unknown backend 'metal'"},
    {HEAD "techniques: [{name: none, backends: [vulkan, metal]}]\n", ":5:46", "unknown backend 'metal'"},
    {HEAD "techniques: [{name: none, backends: []}]\n", ":5:37", "the list of backends is empty"},
    {"name: t\nscenes: [{name: corner}]\nresolutions: [8x8]\nbackends: [metal]\n"
     "techniques: [{name: none, backends: [null]}]\n",
     ":4:12", "unknown backend 'metal'"},
    {"name: t\nscenes: [{name: corner}]\nresolutions: [8x8]\n"
     "techniques: [{name: none, backends: [null]}, {name: gtao}]\n",
     "", "'backends' is missing"},
    {"name: ../t\nscenes: [{name: corner}]\nresolutions: [8x8]\nbackends: [null]\n" NONE, ":1:7", "letters"},
    {"name: t\nscenes: [{name: corner, fov_deg: 30}]\nresolutions: [8x8]\nbackends: [null]\n" NONE,
     ":2:", "need eye and target"},
    {"name: t\nscenes: [{name: corner, shift: [0.5, 0]}]\nresolutions: [8x8]\nbackends: [null]\n" NONE,
     ":2:", "need eye and target"},
    {"name: t\nscenes: [{name: corner, eye: [0, 0, 1], target: [0, 0, 0], shift: [1]}]\nresolutions: "
     "[8x8]\nbackends: [null]\n" NONE,
     ":2:", "two numbers are expected"},
    {"name: t\nscenes: [{name: corner, eye: [0, 0, 1], target: [0, 0, 0], shift: [99, 0]}]\nresolutions: "
     "[8x8]\nbackends: [null]\n" NONE,
     ":2:", "shift 99"},
    {"name: t\nscenes: [{name: corner, eye: [0, 0, 1], target: [0, 0, 0], previous: {eye: [0, 0, "
     "1]}}]\nresolutions: [8x8]\nbackends: [null]\n" NONE,
     ":2:", "needs both eye and target"},
    {"name: t\nscenes: [{name: corner, eye: [0, 0, 1], target: [0, 0, 0], previous: {eye: [0, 0, 1], "
     "target: [0, 0, 1]}}]\nresolutions: [8x8]\nbackends: [null]\n" NONE,
     ":2:", "previous eye and target"},
    {MOTION("name: corner, motion: {eye: [0, 0, 1], target: [0, 0, 0]}"), ":2:33",
     "motion needs frames, 2 to 128"},
    {MOTION("name: corner, motion: {frames: 1}"), ":2:42", "2"},
    {MOTION("name: corner, motion: {frames: 129}"), ":2:42", "128"},
    {MOTION("name: corner, motion: {frames: 2.5}"), ":2:42", "whole number"},
    {MOTION("name: corner, motion: {frames: 4, step: 1}"), ":2:45", "unknown key 'step'"},
    {MOTION("name: corner, motion: {frames: 4, eye: [0, 0, 1]}"), ":2:33", "both eye and target, or neither"},
    {MOTION("name: corner, motion: {frames: 4, eye: [1, 1, 1], target: [1, 1, 1]}"), ":2:10",
     "frame 3 of the motion: camera: eye and target are the same point"},
    {MOTION("name: corner, eye: [0, 0, 1], target: [0, 0, 0], motion: {frames: 3, eye: [0, 0, 0], target: "
            "[0, 0, 1]}"),
     ":2:10", "frame 1 of the motion"},
    {MOTION("name: corner, eye: [0, 0, 1], target: [0, 0, 0], previous: {eye: [0, 0, 2], target: [0, 0, 0]}, "
            "motion: {frames: 3}"),
     ":2:10", "leave previous out"},
    {MOTION("capture: a.exr, fov_deg: 50, motion: {frames: 3}"), ":2:10", "a capture is one frame"},
    {MOTION("file: /dev/null, motion: {frames: 3}"), ":2:10", "give eye and target"},
    {HEAD "techniques: [{name: gtao, sweep: [{param: radius, values: [1], from: 1, to: 2, step: 1}]}]\n",
     ":5:35", "not both"},
    /* counted before it is expanded: 2 views, 2 sizes, 2 backends, 1000^3 points */
    {HEAD "techniques: [{name: gtao, sweep: [{param: radius, from: 1, to: 1000, step: 1},\n"
          "{param: falloff, from: 0, to: 0.999, step: 0.001}, {param: noise_index, from: 0, to: 999, "
          "step: 1}]}]\n",
     ":5:35: ", "more than 20000 cases, namely 8e+09"},
    {HEAD "techniques: [{name: gtao, params: {radius: [1, 1, 1], slices: [" FIFTY FIFTY "1]}}]\n"
          "options: {guard_band: [" FIFTY "0], near: [" FIFTY "0]}\n",
     ":5:63: ", "more than 20000 cases, namely 6.30482e+06"},
    {"name: t\nscenes: [{name: corner}]\nresolutions: [16384x16384]\nbackends: [null]\n" NONE, ": ",
     "40 million pixels"},
    {HEAD NONE "reference: {spp: 33}\n", ":6:18", "even"},
    {HEAD NONE "options: {fetch: texture}\n", ":6:18", "sampled, storage"},
    {HEAD NONE "measure: {time: yes}\n", ":6:17", "true nor false"},
    {HEAD NONE "measure: {cache: []}\n", ":6:18", "list of profiles is empty"},
};

static void test_refusals(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof refusals / sizeof *refusals; i++) {
        struct aob_config config;
        struct aob_plan plan;
        struct aob_error error;
        if (make(refusals[i].text, &config, &plan, &error))
            fail_msg("accepted: %s", refusals[i].text);
        assert_contains(error.text, path);
        assert_contains(error.text, refusals[i].place);
        assert_contains(error.text, refusals[i].says);
        assert_null(strchr(error.text, '\n'));
    }
}

/* Cut and flipped configs: refused or read, never a crash (the sanitizers watch). */
static void test_damaged_configs(void **state)
{
    (void)state;
    static const char good[] =
        HEAD "options: {fetch: [sampled, storage]}\n"
             "techniques:\n  - name: gtao\n    sweep: [{param: radius, values: [1, 2]}]\n";
    char text[sizeof good];
    uint32_t seed = 1;
    const size_t size = sizeof good - 1;
    for (size_t i = 0; i < 2 * size; i++) {
        struct aob_config config;
        struct aob_plan plan;
        struct aob_error error;
        strcpy(text, good);
        if (i < size)
            text[i] = '\0';
        else
            text[i - size] ^= (char)(1u << random_below(&seed, 8));
        if (make(text, &config, &plan, &error)) {
            aob_plan_finish(&plan);
            aob_config_finish(&config);
        } else
            assert_true(*error.text);
    }
}

/* What is scored is the last frame, seen from where the motion ends; the one before is its previous place. */
static void test_a_motion(void **state)
{
    (void)state;
    struct aob_config config;
    struct aob_plan plan;
    struct aob_error error;
    assert_true(make(
        MOTION("name: passing_box, views: [front, far], motion: {frames: 5, eye: [1, 2, 3], target: [0, 1, "
               "0.5]}}, {name: passing_box, motion: {frames: 9}}, {name: passing_box"),
        &config, &plan, &error));
    assert_int_equal(plan.scene_count, 4);
    static const char *const views[] = {"front-5-frames", "far-5-frames", "front-9-frames", "front"};
    static const int frames[] = {5, 5, 9, 0};
    for (int i = 0; i < 4; i++) {
        assert_string_equal(plan.scenes[i].view, views[i]);
        assert_int_equal(plan.scenes[i].motion.frames, frames[i]);
        assert_int_equal(plan.scenes[i].camera.moves, i < 2);
    }
    const struct aob_camera *front = &plan.scenes[0].camera; /* from (0.3, 1.5, 4.4), (0, 0.5, 0.4) */
    assert_true(front->eye.x == 1 && front->eye.y == 2 && front->eye.z == 3 && front->target.z == 0.5);
    assert_near(front->previous_eye.x, 0.825, 1e-12);
    assert_near(front->previous_eye.z, 3.35, 1e-12);
    assert_near(front->previous_target.y, 0.875, 1e-12);
    assert_int_equal(aob_plan_scene_frame(&plan.scenes[0], 4), 4);
    assert_true(plan.scenes[2].camera.eye.z == 4.4 && plan.scenes[3].camera.eye.z == 4.4);
    aob_plan_finish(&plan);
    aob_config_finish(&config);
    assert_true(make(MOTION("name: corner, motion: {frames: 5}"), &config, &plan, &error));
    assert_int_equal(aob_plan_scene_frame(&plan.scenes[0], 4), 0); /* nothing moves there */
    aob_plan_finish(&plan);
    aob_config_finish(&config);
}

/* A name that is not listed is a mesh of AOBUDGET_SCENES: same key as the file, no views of its own. */
static void test_scenes_of_the_users_folder(void **state)
{
    (void)state;
    struct aob_config config;
    struct aob_plan plan;
    struct aob_error error;
    char folder[256], mesh[300];
    snprintf(folder, sizeof folder, "/tmp/aobudget-scenes-%ld", (long)getpid());
    snprintf(mesh, sizeof mesh, "%s/hall.obj", folder);
    assert_true(aob_folder_create(folder, NULL) && aob_file_write(mesh, "v 0 0 0\n", 8, NULL));
#define TAIL "resolutions: [8x8]\nbackends: [null]\n" NONE
    assert_false(make("name: t\nscenes: [{name: hall}]\n" TAIL, &config, &plan, &error));
    assert_contains(error.text, "unknown scene 'hall'");
    setenv("AOBUDGET_SCENES", folder, 1);
    assert_true(make("name: t\nscenes: [{name: hall}, {name: corner}]\n" TAIL, &config, &plan, &error));
    assert_int_equal(plan.case_count, 2);
    assert_string_equal(plan.scenes[0].name, "hall");
    assert_string_equal(plan.scenes[0].file, mesh);
    assert_true(plan.scenes[0].framed && !plan.scenes[0].info && plan.scenes[1].info);
    aob_plan_finish(&plan);
    aob_config_finish(&config);
    assert_false(make("name: t\nscenes: [{name: hall, view: front}]\n" TAIL, &config, &plan, &error));
    assert_contains(error.text, "no named views");
    assert_false(make("name: t\nscenes: [{name: hull}]\n" TAIL, &config, &plan, &error));
    assert_contains(error.text, ", hall");
    unlink(mesh);
    rmdir(folder);
    assert_false(make("name: t\nscenes: [{name: hall}]\n" TAIL, &config, &plan, &error));
    assert_contains(error.text, folder);
    assert_true(make("name: t\nscenes: [{name: corner}]\n" TAIL, &config, &plan, &error));
    aob_plan_finish(&plan);
    aob_config_finish(&config);
    unsetenv("AOBUDGET_SCENES");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_product_of_axes), cmocka_unit_test(test_backends_of_an_entry),
        cmocka_unit_test(test_estimate),        cmocka_unit_test(test_twins_are_one_case_and_keys_are_stable),
        cmocka_unit_test(test_refusals),        cmocka_unit_test(test_damaged_configs),
        cmocka_unit_test(test_a_motion),        cmocka_unit_test(test_scenes_of_the_users_folder)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
