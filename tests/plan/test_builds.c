#include <stdlib.h>
#include "base/memory.h"
#include "config/config_builds.h"
#include "made.h"
#include "plan/twins.h"
#include "technique/param.h"

static int set_up_builds(void **state)
{
    set_up(state);
    add_build("a.so", 'a');
    add_build("b.so", 'b');
    return 0;
}

#define CONFIG                                                                                               \
    "name: t\nscenes: [{name: corner, views: [front, far]}]\nresolutions: [64x36]\nbackends: [vulkan]\n"     \
    "options: {fetch: [sampled, storage], guard_band: [0, 8]}\n"                                             \
    "techniques:\n"                                                                                          \
    "  - {name: none}\n"                                                                                     \
    "  - {name: gtao, backends: [null], params: {blur: 0}, sweep: [{param: slices, values: [1, 2, 3]}]}\n"

/* Each case of the entry is there with both builds, the two beside each other and in one block; the rest is gone. */
static void test_pairs(void **state)
{
    (void)state;
    static const char *const wanted[] = {"gtao", NULL};
    const struct aob_config_builds builds = {{"a.so", "b.so"}, wanted};
    struct aob_config config;
    struct aob_plan plan;
    struct aob_error error = {{0}};
    assert_true(make_config(CONFIG, &config, &error));
    assert_true(aob_config_take_builds(&config, &builds, &error));
    if (!aob_plan_create(&plan, &config, &techniques, &error))
        fail_msg("%s", error.text);
    assert_int_equal(plan.case_count, 2 * 2 * 2 * 2 * 3);
    for (size_t i = 0; i < plan.case_count; i += 2) {
        const struct aob_case *a = &plan.cases[i], *b = &plan.cases[i + 1];
        assert_string_equal(a->technique->module, "a.so");
        assert_string_equal(b->technique->module, "b.so");
        assert_true(aob_case_same_but_build(a, b) && aob_case_same_block(a, b));
        assert_string_equal(a->backend, "null");
        assert_true(strcmp(a->key, b->key) != 0);
        assert_false(i && aob_case_same_but_build(a, &plan.cases[i - 1]));
    }
    assert_false(
        aob_case_same_but_build(&plan.cases[0], &plan.cases[plan.case_count - 1])); /* another view */
    aob_plan_finish(&plan);
    aob_config_finish(&config);
}

static void test_none(void **state)
{
    (void)state;
    static const char *const wanted[] = {"hbao", "loop", NULL};
    const struct aob_config_builds builds = {{"a.so", "b.so"}, wanted};
    struct aob_config config;
    struct aob_error error = {{0}};
    assert_true(make_config(CONFIG, &config, &error));
    assert_false(aob_config_take_builds(&config, &builds, &error));
    assert_contains(error.text, "(hbao, loop)");
    aob_config_finish(&config);
}

#define STORED                                                                                               \
    "name: t\nscenes: [{name: corner, views: [front, far]}]\nresolutions: [64x36]\nbackends: [vulkan]\n"     \
    "techniques:\n"                                                                                          \
    "  - {name: gtao, module: a.so, params: {blur: 0, radius: 0.7}, sweep: [{param: slices, values: [1, "    \
    "2]}]}\n"                                                                                                \
    "  - {name: hbao, params: {radius: 0.3}}\n"

/* What is kept stays the case that it was, key, targets and all, though the technique whose radius is a target went; and the
 * other build has the same parameters, whatever its defaults are. */
static void test_twins(void **state)
{
    (void)state;
    struct aob_config config;
    struct aob_plan plan;
    struct aob_error error = {{0}};
    char keys[2][AOB_KEY_SIZE];
    bool kept[6] = {false};
    size_t count = 0;
    if (!make(STORED, &config, &plan, &error))
        fail_msg("%s", error.text);
    assert_int_equal(plan.case_count, 6);
    for (size_t i = 0; i < plan.case_count; i++) {
        const struct aob_case *c = &plan.cases[i];
        kept[i] = c->technique->module &&
                  c->params[aob_param_find(c->technique->params, c->technique->param_count, "slices") -
                            c->technique->params] == 2;
        if (kept[i])
            memcpy(keys[count++], c->key, AOB_KEY_SIZE);
    }
    assert_int_equal(count, 2);
    assert_true(aob_plan_take_twins(&plan, kept, "b.so", &error));
    assert_int_equal(plan.case_count, 4);
    for (size_t i = 0; i < 4; i += 2) {
        const struct aob_case *a = &plan.cases[i], *b = &plan.cases[i + 1];
        assert_string_equal(a->key, keys[i / 2]);
        assert_string_equal(a->technique->module, "a.so");
        assert_string_equal(b->technique->module, "b.so");
        assert_true(aob_case_same_but_build(a, b) && aob_case_same_block(a, b));
        assert_true(strcmp(a->key, b->key) != 0);
        assert_int_equal(a->scene->target_count, 2);
    }
    bool all[4] = {true, true, true, true};
    assert_false(aob_plan_take_twins(&plan, all, "c.so", &error));
    assert_contains(error.text, "c.so");
    aob_plan_finish(&plan);
    aob_config_finish(&config);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_pairs), cmocka_unit_test(test_none),
                                       cmocka_unit_test(test_twins)};
    return cmocka_run_group_tests(tests, set_up_builds, tear_down);
}
