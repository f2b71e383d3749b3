/* The messages of the job `stress`, written and read again. */
#include "check.h"
#include "job/send.h"
#include <math.h>
#include <string.h>
#include "job/stress_job.h"

static void a_stress_job(void **state)
{
    (void)state;
    const char *names[] = {"sky_is_open", "plane_is_open"};
    const struct aob_stress_job job = {.technique = {"gtao", "/m/gtao.so", "89ab"},
                                       .backend = "gl-egl",
                                       .device = "radeon",
                                       .quick = true,
                                       .properties = names,
                                       .property_count = 2,
                                       .images = "/out/images"};
    struct aob_stress_job back;
    struct aob_error error = {{0}};
    json_t *message = send(aob_stress_job_to_json(&job));
    assert_string_equal(json_string_value(json_object_get(message, "job")), "stress");
    if (!aob_stress_job_from_json(message, &back, &error))
        fail_msg("%s", error.text);
    assert_string_equal(back.technique.module, "/m/gtao.so");
    assert_string_equal(back.backend, "gl-egl");
    assert_string_equal(back.device, "radeon");
    assert_true(back.quick && !back.validate);
    assert_int_equal(back.property_count, 2);
    assert_string_equal(back.properties[0], "sky_is_open");
    assert_string_equal(back.properties[1], "plane_is_open");
    assert_string_equal(back.images, "/out/images");
    aob_stress_job_finish(&back);
    json_object_del(message, "backend");
    assert_false(aob_stress_job_from_json(message, &back, &error));
    assert_contains(error.text, "no backend");
    json_object_del(message, "technique"); /* of the instruments */
    assert_true(aob_stress_job_from_json(message, &back, &error));
    assert_null(back.technique.technique);
    aob_stress_job_finish(&back);
    json_array_set_new(json_object_get(message, "properties"), 1, json_integer(3));
    assert_false(aob_stress_job_from_json(message, &back, &error));
    assert_contains(error.text, "property 1");
    json_decref(message);
}

static void what_is_opened_and_begun(void **state)
{
    (void)state;
    struct aob_stress_answer back;
    json_t *message = send(aob_stress_answer_to_json(
        &(struct aob_stress_answer){.message = AOB_STRESS_OPENED, .device = "llvmpipe", .driver = "Mesa"}));
    assert_true(aob_stress_answer_from_json(message, &back));
    assert_int_equal(back.message, AOB_STRESS_OPENED);
    assert_string_equal(back.device, "llvmpipe");
    assert_string_equal(back.driver, "Mesa");
    json_decref(message);
    message = send(aob_stress_answer_to_json(
        &(struct aob_stress_answer){.message = AOB_STRESS_BEGUN, .property = "sky_is_open"}));
    assert_true(aob_stress_answer_from_json(message, &back));
    assert_int_equal(back.message, AOB_STRESS_BEGUN);
    assert_string_equal(back.property, "sky_is_open");
    json_object_set_new(message, "message", json_string("guessed"));
    assert_false(aob_stress_answer_from_json(message, &back));
    json_decref(message);
}

/* An answer that is no number travels as one: the worst of all. */
static void what_is_answered(void **state)
{
    (void)state;
    struct aob_stress_answer answer = {.message = AOB_STRESS_ANSWERED,
                                       .property = "sky_is_open",
                                       .outcome = "fail",
                                       .worst = NAN,
                                       .bound = 1.0 / 255,
                                       .declared = true,
                                       .where = "pixel (3, 4)",
                                       .reason = "pixel (1, 2)",
                                       .image = "a.exr",
                                       .compared = true},
                             back;
    json_t *message = send(aob_stress_answer_to_json(&answer));
    assert_true(aob_stress_answer_from_json(message, &back));
    assert_int_equal(back.message, AOB_STRESS_ANSWERED);
    assert_true(isnan(back.worst) && back.bound == 1.0 / 255 && back.declared && back.compared);
    assert_string_equal(back.outcome, "fail");
    assert_string_equal(back.where, "pixel (3, 4)");
    assert_string_equal(back.reason, "pixel (1, 2)");
    assert_string_equal(back.image, "a.exr");
    json_object_del(message, "outcome");
    assert_false(aob_stress_answer_from_json(message, &back));
    json_decref(message);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_stress_job),
                                       cmocka_unit_test(what_is_opened_and_begun),
                                       cmocka_unit_test(what_is_answered)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
