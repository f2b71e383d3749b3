/* What a block's processes answer beside the records of cases. */
#include "check.h"
#include "job/send.h"
#include "job/block_job.h"

static void what_a_block_times(void **state)
{
    (void)state;
    json_t *names = json_pack("[s, s]", "ao", "blur");
    struct aob_block_timed back,
        timed = {.clock = AOB_CLOCK_WALL, .clock_reason = "it lies", .threads = 7, .count = 2};
    timed.cases[0] = (struct aob_block_timed_case){4, 1.25, names};
    timed.cases[1] = (struct aob_block_timed_case){0, 0.5, json_incref(names)};
    json_t *message = send(aob_block_timed_to_json(&timed));
    assert_true(aob_block_timed_from_json(message, 5, &back));
    assert_string_equal(back.clock_reason, "it lies");
    assert_true(back.clock == AOB_CLOCK_WALL && back.threads == 7 && back.count == 2);
    assert_true(back.cases[0].index == 4 && back.cases[0].setup_ms == 1.25);
    assert_true(json_equal(back.cases[0].passes, names));
    assert_true(back.cases[1].index == 0 && back.cases[1].setup_ms == 0.5);
    aob_block_timed_finish(&back);
    assert_false(aob_block_timed_from_json(message, 4, &back)); /* it has no case 4 */
    json_object_set_new(json_object_get(message, "timed"), "clock", json_string("sun"));
    assert_false(aob_block_timed_from_json(message, 5, &back));
    json_object_set_new(json_object_get(message, "timed"), "clock", json_string("wall"));
    json_object_del(json_object_get(message, "timed"), "clock_reason");
    assert_false(aob_block_timed_from_json(message, 5, &back));
    aob_block_timed_finish(&timed);
    json_decref(message);
}

static void shares_of_a_block(void **state)
{
    (void)state;
    struct aob_block_shares shares = {1.5, 2.5, 3.5}, back;
    json_t *message = send(aob_block_shares_to_json(&shares));
    assert_true(aob_block_shares_from_json(message, &back));
    assert_true(back.measured == 1.5 && back.warmup == 2.5 && back.images == 3.5);
    json_decref(message);
    message = json_pack("{s:i}", "index", 0);
    assert_false(aob_block_shares_from_json(message, &back));
    json_decref(message);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_a_block_times),
                                       cmocka_unit_test(shares_of_a_block)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
