/* The messages of the job `tune`, written and read again. */
#include "check.h"
#include "job/send.h"
#include "job/tune_job.h"

static struct aob_tune_view view_of(const char *truth)
{
    return (struct aob_tune_view){
        .truth = truth,
        .drawing = {.backend = "vulkan",
                    .view = {.scene = "corner",
                             .camera = {.eye = {1, 2, 3}, .fov_deg = 50},
                             .width = 8,
                             .height = 4,
                             .gbuffer = "/g"}},
        .frame = {.technique = {"alchemy", NULL, "89ab"}, .params = {0.5, 2}, .param_count = 2}};
}

static json_t *message_of(void)
{
    struct aob_tune_view views[2] = {view_of("/a"), view_of("/b")};
    return send(aob_tune_job_to_json(&(struct aob_tune_job){
        .views = views,
        .view_count = 2,
        .axes = {{.index = 1, .log = true, .low = 0.125, .high = 8, .start = 2, .scale = 0.5}},
        .axis_count = 1,
        .probe = true,
        .global = 30,
        .local = 20,
        .step = 0.25}));
}

static void a_job(void **state)
{
    (void)state;
    struct aob_tune_job back;
    struct aob_error error = {{0}};
    json_t *message = message_of();
    if (!aob_tune_job_from_json(message, &back, &error))
        fail_msg("%s", error.text);
    assert_string_equal(json_string_value(json_object_get(message, "job")), "tune");
    assert_int_equal(back.view_count, 2);
    assert_string_equal(back.views[1].truth, "/b");
    assert_string_equal(back.views[1].frame.technique.technique, "alchemy");
    assert_near(back.views[1].frame.params[1], 2, 0);
    assert_string_equal(back.views[0].drawing.view.scene, "corner");
    assert_int_equal(back.axis_count, 1);
    assert_int_equal(back.axes[0].index, 1);
    assert_true(back.axes[0].log && back.probe);
    assert_near(back.axes[0].low, 0.125, 0);
    assert_near(back.axes[0].high, 8, 0);
    assert_near(back.axes[0].start, 2, 0);
    assert_near(back.axes[0].scale, 0.5, 0);
    assert_int_equal(back.global, 30);
    assert_int_equal(back.local, 20);
    assert_near(back.step, 0.25, 0);
    aob_tune_job_finish(&back);
    json_decref(message);
}

static void refused(const char *member, json_t *value, const char *says)
{
    struct aob_tune_job back;
    struct aob_error error = {{0}};
    json_t *message = message_of(), *axis = json_array_get(json_object_get(message, "axes"), 0);
    json_object_set_new(json_object_get(axis, member) ? axis : message, member, value);
    assert_false(aob_tune_job_from_json(message, &back, &error));
    assert_contains(error.text, says);
    aob_tune_job_finish(&back);
    json_decref(message);
}

static void what_is_no_job(void **state)
{
    (void)state;
    refused("views", json_array(), "lacks views");
    refused("axes", json_array(), "lacks views, axes");
    refused("step", json_string("wide"), "how long it searches");
    refused("views", json_pack("[{s:s}]", "backend", "vulkan"), "has no truth");
    refused("index", json_integer(2), "is of no parameter");
    refused("index", json_integer(-1), "makes no sense");
    refused("low", json_real(0), "makes no sense"); /* of a logarithm */
    refused("low", json_real(3), "makes no sense");
    refused("high", json_real(1), "makes no sense");
    refused("scale", json_real(0), "makes no sense");
}

static void answers(void **state)
{
    (void)state;
    struct aob_tune_progress told;
    struct aob_tune_result back;
    json_t *message = send(aob_tune_progress_to_json(&(struct aob_tune_progress){3, 60, 0.125}));
    assert_true(aob_tune_progress_from_json(message, &told));
    assert_int_equal(told.done, 3);
    assert_int_equal(told.of, 60);
    assert_near(told.error, 0.125, 0);
    assert_false(aob_tune_result_from_json(message, &back));
    json_decref(message);
    message = send(aob_tune_result_to_json(&(struct aob_tune_result){.values = {0.1, 3},
                                                                     .idle = {true, false},
                                                                     .count = 2,
                                                                     .start_error = 0.5,
                                                                     .error = 0.25,
                                                                     .evaluations = 61}));
    assert_true(aob_tune_result_from_json(message, &back));
    assert_int_equal(back.count, 2);
    assert_near(back.values[0], 0.1, 0);
    assert_near(back.values[1], 3, 0);
    assert_true(back.idle[0] && !back.idle[1]);
    assert_near(back.start_error, 0.5, 0);
    assert_near(back.error, 0.25, 0);
    assert_int_equal(back.evaluations, 61);
    json_object_set_new(message, "idle", json_array());
    assert_false(aob_tune_result_from_json(message, &back));
    json_decref(message);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_job),
        cmocka_unit_test(what_is_no_job),
        cmocka_unit_test(answers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
