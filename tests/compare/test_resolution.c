#include "check.h"
#include <math.h>
#include "base/memory.h"
#include "compare/resolution.h"
#include "timing/summary.h"

enum { PROCESSES = 5, ROUNDS = 8, FRAMES = 2 };

/* Milliseconds a frame of the case in each process: levels at -2, -1, 0, 1, 2 %, and no noise in them. The control is the
 * fixed pass itself. A round takes 1 + 1 + 3 frames' worth of 2 ms by the processor's clock, and twice that by the wall's. */
static double level(int process)
{
    return 3 * exp(0.01 * (process - 2));
}

static void set(struct aob_slot *slot, double ms)
{
    slot->frames = FRAMES;
    for (int c = 0; c < AOB_CLOCK_COUNT; c++)
        slot->whole.ns[c] = AOB_NO_TIME;
    slot->whole.ns[AOB_CLOCK_CPU] = llround(ms * 1e6 * FRAMES);
    slot->whole.ns[AOB_CLOCK_WALL] = 2 * slot->whole.ns[AOB_CLOCK_CPU];
    slot->causes = (struct aob_causes){.steal_ticks = AOB_CAUSE_UNKNOWN};
}

static void make(struct aob_round_list *rounds)
{
    for (int p = 0; p < PROCESSES; p++)
        for (int r = 0; r < ROUNDS; r++) {
            struct aob_round *round = AOB_PUSH(rounds->items, rounds->count, rounds->capacity);
            *round = (struct aob_round){
                .process = p, .number = r, .clock = AOB_CLOCK_CPU, .slot_count = AOB_SLOT_CASES + 1};
            set(&round->slots[AOB_SLOT_FIXED], 1);
            set(&round->slots[AOB_SLOT_CONTROL], 1);
            set(&round->slots[AOB_SLOT_CASES], level(p));
            round->slots[AOB_SLOT_CASES].causes.involuntary = r == 0;
        }
}

static void test_figures(void **state)
{
    (void)state;
    struct aob_round_list rounds = {0};
    make(&rounds);
    struct aob_resolution r = aob_resolution_of(&rounds, 1.5);
    assert_near(r.control.within, 0, 1e-12);
    assert_near(r.control.between, 0, 1e-12);
    assert_near(r.cost.within, 0, 1e-6);
    assert_near(r.cost.between, 0.01 * sqrt(2.5), 1e-6);
    assert_near(r.clean, 1 - 1 / 3.0 / ROUNDS, 1e-12);
    double all = 0;
    for (int p = 0; p < PROCESSES; p++)
        all += ROUNDS * FRAMES * 2 * (2 + level(p)) * 1e-3;
    assert_near(r.round_s, all / PROCESSES / ROUNDS, 1e-6);
    /* t x .0158 / sqrt(P) <= ln(1 + share): 13 processes for 1 % (t 2.179), 5 for 2 % (2.776), 4 for 3 % (3.182); each is
     * given a quarter of a second, 13 rounds. Three (4.303) do for 5 and 10 %, of seven rounds, which are twenty in all. */
    const double wanted[AOB_RESOLUTION_STEPS] = {13 * 13, 5 * 13, 4 * 13, 3 * 7, 3 * 7};
    for (int i = 0; i < AOB_RESOLUTION_STEPS; i++)
        assert_near(r.seconds[i], wanted[i] * r.round_s, 1e-6);
    assert_near(aob_resolution_of(&rounds, 1.25).recommended, 0.03, 0);
    assert_near(aob_resolution_of(&rounds, 100).recommended, 0.01, 0);
    assert_near(aob_resolution_of(&rounds, 1).recommended, 0.05, 0);
    assert_true(isnan(aob_resolution_of(&rounds, 20 * r.round_s).recommended));
    aob_rounds_finish(&rounds);
}

/* Of two slots of the same rounds, without the fixed pass: the levels lie evenly about 3, and Student's interval of five
 * of them reaches 2.7764 x .0158 / sqrt(5) to each side. */
static void test_quotient_of_slots(void **state)
{
    (void)state;
    struct aob_round_list rounds = {0};
    make(&rounds);
    struct aob_ratio up = aob_rounds_quotient(&rounds, AOB_SLOT_CASES, AOB_SLOT_CONTROL);
    struct aob_ratio down = aob_rounds_quotient(&rounds, AOB_SLOT_CONTROL, AOB_SLOT_CASES);
    assert_near(up.ratio, 3, 1e-6);
    assert_near(log(up.high / up.ratio), 2.7764 * 0.01 * sqrt(2.5) / sqrt(5), 1e-5);
    assert_near(down.ratio, 1 / up.ratio, 1e-9);
    assert_near(down.low, 1 / up.high, 1e-9);
    for (size_t r = 0; r < rounds.count; r++) /* the fixed pass is not asked */
        rounds.items[r].slots[AOB_SLOT_FIXED].whole.ns[AOB_CLOCK_CPU] *= (int64_t)(1 + r);
    assert_near(aob_rounds_quotient(&rounds, AOB_SLOT_CASES, AOB_SLOT_CONTROL).ratio, up.ratio, 1e-12);
    aob_rounds_finish(&rounds);
}

static void test_words(void **state)
{
    (void)state;
    struct aob_round_list rounds = {0};
    struct aob_text text = {0};
    make(&rounds);
    struct aob_resolution r = aob_resolution_of(&rounds, 100);
    aob_resolution_print(&r, &text);
    assert_contains(text.data, "40 rounds of 0.020 s in 5 processes");
    assert_contains(text.data, "1.58 %");
    assert_contains(text.data, "recommended: precision: 1%");
    aob_text_finish(&text);
    r.recommended = NAN;
    r.seconds[0] = INFINITY;
    aob_resolution_print(&r, &text);
    assert_contains(text.data, "1 %: not in 1e6 s");
    assert_contains(text.data, "recommended: none");
    json_t *json = aob_resolution_to_json(&r);
    assert_true(json_is_null(json_object_get(json, "recommended")));
    assert_int_equal(json_array_size(json_object_get(json, "resolution")), AOB_RESOLUTION_STEPS);
    json_decref(json);
    aob_text_finish(&text);
    aob_rounds_finish(&rounds);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_figures),
                                       cmocka_unit_test(test_quotient_of_slots),
                                       cmocka_unit_test(test_words)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
