/* What is asked of the worker that reads a capture, and what it answers: every field comes back, and what is missing is said. */
#include "check.h"
#include "job/capture_job.h"
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "job/send.h"

/* Paths travel as absolute ones. */
static void assert_path(const char *got, const char *relative)
{
    char folder[1024], wanted[1200];
    assert_non_null(getcwd(folder, sizeof folder));
    snprintf(wanted, sizeof wanted, "%s/%s", folder, relative);
    assert_string_equal(got, wanted);
}

static void check_materials(const struct aob_convention *convention)
{
    assert_true(convention->no_materials);
    assert_string_equal(convention->material_channels[AOB_MATERIAL_ALBEDO], "paint");
    assert_string_equal(convention->material_channels[AOB_MATERIAL_ROUGHNESS], "");
    assert_string_equal(convention->material_channels[AOB_MATERIAL_METALNESS], "metal");
}

static void a_capture_job(void **state)
{
    (void)state;
    struct aob_capture_job out = {.file = "F.exr",
                                  .out = "g.exr",
                                  .convention = {.depth = AOB_DEPTH_DEVICE_REVERSED,
                                                 .normals = AOB_NORMALS_WORLD,
                                                 .near = 0.1,
                                                 .far = INFINITY,
                                                 .left_handed = true,
                                                 .up = {0, 0, 1},
                                                 .depth_channel = "zed",
                                                 .normal_channel = "nor",
                                                 .no_materials = true,
                                                 .material_channels = {"paint", "", "metal"}},
                                  .fov_deg = 50,
                                  .has_camera = true,
                                  .eye = {1, 2, 3},
                                  .target = {4, 5, 6}},
                           job;
    struct aob_error error = {{0}};
    json_t *message = send(aob_capture_job_to_json(&out));
    assert_true(aob_capture_job_from_json(message, &job, &error));
    assert_string_equal(job.file, "F.exr");
    assert_path(job.out, "g.exr");
    assert_int_equal(job.convention.depth, AOB_DEPTH_DEVICE_REVERSED);
    assert_int_equal(job.convention.normals, AOB_NORMALS_WORLD);
    assert_true(job.convention.near == 0.1 && isinf(job.convention.far) && job.convention.left_handed);
    assert_true(job.convention.up[2] == 1 && job.convention.up[0] == 0);
    assert_string_equal(job.convention.depth_channel, "zed");
    assert_string_equal(job.convention.normal_channel, "nor");
    check_materials(&job.convention);
    assert_true(job.fov_deg == 50 && job.ortho_height == 0 && job.has_camera);
    assert_true(job.eye[1] == 2 && job.target[2] == 6);
    json_decref(message);
    out.has_camera = false;
    message = send(aob_capture_job_to_json(&out));
    assert_true(aob_capture_job_from_json(message, &job, &error));
    assert_false(job.has_camera);
    json_decref(message);
}

static void a_capture_job_that_lacks_a_field(void **state)
{
    static const char *const needed[] = {"file", "depth_channel", "material_channels"};
    struct aob_capture_job job;
    struct aob_error error = {{0}};
    (void)state;
    for (size_t i = 0; i < sizeof needed / sizeof *needed; i++) {
        json_t *message =
            send(aob_capture_job_to_json(&(struct aob_capture_job){.file = "F.exr", .out = "g"}));
        assert_true(aob_capture_job_from_json(message, &job, &error));
        json_object_del(message, needed[i]);
        assert_false(aob_capture_job_from_json(message, &job, &error));
        json_decref(message);
    }
}

static void a_capture_answer(void **state)
{
    (void)state;
    json_t *warnings = json_pack("[s]", "two depths");
    struct aob_capture_answer answer = {.width = 64,
                                        .height = 36,
                                        .surface = 2000,
                                        .derived = 7,
                                        .materials = 5,
                                        .ortho_height = 3,
                                        .eye = {1, 2, 3},
                                        .target = {4, 5, 6},
                                        .warnings = warnings},
                              back;
    json_t *message = send(aob_capture_answer_to_json(&answer));
    json_decref(warnings);
    assert_true(aob_capture_answer_from_json(message, &back));
    assert_true(back.width == 64 && back.height == 36 && back.surface == 2000 && back.derived == 7);
    assert_int_equal(back.materials, 5);
    assert_true(back.fov_deg == 0 && back.ortho_height == 3 && back.eye[0] == 1 && back.target[1] == 5);
    assert_string_equal(json_string_value(json_array_get(back.warnings, 0)), "two depths");
    json_object_del(message, "eye");
    assert_false(aob_capture_answer_from_json(message, &back));
    json_decref(message);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_capture_job),
        cmocka_unit_test(a_capture_job_that_lacks_a_field),
        cmocka_unit_test(a_capture_answer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
