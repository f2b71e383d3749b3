/* Costs of sets from the passes of a few frames. The frames are made from known costs of known passes, so that every set's is known. */
#include "check.h"
#include <math.h>
#include <jansson.h>
#include "effects/cost.h"

enum {
    V = 1 << AOB_EFFECT_VISIBILITY,
    BOUNCES = 1 << AOB_EFFECT_MULTI_BOUNCE,
    BENT = 1 << AOB_EFFECT_BENT_NORMAL,
    LIGHT = 1 << AOB_EFFECT_DIRECTIONAL,
    LOBE = 1 << AOB_EFFECT_SPECULAR,
    MEAN = 1 << AOB_EFFECT_TEMPORAL,
    HALF = 1 << AOB_EFFECT_HALF_SIZE
};
static const double ref_ms = 20, rest = 0.01;

static double put(json_t *passes, const char *name, double ratio)
{
    json_array_append_new(passes, json_pack("{s:s, s:f}", "name", name, "ratio_to_ref", ratio));
    return ratio;
}

/* In fixed passes; visibility takes 3 at full size, bent normals a tenth more, both a quarter of it at half size and .4 to sample up. The composite takes
 * .6, and .05 more for each effect. The mean over time has four passes of its own. */
static double known(unsigned set, json_t *passes)
{
    bool bends = set & (BENT | LIGHT | LOBE);
    double sum = rest, base = bends ? 3.3 : 3, composite = 0.6;
    if (set)
        sum += put(passes, "horizon", set & HALF ? base / 4 : base);
    if (set & HALF)
        sum += put(passes, bends ? "bent_upsample" : "upsample", bends ? 0.44 : 0.4);
    if (set & BOUNCES)
        sum += put(passes, "bounces", 0.2);
    if (set & LIGHT)
        sum += put(passes, "irradiance", 0.5);
    if (set & LOBE)
        sum += put(passes, "specular", 0.6);
    if (set & MEAN)
        sum += put(passes, "changes", 0.3) + put(passes, "change_groups", 0.01) +
               put(passes, "changed", 0.02) + put(passes, "temporal", 0.4);
    composite += set & BOUNCES ? 0.05 : 0;
    composite += set & (BENT | LIGHT) ? 0.05 : 0;
    composite += set & LOBE ? 0.05 : 0;
    return sum + put(passes, "lit_composite", composite);
}

static json_t *record_of(unsigned set)
{
    json_t *passes = json_array();
    double ratio = known(set, passes);
    return json_pack("{s:{s:f, s:f, s:o}}", "time", "ratio_to_ref", ratio, "ref_ms", ref_ms, "passes",
                     passes);
}

static double known_ms(unsigned set)
{
    json_t *passes = json_array();
    double ms = ref_ms * known(set, passes);
    json_decref(passes);
    return ms;
}

static void measure(unsigned open, struct aob_effect_costs *costs, unsigned more)
{
    unsigned sets[AOB_EFFECT_FRAMES];
    costs->count = aob_effect_frames_choose(open, sets);
    for (size_t i = 0; i < costs->count; i++)
        costs->frames[i] = (struct aob_effect_frame){sets[i], record_of(sets[i])};
    if (more)
        costs->frames[costs->count++] = (struct aob_effect_frame){more, record_of(more)};
}

static void finish(struct aob_effect_costs *costs)
{
    for (size_t i = 0; i < costs->count; i++)
        json_decref((json_t *)(uintptr_t)costs->frames[i].record);
}

/* Every set that the open effects make. At full size `rest` is counted four times, which is .15 % of the frame. */
static void check_all(unsigned open, unsigned more)
{
    struct aob_effect_costs costs = {0};
    unsigned sets[AOB_EFFECT_SETS];
    size_t count = aob_effect_sets(open, sets);
    measure(open, &costs, more);
    for (size_t i = 0; i < count; i++) {
        double ms = aob_effect_cost(&costs, sets[i]), right = known_ms(sets[i]);
        if (!(fabs(ms / right - 1) < 0.015))
            print_message("           set %u: %.3f in place of %.3f ms\n", sets[i], ms, right);
        assert_true(fabs(ms / right - 1) < 0.015);
    }
    finish(&costs);
}

static void test_sums(void **state)
{
    (void)state;
    check_all(AOB_EFFECT_ALL, 0);
    check_all(V | BOUNCES | HALF, 0);
    check_all(V | HALF, 0);
    check_all(V | LOBE | HALF, 0);
    check_all(V | MEAN | HALF, 0);
    check_all(V | BOUNCES | MEAN | HALF, 0);
    check_all(V | BENT | LIGHT | HALF, 0);
    check_all(0, 0);
}

/* A timed frame of full size counts as it is, and the others of full size by it. */
static void test_full(void **state)
{
    struct aob_effect_costs costs = {0};
    (void)state;
    check_all(AOB_EFFECT_ALL, V | BENT);
    check_all(AOB_EFFECT_ALL, V | BENT | MEAN);
    measure(AOB_EFFECT_ALL, &costs, V);
    assert_float_equal(aob_effect_cost(&costs, V), known_ms(V), 1e-9);
    assert_true(fabs(aob_effect_cost(&costs, V | LIGHT) / known_ms(V | LIGHT) - 1) < 0.02);
    finish(&costs);
}

/* Modelled times stand in the place of measured ones. */
static void test_profile(void **state)
{
    json_t *record = json_loads("{\"cache\": {\"ps4\": {\"modelled\": {\"frame\": {\"ms\": 0.5}, \"passes\": "
                                "[{\"name\": \"lit_composite\", \"ms\": 0.4}]}}},"
                                " \"time\": {\"ratio_to_ref\": 9, \"ref_ms\": 9}}",
                                0, NULL);
    struct aob_effect_costs costs = {.frames = {{0, record}}, .count = 1, .profile = "ps4"};
    (void)state;
    assert_float_equal(aob_effect_cost(&costs, 0), 0.5, 1e-12);
    costs.profile = NULL;
    assert_float_equal(aob_effect_cost(&costs, 0), 81, 1e-12);
    json_decref(record);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sums),
        cmocka_unit_test(test_full),
        cmocka_unit_test(test_profile),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
