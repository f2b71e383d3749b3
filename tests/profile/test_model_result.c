/* The modelled times of a result, as its document has them: what a pass did becomes the model's input, and what is not
 * known is null. */
#include "check.h"
#include "made.h"
#include "profile/model_result.h"
#include "streams.h"

/* Two levels, one unit of each resource a nanosecond. */
static struct aob_profile device(void)
{
    struct aob_profile profile = made_profile();
    profile.levels[1] = profile.levels[0];
    snprintf(profile.levels[1].name, sizeof profile.levels[1].name, "L2");
    profile.levels[1].sector = 128;
    profile.levels[0].fill = profile.levels[0].ports = 1;
    profile.level_count = 2;
    profile.rates = (struct aob_rates){.clock = 1,
                                       .alu_clock = 1,
                                       .lanes = 1,
                                       .special = 0.5,
                                       .texture_units = 1,
                                       .tags = 4,
                                       .point_64 = 2,
                                       .rops = 1,
                                       .memory = 1,
                                       .launch = 3};
    profile.facts[0] = (struct aob_profile_fact){(char *)(uintptr_t) "rates.special", NULL, NULL, false};
    profile.facts[1] = (struct aob_profile_fact){(char *)(uintptr_t) "rates.clock", NULL, NULL, true};
    profile.facts[2] = (struct aob_profile_fact){(char *)(uintptr_t) "levels.L1.fill", NULL, NULL, false};
    profile.facts[3] = (struct aob_profile_fact){(char *)(uintptr_t) "levels.L1.size", NULL, NULL, false};
    profile.fact_count = 4;
    return profile;
}

/* In ms: targets .008, fills .064 and .128 (middle .096), memory .0128 + .001 and .0256 + .001. */
static struct aob_cache_pass done(void)
{
    return (struct aob_cache_pass){.name = "ao",
                                   .width = 10,
                                   .height = 10,
                                   .pixels = 100,
                                   .bytes_written = 1000,
                                   .target_pixels = 8000,
                                   .issue = {50000, 70000, 90000},
                                   .levels = {{{9000, 1000, 0, 0, 0}, {9000, 2000, 0, 0, 0}},
                                              {{1000, 100, 0, 0, 0}, {2000, 200, 0, 0, 0}}}};
}

static const json_t *at(const json_t *object, const char *first, const char *second)
{
    const json_t *member = json_object_get(object, first);
    return second ? json_object_get(member, second) : member;
}

static void add_pass(struct aob_cache_result *result, const char *name)
{
    struct aob_cache_pass *pass = AOB_PUSH(result->passes, result->pass_count, result->pass_capacity);
    *pass = done();
    snprintf(pass->name, sizeof pass->name, "%s", name);
    aob_cache_result_add(result, pass);
}

static const struct {
    const char *path;
    double value;
} rows[] = {
    {"modelled.passes.0.resources.alu", 0.04},
    {"modelled.frame.resources.alu", 0.34},
    {"modelled.passes.0.resources.texture", 0.07},
    {"modelled.frame.resources.texture", 0.14},
    {"modelled.passes.0.resources.L1", 0.096},
    {"modelled.frame.resources.L1", 0.192},
    {"modelled.passes.0.resources.memory", 0.0202},
    {"modelled.frame.resources.memory", 0.0404},
    {"modelled.passes.0.resources.targets", 0.008},
    {"modelled.frame.resources.targets", 0.016},
    {"modelled.passes.0.launch_ms", 0.003},
    {"modelled.frame.launch_ms", 0.006},
    {"modelled.passes.0.low_ms", 0.064 + 0.003},
    {"modelled.passes.0.high_ms", 0.04 + 0.09 + 0.128 + 0.0266 + 0.008 + 0.003},
    {"frame.operations.alu", 340000},
    {"frame.operations.special", 11000},
    {"passes.1.operations.image", 5},
};

static void check_words(const json_t *modelled)
{
    const json_t *passes = at(modelled, "passes", NULL), *unverified = at(modelled, "unverified", NULL);
    const json_t *ao = json_array_get(passes, 0), *blur = json_array_get(passes, 1);
    assert_string_equal(json_string_value(at(ao, "name", NULL)), "ao");
    assert_string_equal(json_string_value(at(ao, "limit", NULL)), "L1");
    assert_string_equal(json_string_value(at(blur, "limit", NULL)), "alu");
    assert_string_equal(json_string_value(at(modelled, "frame", "limit")), "alu");
    assert_int_equal(json_object_size(at(ao, "resources", NULL)), 5);
    assert_int_equal(json_array_size(unverified), 3);
    assert_string_equal(json_string_value(json_array_get(unverified, 0)), "rates.special");
    assert_string_equal(json_string_value(json_array_get(unverified, 1)), "levels.L1.fill");
    assert_string_equal(json_string_value(json_array_get(unverified, 2)), "levels.L1.size");
}

