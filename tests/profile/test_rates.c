/* Rates of profiles: what is read, what is refused and where, and those that come with the program, against what is
 * published of their devices. */
#include "base/text.h"
#include "profile/model.h"
#include "profile_file.h"

/* clang-format off */
static const char good[] =
    "title: made\n"
    "units: " FACT("3") "\n"
    "in_flight: " FACT("4") "\n"
    "tile: " FACT("8x8") "\n"
    "warp: " FACT("8x4") "\n"
    "layout: " FACT("morton") "\n"
    "rates:\n"
    "  clock: " FACT("0.5") "\n"
    "  lanes: " FACT("240") "\n"
    "  special: " FACT("0.2") "\n"
    "  special_blocks: " FACT("true") "\n"
    "  texture_units: " FACT("16") "\n"
    "  tags: " FACT("4") "\n"
    "  rops: " FACT("8") "\n"
    "  memory: {value: 22.4, confirmed: 'a text'}\n"
    "  launch: " FACT("7.5") "\n"
    "levels:\n"
    "  - name: L1\n"
    "    size: " FACT("16 KiB") "\n"
    "    line: " FACT("64") "\n"
    "    ways: " FACT("4") "\n"
    "    index: " FACT("xor") "\n"
    "    fill: " FACT("64") "\n"
    "    ports: " FACT("6") "\n"
    "  - name: L2\n"
    "    size: " FACT("512 KiB") "\n"
    "    line: " FACT("64") "\n"
    "    ways: " FACT("8") "\n"
    "    index: " FACT("xor") "\n";
/* clang-format on */

static void write_changed(const char *from, const char *to)
{
    struct aob_text text = {0};
    const char *at = strstr(good, from);
    assert_non_null(at);
    aob_text_add(&text, "%.*s%s%s", (int)(at - good), good, to, at + strlen(from));
    write_file(text.data);
    aob_text_finish(&text);
}

static struct aob_profile read_changed(const char *from, const char *to)
{
    struct aob_profile profile;
    struct aob_error error = {{0}};
    write_changed(from, to);
    if (!aob_profile_read(&profile, path, &error))
        fail_msg("%s", error.text);
    return profile;
}

static void test_good(void **state)
{
    (void)state;
    struct aob_profile profile = read_changed("", "");
    const struct aob_rates *rates = &profile.rates;
    assert_near(rates->clock, 0.5, 0);
    assert_near(rates->alu_clock, 0.5, 0); /* the clock where the file has none */
    assert_near(rates->lanes, 240, 0);
    assert_near(rates->special, 0.2, 0);
    assert_true(rates->special_blocks);
    assert_near(rates->texture_units, 16, 0);
    assert_near(rates->tags, 4, 0);
    assert_near(rates->point_64, 2, 0);
    assert_near(rates->rops, 8, 0);
    assert_near(rates->memory, 22.4, 0);
    assert_near(rates->launch, 7.5, 0);
    assert_int_equal(profile.levels[0].fill, 64);
    assert_int_equal(profile.levels[0].ports, 6);
    aob_profile_finish(&profile);
    profile = read_changed("  lanes", "  alu_clock: " FACT("1.5") "\n  point_64: " FACT("1") "\n  lanes");
    assert_near(profile.rates.alu_clock, 1.5, 0);
    assert_near(profile.rates.point_64, 1, 0);
    aob_profile_finish(&profile);
}

/* Figures of one digest are of one device, its rates too. */
static void test_digest(void **state)
{
    (void)state;
    static const char *const changes[][2] = {
        {"", ""}, {"22.4", "22.5"}, {FACT("7.5"), FACT("7.6")}, {"ports: " FACT("6"), "ports: " FACT("7")}};
    char digests[AOB_COUNT(changes)][AOB_KEY_SIZE];
    for (size_t i = 0; i < AOB_COUNT(changes); i++) {
        struct aob_profile profile = read_changed(changes[i][0], changes[i][1]);
        aob_profile_digest(&profile, digests[i]);
        for (size_t j = 0; j < i; j++)
            assert_string_not_equal(digests[i], digests[j]);
        aob_profile_finish(&profile);
    }
}

