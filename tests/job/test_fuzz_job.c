/* The messages of the job `fuzz`, written and read again. */
#include "check.h"
#include "job/fuzz_job.h"
#include "job/send.h"
#include <string.h>

static void a_fuzz_job(void **state)
{
    (void)state;
    const struct aob_fuzz_job job = {.technique = {"gtao", NULL, "89ab"},
                                     .backend = "vulkan",
                                     .validate = true,
                                     .seed = (uint64_t)1 << 52,
                                     .from = 512,
                                     .count = 77,
                                     .known = 5,
                                     .images = "/out"};
    struct aob_fuzz_job back;
    struct aob_error error = {{0}};
    json_t *message = send(aob_fuzz_job_to_json(&job));
    assert_string_equal(json_string_value(json_object_get(message, "job")), "fuzz");
    if (!aob_fuzz_job_from_json(message, &back, &error))
        fail_msg("%s", error.text);
    assert_string_equal(back.technique.technique, "gtao");
    assert_string_equal(back.backend, "vulkan");
    assert_null(back.device);
    assert_true(back.validate && back.seed == (uint64_t)1 << 52 && back.from == 512 && back.count == 77);
    assert_int_equal(back.known, 5);
    assert_string_equal(back.images, "/out");
    json_object_del(message, "backend");
    assert_false(aob_fuzz_job_from_json(message, &back, &error));
    assert_contains(error.text, "no backend");
    json_decref(message);
}

static void what_is_found(void **state)
{
    (void)state;
    const struct aob_fuzz_answer answer = {.message = AOB_FUZZ_FOUND,
                                           .index = 513,
                                           .fault = "not finite",
                                           .sentence = "pixel (1, 2) is nan",
                                           .hostile = true,
                                           .smallest = json_pack("{s:i}", "width", 2)};
    struct aob_fuzz_answer back;
    json_t *message = send(aob_fuzz_answer_to_json(&answer));
    assert_true(aob_fuzz_answer_from_json(message, &back));
    assert_int_equal(back.message, AOB_FUZZ_FOUND);
    assert_true(back.index == 513 && back.hostile);
    assert_string_equal(back.fault, "not finite");
    assert_string_equal(back.sentence, "pixel (1, 2) is nan");
    assert_int_equal(json_integer_value(json_object_get(back.smallest, "width")), 2);
    json_object_del(message, "fault");
    assert_false(aob_fuzz_answer_from_json(message, &back));
    json_decref(message);
}

static void what_is_begun(void **state)
{
    (void)state;
    struct aob_fuzz_answer back;
    json_t *message =
        send(aob_fuzz_answer_to_json(&(struct aob_fuzz_answer){.message = AOB_FUZZ_BEGUN, .index = 9}));
    assert_true(aob_fuzz_answer_from_json(message, &back));
    assert_true(back.message == AOB_FUZZ_BEGUN && back.index == 9 && !back.fault);
    json_object_del(message, "index");
    assert_false(aob_fuzz_answer_from_json(message, &back));
    json_decref(message);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_fuzz_job), cmocka_unit_test(what_is_found),
                                       cmocka_unit_test(what_is_begun)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