static void test_document(void **state)
{
    (void)state;
    struct aob_profile profile = device();
    struct aob_cache_result result = {.profile = &profile};
    add_pass(&result, "ao");
    add_pass(&result, "blur");
    aob_cache_result_count(&result, 0, &(struct aob_operations){.alu = 1, .special = 1, .image = 1});
    assert_false(aob_model_result_known(&result)); /* of one pass of two, and not for good */
    aob_cache_result_count(&result, 0, &(struct aob_operations){.alu = 40000, .special = 10000, .image = 7});
    aob_cache_result_count(&result, 1, &(struct aob_operations){.alu = 300000, .special = 1000, .image = 5});
    json_t *document = aob_cache_result_to_json(&result);
    for (size_t i = 0; i < AOB_COUNT(rows); i++)
        assert_near(made_real_at(document, rows[i].path), rows[i].value, 1e-9 * rows[i].value);
    assert_near(made_real_at(document, "modelled.frame.ms"),
                made_real_at(document, "modelled.passes.0.ms") +
                    made_real_at(document, "modelled.passes.1.ms"),
                1e-12);
    check_words(at(document, "modelled", NULL));
    json_decref(document);
    aob_cache_result_finish(&result);
}

/* Without rates, and without counts, there is no time. */
static void test_unknown(void **state)
{
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct aob_profile profile = device();
        struct aob_cache_result result = {.profile = &profile};
        profile.rates.clock = i;
        add_pass(&result, "ao");
        if (i == 0)
            aob_cache_result_count(&result, 0, &(struct aob_operations){.alu = 1});
        json_t *document = aob_cache_result_to_json(&result);
        assert_true(json_is_null(at(document, "modelled", NULL)));
        assert_int_equal(json_is_null(at(at(document, "frame", NULL), "operations", NULL)), i);
        json_decref(document);
        aob_cache_result_finish(&result);
    }
}

/* A simulation fills in what the texture units issue and what reaches the targets: 8 x 8 pixels, of which each reads its
 * own texel of 4 bytes. A row of a quad lies in a line of 64 bytes of a linear texture, its rows in two, 256 bytes apart,
 * so in the same bank of four. */
static void test_simulated(void **state)
{
    (void)state;
    struct aob_profile profile = device();
    struct aob_error error = {{0}};
    struct aob_trace_frame *frame = AOB_NEW(struct aob_trace_frame);
    struct aob_trace_pass *pass = AOB_NEW(struct aob_trace_pass);
    uint32_t words[64];
    made_texture(frame, "own", AOB_R32F, 8, 8, 1);
    made_texture(frame, "out", AOB_R8, 8, 8, 1);
    *pass = made_pass(frame, 8, 8);
    pass->writes[0] = pass->writes[1] = (struct aob_trace_write){1, 0};
    pass->write_count = 2;
    for (uint32_t i = 0; i < 64; i++)
        words[i] = i;
    for (int i = 0; i < 2; i++) {
        profile.rates.clock = i;
        struct aob_simulation *simulation =
            aob_simulation_create(&(struct aob_simulation_desc){.profile = &profile});
        struct aob_trace_sink sink = aob_simulation_sink(simulation);
        assert_true(made_send(&sink, frame, pass, words, 1, &error));
        const struct aob_cache_pass *counts = &aob_simulation_result(simulation)->frame;
        assert_int_equal(counts->issue.least, 64 * i);
        assert_int_equal(counts->issue.banked, 128 * i);
        assert_int_equal(counts->issue.most, 128 * i);
        assert_int_equal(counts->target_pixels, 128);
        assert_false(aob_model_result_known(aob_simulation_result(simulation)));
        aob_simulation_count(simulation, 0, &(struct aob_operations){.alu = 3});
        assert_near(counts->operations.alu, 3, 0);
        assert_int_equal(aob_model_result_known(aob_simulation_result(simulation)), i);
        aob_simulation_destroy(simulation);
    }
    free(frame);
    free(pass);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_document),
        cmocka_unit_test(test_unknown),
        cmocka_unit_test(test_simulated),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