struct damage {
    const char *from, *to;    /* in the good file */
    const char *place, *says; /* of the message */
};
static const struct damage damages[] = {
    {"  clock: " FACT("0.5") "\n", "", ":8:3: ", "'clock' is missing"},
    {"  lanes: " FACT("240") "\n", "", ":8:3: ", "'lanes' is missing"},
    {"  special: " FACT("0.2") "\n", "", ":8:3: ", "'special' is missing"},
    {"  special_blocks: " FACT("true") "\n", "", ":8:3: ", "'special_blocks' is missing"},
    {"  texture_units: " FACT("16") "\n", "", ":8:3: ", "'texture_units' is missing"},
    {"  tags: " FACT("4") "\n", "", ":8:3: ", "'tags' is missing"},
    {"  rops: " FACT("8") "\n", "", ":8:3: ", "'rops' is missing"},
    {"  memory: {value: 22.4, confirmed: 'a text'}\n", "", ":8:3: ", "'memory' is missing"},
    {"  launch: " FACT("7.5") "\n", "", ":8:3: ", "'launch' is missing"},
    {"  clock", "  speed: " FACT("1") "\n  clock", ":8:3: ", "unknown key 'speed'"},
    {"  rops: " FACT("8"), "  rops: 8", ":14:9: ", "a number has a source here"},
    {"clock: " FACT("0.5"), "clock: " FACT("0"), ":8:18: ", "0 is outside 0.001 .. 100"},
    {"clock: " FACT("0.5"), "clock: " FACT("-1"), ":8:18: ", "-1 is outside"},
    {"clock: " FACT("0.5"), "clock: " FACT("nan"), ":8:18: ", "nan"},
    {"clock: " FACT("0.5"), "clock: " FACT("800"), ":8:18: ", "800 is outside"}, /* MHz */
    {"special: " FACT("0.2"), "special: " FACT("4"), ":10:20: ", "4 is outside 0.001 .. 1"},
    {FACT("true"), FACT("perhaps"), ":11:27: ", "'perhaps'"},
    {"tags: " FACT("4"), "tags: " FACT("3"), ":13:17: ", "3 is no power of two"},
    {"tags: " FACT("4"), "tags: " FACT("32"), ":13:17: ", "32 is outside"},
    {"  lanes", "  point_64: " FACT("1.5") "\n  lanes", ":9:21: ", "1.5 is no power of two"},
    {"22.4", "0", ":15:19: ", "0 is outside"},
    {"launch: " FACT("7.5"), "launch: " FACT("-1"), ":16:19: ", "-1 is outside 0 .."},
    {"    fill: " FACT("64") "\n", "", ":18:5: ", "level 'L1' has no 'fill' and 'ports'"},
    {"    ports: " FACT("6") "\n", "", ":18:5: ", "level 'L1' has no 'fill' and 'ports'"},
    {"ports: " FACT("6"), "ports: " FACT("0"), ":24:20: ", "0 is outside 1"},
    {"fill: " FACT("64"), "fill: " FACT("0.5"), ":23:19: ", "0.5 is outside 1"},
    {"  - name: L2\n", "  - name: L2\n    fill: " FACT("64") "\n",
     ":26:11: ", "level 'L2' is filled from memory"},
    {"  - name: L2\n", "  - name: L2\n    ports: " FACT("2") "\n",
     ":26:12: ", "level 'L2' is filled from memory"},
    {"  - name: L2\n", "  - name: texture\n", ":25:11: ", "no level beside rates is called 'texture'"},
};

static void test_damaged(void **state)
{
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(damages); i++) {
        struct aob_profile profile;
        struct aob_error error = {{0}};
        write_changed(damages[i].from, damages[i].to);
        if (aob_profile_read(&profile, path, &error))
            fail_msg("row %zu was read", i);
        assert_contains(error.text, path);
        assert_contains(error.text, damages[i].place);
        assert_contains(error.text, damages[i].says);
    }
}

/* A fill without rates would be used by nothing. */
static void test_fill_alone(void **state)
{
    (void)state;
    struct aob_profile profile;
    struct aob_error error = {{0}};
    struct aob_text text = {0};
    const char *rates = strstr(good, "rates:"), *levels = strstr(good, "levels:");
    aob_text_add(&text, "%.*s%s", (int)(rates - good), good, levels);
    write_file(text.data);
    assert_false(aob_profile_read(&profile, path, &error));
    assert_contains(error.text, ":13:11: level 'L1' has a 'fill' or 'ports', and the profile has no 'rates'");
    aob_text_finish(&text);
}

/* What the machine tells has no fill, and there is no place to write one. */
static void test_levels_of_the_machine(void **state)
{
    (void)state;
    struct aob_profile profile;
    struct aob_error error = {{0}};
    struct aob_text text = {0};
    const char *levels = strstr(good, "levels:");
    aob_text_add(&text, "%.*slevels: {value: machine, confirmed: here}\n", (int)(levels - good), good);
    write_file(text.data);
    assert_false(aob_profile_read(&profile, path, &error));
    assert_contains(error.text, ":17:9: levels that the machine tells have no 'fill'");
    aob_text_finish(&text);
}

