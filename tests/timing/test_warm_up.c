#include "check.h"
#include <math.h>
#include "base/memory.h"
#include "script.h"

/* What comes before the rounds, on a scripted clock (script.h): the warm-up, and how many frames a slot gets. */

/* Slots of the fixed pass alone, behind the two turns of all slots: it is steady when three successive ones are within 10
 * %. Where clocks rise (it is judged by wall time, 4 ms a slot), not before 200 ms of load, and for 2 s at most. */
static void test_warm_up(void **state)
{
    (void)state;
    static const struct {
        double fixed_ms[12]; /* behind the four of the two turns; 0: 2 */
        enum aob_clock clock;
        int slots; /* until it is steady */
    } rows[] = {
        {{2, 2, 2}, AOB_CLOCK_CPU, 3},
        {{9, 5, 2, 2, 2}, AOB_CLOCK_CPU, 5},
        {{2, 2.19, 2}, AOB_CLOCK_CPU, 3},
        {{2, 2.3, 2, 2, 2}, AOB_CLOCK_CPU, 5},
        {{2, 3, 2, 3, 2, 3, 2, 3, 2, 3, 2, 2}, AOB_CLOCK_CPU, 10},
        {{2}, AOB_CLOCK_WALL, 50},
        {{10, 10, 10, 10, 10}, AOB_CLOCK_WALL, 30}, /* five of 20 ms, 25 of 4 ms */
    };
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct script *s = script_create();
        memcpy(s->settling_ms + 4, rows[i].fixed_ms, sizeof rows[i].fixed_ms);
        int rounds = (int)script_count_rounds(
            s, (struct aob_timing_desc){.seconds = SCRIPT_ENDLESS, .clock = rows[i].clock});
        assert_int_equal(s->count, (SCRIPT_WARM_UP + rounds) * SCRIPT_SLOTS + rows[i].slots);
        script_destroy(s);
    }
}

static void test_restless_device(void **state)
{
    (void)state;
    struct script *s = script_create();
    for (int i = 4; i < 2000; i++)
        s->settling_ms[i] = i % 2 ? 2 : 3; /* 4 and 6 ms of wall time: 400 slots are 2 s */
    script_count_rounds(s, (struct aob_timing_desc){.seconds = 0.01, .clock = AOB_CLOCK_WALL});
    int settling = 0;
    while (s->order[2 * SCRIPT_SLOTS + settling] < 0)
        settling++;
    assert_int_equal(settling, 400 + 2); /* the two that come next count frames */
    script_destroy(s);
}

static double cheap_ms, dear_ms;
static double cheap_and_dear(const struct script *s, int index, int round)
{
    (void)s;
    (void)round;
    return index == 1 ? dear_ms : cheap_ms;
}

/* By the host's clock, which goes on where the one that is judged sees nothing. */
static double longer(const struct script *s, int index, int round)
{
    return 2 * cheap_and_dear(s, index, round) + 1e-3;
}

/* A slot takes as long as the dearest frame, 2 ms at least and 100 at most, and each case has as many frames as that. */
static void test_frames_a_slot(void **state)
{
    (void)state;
    static const struct {
        double fixed, cheap, dear;
        int frames[3]; /* of each */
    } rows[] = {
        {2, 4, 4, {2, 1, 1}},         {2, 0.3, 4, {2, 13, 1}},     {2, 0.3, 30, {15, 100, 1}},
        {2, 1.7, 4, {2, 2, 1}},       {2, 0.3, 60, {30, 200, 1}},  {2, 0.3, 400, {50, 333, 1}},
        {2, 0.01, 1, {1, 200, 2}},    {0.5, 0.1, 0.4, {4, 20, 5}}, {2, 0.001, 0.5, {1, 2000, 4}},
        {2, 1e-9, 2, {1, 100000, 1}}, {150, 120, 400, {1, 1, 1}},
    };
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct script *s = script_create();
        s->fixed_ms = rows[i].fixed;
        cheap_ms = rows[i].cheap;
        dear_ms = rows[i].dear;
        s->cpu_ms = cheap_and_dear;
        s->wall_ms = longer;
        struct aob_round_list rounds = script_measure(s, (struct aob_timing_desc){.seconds = SCRIPT_ENDLESS});
        static const size_t slots[3] = {AOB_SLOT_FIXED, AOB_SLOT_CASES, AOB_SLOT_CASES + 1};
        for (int k = 0; k < 3; k++)
            assert_int_equal(rounds.items[rounds.count - 1].slots[slots[k]].frames, rows[i].frames[k]);
        assert_int_equal(s->repeats[s->count - 1],
                         rounds.items[rounds.count - 1]
                             .slots[s->order[s->count - 1] + 2 - (s->order[s->count - 1] < 0)]
                             .frames);
        assert_near(aob_slot_ms(&rounds.items[0].slots[AOB_SLOT_CASES + 1], AOB_CLOCK_CPU), dear_ms,
                    1e-5); /* of a frame */
        aob_rounds_finish(&rounds);
        script_destroy(s);
    }
}

static double nothing(const struct script *s, int index, int round)
{
    (void)s;
    (void)index;
    (void)round;
    return 0;
}

/* No number of its rounds would be a second. */
static void test_a_clock_that_stands_still(void **state)
{
    (void)state;
    struct script *s = script_create();
    const struct aob_timing_source source = script_source(s);
    struct aob_round_list rounds = {0};
    struct aob_error error = {{0}};
    s->wall_ms = nothing;
    const struct aob_timing_desc desc = {
        .fixed = s->fixed, .frames = s->frames, .frame_count = SCRIPT_CASES, .seconds = 1, .source = &source};
    assert_false(aob_timing_run(&desc, &rounds, &error));
    assert_contains(error.text, "the host's clock stands still: it saw 0 ns");
    aob_rounds_finish(&rounds);
    script_destroy(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_warm_up), cmocka_unit_test(test_restless_device),
                                       cmocka_unit_test(test_frames_a_slot),
                                       cmocka_unit_test(test_a_clock_that_stands_still)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
