/* The frames of a sequence before its last, written into a block's job and read again. */
#include "check.h"
#include "job/block_job.h"
#include "job/send.h"

static struct aob_block_target targets[] = {{.radius = 0.25}, {.radius = 1, .uniform = true}};
static struct aob_block_case cases[] = {{.frame = {.technique = {"none", NULL, "4567"}}}};
static struct aob_job_pose poses[] = {{.camera = {.eye = {1, 2, 4}, .target = {0, 0, 0.5}, .fov_deg = 47},
                                       .gbuffer = "/cache/g0.exr",
                                       .truth = {"/cache/t0.exr", "/cache/u0.exr"}},
                                      {.camera = {.eye = {1, 2, 3},
                                                  .target = {0, 0, 0.25},
                                                  .fov_deg = 47,
                                                  .moves = true,
                                                  .previous_eye = {1, 2, 4},
                                                  .previous_target = {0, 0, 0.5}},
                                       .frame = 6,
                                       .seed = 1,
                                       .gbuffer = "/cache/g1.exr",
                                       .truth = {"/cache/t1.exr", "/cache/u1.exr"}}};
static const struct aob_block_job block = {.drawing = {.view = {.scene = "passing_box",
                                                                .camera = {.eye = {1, 2, 2}, .fov_deg = 47},
                                                                .frame = 7,
                                                                .width = 32,
                                                                .height = 18,
                                                                .gbuffer = "/cache/g2.exr"},
                                                       .backend = "gl-egl"},
                                           .score = true,
                                           .error = true,
                                           .poses = poses,
                                           .pose_count = 2,
                                           .targets = targets,
                                           .target_count = 2,
                                           .cases = cases,
                                           .case_count = 1};

static void every_field_comes_back(void **state)
{
    (void)state;
    struct aob_block_job job;
    struct aob_error error = {{0}};
    json_t *message = send(aob_block_job_to_json(&block));
    assert_true(aob_block_job_from_json(message, &job, &error));
    assert_int_equal(job.pose_count, 2);
    assert_int_equal(job.drawing.view.frame, 7);
    for (int i = 0; i < 2; i++) {
        const struct aob_job_pose *pose = &job.poses[i];
        assert_true(pose->camera.eye.z == poses[i].camera.eye.z && pose->camera.moves == (i == 1));
        assert_true(pose->camera.target.z == poses[i].camera.target.z);
        assert_true(pose->frame == poses[i].frame && pose->seed == poses[i].seed);
        assert_string_equal(pose->gbuffer, poses[i].gbuffer);
        for (int t = 0; t < 2; t++)
            assert_string_equal(pose->truth[t], poses[i].truth[t]);
    }
    assert_true(job.poses[1].camera.previous_eye.z == 4);
    aob_block_job_finish(&job);
    json_decref(message);
}

static void what_is_missing_is_said(void **state)
{
    (void)state;
    struct aob_block_job job;
    struct aob_error error = {{0}};
    json_t *message = send(aob_block_job_to_json(&block));
    json_t *pose = json_array_get(json_object_get(message, "poses"), 1);
    json_object_del(json_object_get(pose, "camera"), "eye");
    assert_false(aob_block_job_from_json(message, &job, &error));
    assert_contains(error.text, "a camera lacks eye");
    json_array_clear(json_object_get(pose, "truth"));
    assert_false(aob_block_job_from_json(message, &job, &error));
    assert_contains(error.text, "a pose of a job lacks its G-buffer or its truths");
    json_decref(message);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_field_comes_back),
                                       cmocka_unit_test(what_is_missing_is_said)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
