#include <stdlib.h>
#include "base/memory.h"
#include "made.h"
#include "plan/block.h"
#include "plan/shard.h"

/* 4 views x 2 backends x 2 sizes: 16 block groups of 16 cases, so 3 blocks each, the last of 4 cases. */
#define CONFIG                                                                                               \
    "name: t\nscenes: [{name: corner, views: [front, far]}, {name: plane, views: [front, low]}]\n"           \
    "resolutions: [64x36, 32x18]\nbackends: [vulkan, null]\n"                                                \
    "techniques:\n"                                                                                          \
    "  - {name: gtao, sweep: [{param: slices, values: [1, 2, 3, 4]}, {param: steps, values: [1, 2, 3, "      \
    "4]}]}\n"
enum { GROUP = 16, GROUPS = 16, CASES = GROUP * GROUPS, BLOCKS = GROUPS * 3 };

/* Which shard each case of the whole plan is in, by its key; fails where one is in none or in two. */
static void place_all(int count, int places[CASES])
{
    struct aob_config config;
    struct aob_plan whole;
    struct aob_error error;
    if (!make(CONFIG, &config, &whole, &error))
        fail_msg("%s", error.text);
    assert_int_equal(whole.case_count, CASES);
    memset(places, 0, CASES * sizeof *places);
    for (int index = 1; index <= count; index++) {
        struct aob_plan part;
        size_t at = 0;
        assert_true(aob_plan_create(&part, &config, &techniques, &error));
        aob_plan_keep_shard(&part, &(struct aob_shard){index, count});
        for (size_t i = 0; i < part.case_count; i++) { /* in the order of the whole */
            while (at < CASES && strcmp(whole.cases[at].key, part.cases[i].key) != 0)
                at++;
            assert_true(at < CASES && !places[at]);
            places[at] = index;
        }
        aob_plan_finish(&part);
    }
    aob_plan_finish(&whole);
    aob_config_finish(&config);
    for (size_t i = 0; i < CASES; i++)
        assert_true(places[i]);
}

static void test_parts(void **state)
{
    (void)state;
    static const int counts[] = {1, 2, 3, 4, 7, 64};
    int places[CASES];
    for (size_t c = 0; c < AOB_COUNT(counts); c++) {
        place_all(counts[c], places);
        for (size_t group = 0; group < CASES; group += GROUP)
            for (size_t i = 0; i < GROUP; i++) /* blocks of 6, 6 and 4 */
                assert_int_equal(places[group + i], places[group + i / AOB_BLOCK_MAX * AOB_BLOCK_MAX]);
    }
}

/* 48 blocks in 4 parts: 12 each, with a standard deviation of 3. */
static void test_spread(void **state)
{
    (void)state;
    int places[CASES], blocks[5] = {0};
    place_all(4, places);
    for (size_t group = 0; group < CASES; group += GROUP)
        for (size_t i = 0; i < GROUP; i += AOB_BLOCK_MAX)
            blocks[places[group + i]]++;
    for (int i = 1; i <= 4; i++)
        assert_true(blocks[i] >= 3 && blocks[i] <= 24);
    assert_int_equal(blocks[1] + blocks[2] + blocks[3] + blocks[4], BLOCKS);
}

/* One block for each view, size and backend: dealt out in turn, each of two parts would have one backend alone. */
static void test_neighbours(void **state)
{
    (void)state;
    struct aob_config config;
    struct aob_plan plan;
    struct aob_error error;
    static const char one[] =
        "name: t\nscenes: [{name: corner, views: [front, far]}, {name: plane, views: [front, low]}]\n"
        "resolutions: [64x36, 32x18]\nbackends: [vulkan, null]\ntechniques: [{name: gtao}]\n";
    for (int index = 1; index <= 2; index++) {
        bool drawn = false, null = false;
        if (!make(one, &config, &plan, &error))
            fail_msg("%s", error.text);
        assert_int_equal(plan.case_count, GROUPS);
        aob_plan_keep_shard(&plan, &(struct aob_shard){index, 2});
        for (size_t i = 0; i < plan.case_count; i++)
            *(strcmp(plan.cases[i].backend, "null") == 0 ? &null : &drawn) = true;
        assert_true(drawn && null);
        aob_plan_finish(&plan);
        aob_config_finish(&config);
    }
}

/* The blocks of the whole plan: none and two pairs of builds, then the third and the fourth pair. A run of a part has the same. */
static void test_blocks(void **state)
{
    (void)state;
    struct aob_config config;
    struct aob_plan plan;
    struct aob_error error;
    size_t at = 0, indices[AOB_BLOCK_MAX];
    add_build("a.so", 'a');
    if (!make("name: t\nscenes: [{name: corner, view: front}]\nresolutions: [64x36]\nbackends: [null]\n"
              "techniques:\n  - {name: none}\n"
              "  - {name: gtao, sweep: [{param: slices, values: [1, 2, 3, 4]}]}\n"
              "  - {name: gtao, module: a.so, sweep: [{param: slices, values: [1, 2, 3, 4]}]}\n",
              &config, &plan, &error))
        fail_msg("%s", error.text);
    aob_plan_keep_shard(&plan, &(struct aob_shard){1, 1});
    assert_int_equal(plan.case_count, 9);
    assert_int_equal(aob_plan_next_block(&plan, NULL, &at, indices), 5);
    assert_int_equal(aob_plan_next_block(&plan, NULL, &at, indices), 4);
    /* Where one is measured already, what is left of its block is not filled up. */
    const bool left[9] = {false, true, true, true, true, true, true, true, true};
    at = 0;
    assert_int_equal(aob_plan_next_block(&plan, left, &at, indices), 4);
    assert_int_equal(aob_plan_next_block(&plan, left, &at, indices), 4);
    assert_int_equal(at, 9);
    aob_plan_finish(&plan);
    aob_config_finish(&config);
}

