/* The messages of the job `cache`, written and read again. */
#include "check.h"
#include "job/send.h"
#include <string.h>
#include "job/cache_job.h"

static struct aob_cache_profile profiles[] = {{"/p/ps4.yaml", "0123"}, {"/q/mine.yaml", "4567"}};
static struct aob_job_pose poses[] = {
    {.camera = {.eye = {1, 2, 4}, .fov_deg = 50}, .gbuffer = "/cache/f.exr"}};
static const struct aob_cache_job job = {
    .drawing = {.view = {.scene = "corner",
                         .width = 64,
                         .height = 36,
                         .gbuffer = "/cache/g.exr",
                         .camera = {.eye = {1, 2, 3}, .fov_deg = 50}},
                .backend = "gl-egl",
                .device = "radeon",
                .raster = true},
    .frame = {.technique = {"gtao", NULL, "89ab"}, .params = {0.5, 3}, .param_count = 2, .options = {16, 1}},
    .poses = poses,
    .pose_count = 1,
    .profiles = profiles,
    .profile_count = 2,
    .map = "/m.exr"};

static void a_cache_job(void **state)
{
    (void)state;
    struct aob_cache_job back;
    struct aob_error error = {{0}};
    json_t *message = send(aob_cache_job_to_json(&job));
    assert_string_equal(json_string_value(json_object_get(message, "job")), "cache");
    if (!aob_cache_job_from_json(message, &back, &error))
        fail_msg("%s", error.text);
    assert_string_equal(back.drawing.backend, "gl-egl");
    assert_string_equal(back.drawing.device, "radeon");
    assert_true(back.drawing.raster && !back.drawing.triangles && !back.drawing.validate);
    assert_int_equal(back.drawing.view.width, 64);
    assert_string_equal(back.frame.technique.digest, "89ab");
    assert_true(back.frame.param_count == 2 && back.frame.params[1] == 3 && back.frame.options[0] == 16);
    assert_int_equal(back.profile_count, 2);
    assert_string_equal(back.profiles[1].path, "/q/mine.yaml");
    assert_string_equal(back.profiles[1].digest, "4567");
    assert_string_equal(back.map, "/m.exr");
    assert_int_equal(back.pose_count, 1);
    assert_true(back.poses[0].camera.eye.z == 4);
    assert_string_equal(back.poses[0].gbuffer, "/cache/f.exr");
    aob_cache_job_finish(&back);
    json_object_del(json_array_get(json_object_get(message, "profiles"), 1), "digest");
    assert_false(aob_cache_job_from_json(message, &back, &error));
    assert_contains(error.text, "profile 1");
    json_array_clear(json_object_get(message, "profiles"));
    assert_false(aob_cache_job_from_json(message, &back, &error));
    assert_contains(error.text, "no profile");
    json_decref(message);
}

static void what_is_foretold(void **state)
{
    (void)state;
    const struct aob_cache_capture capture = {1e6, 3, 2.5};
    struct aob_cache_capture back;
    json_t *message = send(aob_cache_capture_to_json(&capture));
    assert_true(aob_cache_capture_from_json(message, &back));
    assert_true(back.words == 1e6 && back.strips == 3 && back.seconds == 2.5);
    json_decref(message);
}

static void answers(void **state)
{
    (void)state;
    json_t *figures = json_pack("{s:i}", "units", 18);
    struct aob_cache_answer back;
    struct aob_cache_capture capture;
    json_t *good = send(aob_cache_answer_to_json(&(struct aob_cache_answer){1, "ok", NULL, figures}));
    json_t *bad = send(aob_cache_answer_to_json(&(struct aob_cache_answer){0, "unsupported", "why", NULL}));
    assert_true(aob_cache_answer_from_json(good, &back));
    assert_true(back.profile == 1 && !back.reason && json_equal(back.figures, figures));
    assert_true(aob_cache_answer_from_json(bad, &back));
    assert_true(back.profile == 0 && !back.figures);
    assert_string_equal(back.status, "unsupported");
    assert_string_equal(back.reason, "why");
    assert_false(aob_cache_capture_from_json(good, &capture));
    json_object_del(good, "figures");
    assert_false(aob_cache_answer_from_json(good, &back)); /* good without figures is no answer */
    json_decref(figures);
    json_decref(good);
    json_decref(bad);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cache_job),
        cmocka_unit_test(what_is_foretold),
        cmocka_unit_test(answers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