static struct aob_profile open_profile(const char *name)
{
    struct aob_profile profile;
    struct aob_error error = {{0}};
    struct aob_text file = {0};
    const char *build = getenv("AOBUDGET_BUILD");
    assert_non_null(build);
    aob_text_add(&file, "%s/../../configs/profiles/%s.yaml", build, name);
    if (!aob_profile_read(&profile, file.data, &error))
        fail_msg("%s", error.text);
    aob_text_finish(&file);
    return profile;
}

/* GB/s into the first two levels of the RX 5700 XT at 1.905 GHz, as AMD's paper on RDNA prints them, in bytes a clock: the
 * first from four shader arrays, the second from 16 channels. */
#define RDNA_GL1 (3900 / 1.905)
#define RDNA_L2  (1950 / 1.905)

/* What vendors and reviews print or measure of a device: GFLOP/s, Gtexel/s, Gpixel/s and GB/s, which no profile has as such,
 * special functions in G a second, and GB/s into the levels but the last, which the study of the rates worked out. 0: not
 * printed. */
static const struct {
    const char *name;
    double gflops, texels, pixels, memory, special, fill[AOB_PROFILE_MAX_LEVEL - 1];
} published[] = {
    {"xbox360", 240, 8, 4, 22.4, 0, {0}},
    {"geforce8600gts", 92.8, 10.8, 5.4, 32, 0, {43}},
    {"geforce8800gt", 336, 33.6, 9.6, 57.6, 0, {77}},
    {"geforce8800gtx", 345.6, 18.4, 13.8, 86.4, 0, {110}},
    {"geforce8800ultra", 387, 19.6, 14.7, 103.7, 0, {117.5}},
    {"gtx460se", 749, 31.2, 20.8, 108.8, 0, {166}},
    {"gtx580", 1581, 49.4, 37, 192.4, 0, {296}},
    {"ps4", 1843, 57.6, 25.6, 176, 0, {410}},
    {"xboxone", 1310, 40.9, 13.6, 68, 0, {218}},
    {"ps5", 10280, 321.6, 143, 448, 0, {RDNA_GL1 * 2.23, RDNA_L2 * 2.23}},
    {"xboxseriesx", 12150, 380, 116.8, 560, 0, {RDNA_GL1 * 1.825}},
    {"turing", 6451, 201.6, 80.6, 336, 30 * 16 * 1.68, {24 * 64 * 1.68}},
    {"rx6800xt", 20740, 648, 288, 512, 0, {2 * RDNA_GL1 * 2.25, RDNA_L2 * 2.25}},
    {"adreno640", 2 * 408, 14, 9.4, 30, 55, {88, 40}},
};

static void compare(const char *name, double value, double expected)
{
    if (expected > 0 && !(value > expected / 1.006 && value < expected * 1.006)) /* of three digits */
        fail_msg("%s: %g is not %g", name, value, expected);
}

static void test_published(void **state)
{
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(published); i++) {
        struct aob_profile profile = open_profile(published[i].name);
        const struct aob_rates *rates = &profile.rates;
        compare(profile.name, 2 * rates->lanes * rates->alu_clock, published[i].gflops);
        compare(profile.name, rates->texture_units * rates->clock, published[i].texels);
        compare(profile.name, rates->rops * rates->clock, published[i].pixels);
        compare(profile.name, rates->memory, published[i].memory);
        compare(profile.name, rates->lanes * rates->special * rates->alu_clock, published[i].special);
        for (int l = 0; l < AOB_PROFILE_MAX_LEVEL - 1; l++)
            compare(profile.name, (double)profile.levels[l].fill * profile.levels[l].ports * rates->clock,
                    published[i].fill[l]);
        aob_profile_finish(&profile);
    }
}

/* The cross-bilateral filters of Alchemy's table 1 at 1280x720: two passes of so many taps, each of two fetches. */
static void test_filters(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        uint64_t taps;
        double ms;
    } filters[] = {{"gtx580", 13, 0.970}, {"gtx460se", 11, 1.300}, {"xbox360", 11, 5.069}};
    for (size_t i = 0; i < AOB_COUNT(filters); i++) {
        struct aob_profile profile = open_profile(filters[i].name);
        uint64_t texels = 2 * filters[i].taps * 2 * 1280 * 720;
        struct aob_model_input input = {.issue = {texels, texels, texels}};
        struct aob_model_time modelled = aob_model_pass(&profile, &input);
        assert_near(modelled.resources[AOB_RESOURCE_TEXTURE], filters[i].ms, 0.0005);
        aob_profile_finish(&profile);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_good),
        cmocka_unit_test(test_digest),
        cmocka_unit_test(test_damaged),
        cmocka_unit_test(test_fill_alone),
        cmocka_unit_test(test_levels_of_the_machine),
        cmocka_unit_test(test_published),
        cmocka_unit_test(test_filters),
    };
    return cmocka_run_group_tests(tests, open_folder, remove_folder);
}