static void test_parse(void **state)
{
    (void)state;
    static const char *const bad[] = {"",
                                      "2",
                                      "/4",
                                      "2/",
                                      "0/4",
                                      "5/4",
                                      "-1/4",
                                      "1/0",
                                      "1/4/2",
                                      "1 / 4",
                                      "1/4x",
                                      "+1/4",
                                      "1e0/4",
                                      "2/10001",
                                      "Env",
                                      "4294967297/4294967298",
                                      "1/4294967297",
                                      "2/4294967300",
                                      "4294967298/9",
                                      "100002/100004"};
    struct aob_shard shard;
    struct aob_error error = {{0}};
    assert_true(aob_shard_parse("2/4", &shard, &error));
    assert_true(shard.index == 2 && shard.count == 4);
    assert_true(aob_shard_parse("10000/10000", &shard, &error));
    assert_int_equal(shard.index, 10000);
    for (size_t i = 0; i < AOB_COUNT(bad); i++) {
        error = (struct aob_error){{0}};
        if (aob_shard_parse(bad[i], &shard, &error))
            fail_msg("'%s' is taken for a shard", bad[i]);
        assert_non_null(strstr(error.text, "is no shard: give 2/4"));
    }
}

static const char *const variables[] = {
    "SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN", "SLURM_ARRAY_TASK_MAX",
    "CI_NODE_INDEX",       "CI_NODE_TOTAL",          "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE",
};

/* `says`: the shard as I/N, or a part of the line. */
static void ask(const char *const values[8], const char *says)
{
    struct aob_shard shard;
    struct aob_error error = {{0}};
    char text[32] = "";
    for (size_t i = 0; i < AOB_COUNT(variables); i++)
        values[i] ? setenv(variables[i], values[i], 1) : unsetenv(variables[i]);
    if (aob_shard_parse("env", &shard, &error))
        snprintf(text, sizeof text, "%d/%d", shard.index, shard.count);
    if (!strstr(*text ? text : error.text, says))
        fail_msg("'%s%s' in place of '%s'", text, error.text, says);
    for (size_t i = 0; i < AOB_COUNT(variables); i++)
        unsetenv(variables[i]);
}

static void test_environment(void **state)
{
    (void)state;
    ask((const char *const[8]){"3", "4", "1", "4"}, "3/4");
    ask((const char *const[8]){"3", "4", "0", "3"}, "4/4");
    ask((const char *const[8]){[4] = "1", "4"}, "1/4");
    ask((const char *const[8]){[6] = "0", "4"}, "1/4");
    ask((const char *const[8]){"2", "4", "1", "4", "2", "4"}, "2/4");
    ask((const char *const[8]){0},
        "none of SLURM_ARRAY_TASK_ID, CI_NODE_INDEX and OMPI_COMM_WORLD_RANK is set");
    ask((const char *const[8]){"2", "4", "1", "4", "3", "4"}, "Slurm says shard 2/4 and GitLab 3/4");
    ask((const char *const[8]){"2", "4", "1", "4", "2", "5"}, "Slurm says shard 2/4 and GitLab 2/5");
    ask((const char *const[8]){"3", "1", "3", "3"},
        "says that its tasks are 1 from 3 to 3, which may be a part");
    ask((const char *const[8]){"1", "1", "1", "1"},
        "says that its tasks are 1 from 1 to 1, which may be a part");
    ask((const char *const[8]){"3", "2", "3", "4"},
        "says that its tasks are 2 from 3 to 4, which may be a part");
    ask((const char *const[8]){"1", "3", "1", "7"},
        "says that its tasks are 3 from 1 to 7, which may be a part");
    ask((const char *const[8]){"4", "4", "0", "12"},
        "says that its tasks are 4 from 0 to 12, which may be a part");
    ask((const char *const[8]){"2", "4"}, "SLURM_ARRAY_TASK_MIN is not set");
    ask((const char *const[8]){"2", NULL, "1", "4"}, "SLURM_ARRAY_TASK_COUNT is not set");
    ask((const char *const[8]){[4] = "0", "4"}, "CI_NODE_INDEX=0 is none of CI_NODE_TOTAL=4 tasks from 1");
    ask((const char *const[8]){[4] = "5", "4"}, "CI_NODE_INDEX=5 is none of CI_NODE_TOTAL=4 tasks from 1");
    ask((const char *const[8]){[4] = "two", "4"}, "CI_NODE_INDEX is 'two', which is no number of a task");
    ask((const char *const[8]){[4] = "1", "1"}, "GitLab says that its tasks are 1 from 1 to 1");
    ask((const char *const[8]){[6] = "0", "1"}, "Open MPI says that its tasks are 1 from 0 to 0");
    ask((const char *const[8]){[4] = "1", "0x4"}, "CI_NODE_TOTAL is '0x4', which is no number of a task");
    ask((const char *const[8]){[4] = "1", "4e0"}, "CI_NODE_TOTAL is '4e0'");
    ask((const char *const[8]){[4] = "1", "4294967300"}, "CI_NODE_TOTAL is '4294967300'");
    ask((const char *const[8]){[4] = "", "4", "2", "4"}, "3/4");
    ask((const char *const[8]){[5] = "1"}, "none of SLURM_ARRAY_TASK_ID");
    ask((const char *const[8]){[6] = "0", "10001"}, "or these are more than 10000");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_parts),  cmocka_unit_test(test_spread), cmocka_unit_test(test_neighbours),
        cmocka_unit_test(test_blocks), cmocka_unit_test(test_parse),  cmocka_unit_test(test_environment),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
