/* Profile files: what is read, what is refused and where, and those that come with the program. */
#include <glob.h>
#include "base/text.h"
#include "profile/profile_machine.h"
#include "profile_file.h"
#include "streams.h"

/* clang-format off */
static const char good[] =
    "title: made\n"
    "units: " FACT("3") "\n"
    "in_flight: " FACT("4") "\n"
    "tile: " FACT("8x8") "\n"
    "warp: {value: 8x4, confirmed: 'a text'}\n"
    "layout: " FACT("block_linear") "\n"
    "depth_bytes: " FACT("8") "\n"
    "levels:\n"
    "  - name: L1\n"
    "    size: " FACT("12 KiB") "\n"
    "    line: " FACT("128") "\n"
    "    sector: " FACT("32") "\n"
    "    ways: " FACT("24") "\n"
    "    index: " FACT("xor") "\n"
    "  - name: L2\n"
    "    size: " FACT("786432") "\n"
    "    line: " FACT("128") "\n"
    "    ways: " FACT("8") "\n"
    "    index: " FACT("modulo") "\n"
    "    units: " FACT("2") "\n"
    "    cold: " FACT("pass") "\n";
/* clang-format on */

static void test_good(void **state)
{
    (void)state;
    struct aob_profile profile;
    struct aob_error error = {{0}};
    write_file(good);
    if (!aob_profile_find(&profile, path, &error))
        fail_msg("%s", error.text);
    assert_string_equal(profile.name, "made");
    assert_int_equal(profile.units, 3);
    assert_int_equal(profile.in_flight, 4);
    assert_int_equal(profile.block.width, 8);
    assert_int_equal(profile.warp.height, 4);
    assert_int_equal(profile.layout, AOB_LAYOUT_BLOCK_LINEAR);
    assert_int_equal(profile.block_height, 16);
    assert_int_equal(profile.depth_bytes, 8);
    assert_int_equal(profile.normal_bytes, 0);
    assert_int_equal(profile.level_count, 2);
    const struct aob_profile_level *first = &profile.levels[0], *second = &profile.levels[1];
    assert_int_equal(first->size, 12288);
    assert_int_equal(first->sector, 32);
    assert_int_equal(first->sets, 4);
    assert_int_equal(first->index, AOB_INDEX_XOR);
    assert_int_equal(first->units, 1);
    assert_true(first->cold_at_pass);
    assert_int_equal(second->sector, 128);
    assert_int_equal(second->sets, 768);
    assert_int_equal(second->units, 2);
    assert_true(second->cold_at_pass);
    assert_string_equal(profile.facts[3].key, "warp");
    assert_string_equal(profile.facts[3].value, "8x4");
    assert_string_equal(profile.facts[3].source, "a text");
    assert_true(profile.facts[3].confirmed);
    assert_string_equal(profile.facts[6].key, "levels.L1.size");
    assert_false(profile.facts[6].confirmed);
    aob_profile_finish(&profile);
}

struct damage {
    const char *from, *to;    /* in the good file */
    const char *place, *says; /* of the message */
};
static const struct damage damages[] = {
    {"title: made\n", "title: made\nshape: 3\n", ":2:1: ", "unknown key 'shape'"},
    {"title: made\n", "title: made\ntitle: made\n", ":2:1: ", "stands here twice"},
    {"title: made\n", "", ":1:1: ", "'title' is missing"},
    {"units: " FACT("3") "\n", "", ":1:1: ", "'units' is missing"},
    {"units: " FACT("3"), "units: 3", ":2:8: ", "a number has a source here"},
    {"units: " FACT("3"), "units: {value: 3}", ":2:8: ", "'confirmed' and 'unverified'"},
    {"units: " FACT("3"), "units: {value: 3, confirmed: a, unverified: b}",
     ":2:8: ", "'confirmed' and 'unverified'"},
    {"units: " FACT("3"), "units: {confirmed: a}", ":2:8: ", "'value' is missing"},
    {"units: " FACT("3"), "units: " FACT("0"), ":2:16: ", "0 is outside 1 .. 256"},
    {"units: " FACT("3"), "units: " FACT("-3"), ":2:16: ", "-3 is outside 1 .. 256"},
    {"units: " FACT("3"), "units: " FACT("2.5"), ":2:16: ", "no whole number"},
    {"units: " FACT("3"), "units: " FACT("many"), ":2:16: ", "'many' is not a number"},
    {"in_flight: " FACT("4"), "in_flight: " FACT("1e9"), ":3:20: ", "outside 1 .. 128"},
    {"tile: " FACT("8x8"), "tile: " FACT("12x8"), ":4:15: ", "a power of two"},
    {"tile: " FACT("8x8"), "tile: " FACT("8x128"), ":4:15: ", "a power of two within 2 .. 64"},
    {"tile: " FACT("8x8"), "tile: " FACT("8"), ":4:15: ", "no size in pixels"},
    {"tile: " FACT("8x8"), "tile: " FACT("4x4"), ":5:15: ", "a warp is no larger than a tile"},
    {FACT("block_linear"), FACT("hilbert"), ":6:17: ", "linear, morton, block_linear"},
    {"depth_bytes: " FACT("8"), "depth_bytes: " FACT("6"), ":7:22: ", "6 bytes a texel"},
    {"depth_bytes: " FACT("8"), "block_height: " FACT("3"), ":7:23: ", "3 GOBs is no power of two"},
    {"depth_bytes: " FACT("8"), "block: " FACT("8x16"), ":7:16: ", "a block is no larger than a tile"},
    {"  - name: L1\n", "  - nam: L1\n", ":9:5: ", "'name'"},
    {"name: L1\n", "name: the first of all levels\n", ":9:11: ", "more than 15 letters"},
    {FACT("12 KiB"), FACT("0"), ":10:19: ", "is not a whole number of bytes within 64 B"},
    {FACT("12 KiB"), FACT("12 KB"), ":10:19: ", "'12 KB' is no size"},
    {FACT("12 KiB"), FACT("-12 KiB"), ":10:19: ", "is not a whole number of bytes"},
    {FACT("12 KiB"), FACT("1000 TiB"), ":10:19: ", "larger than this machine's memory"},
    {FACT("12 KiB"), FACT("12345"), ":10:19: ", "no whole number of lines"},
    {"    line: " FACT("128") "\n    sector", "    line: " FACT("96") "\n    sector",
     ":11:19: ", "96 bytes is no power of two"},
    {"    line: " FACT("128") "\n    sector", "    line: " FACT("8192") "\n    sector",
     ":11:19: ", "outside 16 .. 4096"},
    {"sector: " FACT("32"), "sector: " FACT("48"), ":12:21: ", "48 bytes is no power of two"},
    {"sector: " FACT("32"), "sector: " FACT("256"), ":12:21: ", "between the line and a 32nd"},
    {FACT("24"), FACT("0"), ":13:19: ", "0 is outside 1"},
    {FACT("24"), FACT("25"), ":13:19: ", "25 ways do not divide the cache's 96 lines"},
    {FACT("24"), FACT("2147483648"), ":13:19: ", "do not divide"},
    {FACT("24"), FACT("32"), ":14:20: ", "xor needs a power of two of sets, and these are 3"},
    {FACT("xor"), FACT("random"), ":14:20: ", "neither modulo nor xor"},
    {FACT("xor") "\n", FACT("xor") "\n    units: " FACT("2") "\n", ":15:5: ", "unknown key 'units'"},
    {"    line: " FACT("128") "\n    ways", "    line: " FACT("16") "\n    ways",
     ":17:19: ", "it brings 16 bytes at a time"},
    {"cold: " FACT("pass"), "cold: " FACT("always"), ":21:19: ", "neither pass nor frame"},
    {"levels:\n", "levels: " FACT("somewhere") "\nother:\n", ":8:17: ", "'somewhere' is not machine"},
    {"levels:\n", "levels: {value: machine}\nother:\n", ":8:9: ", "write one source beside machine"},
    {"levels:\n", "levels: {value: machine, unverified: a, nonsense: 3}\nother:\n", ":8:41: ", "'nonsense'"},
    {"name: L2", "name: L1", ":15:11: ", "there is a level 'L1' already"},
};

static void test_damaged(void **state)
{
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(damages); i++) {
        struct aob_profile profile;
        struct aob_error error = {{0}};
        struct aob_text text = {0};
        const char *at = strstr(good, damages[i].from);
        assert_non_null(at);
        aob_text_add(&text, "%.*s%s%s", (int)(at - good), good, damages[i].to, at + strlen(damages[i].from));
        write_file(text.data);
        if (aob_profile_read(&profile, path, &error))
            fail_msg("row %zu was read", i);
        assert_contains(error.text, path);
        assert_contains(error.text, damages[i].place);
        assert_contains(error.text, damages[i].says);
        aob_text_finish(&text);
    }
}

/* Files as the kernel's. */
static void write_machine(void)
{
    static const char *const caches[][6] = {
        {"1", "Data", "48K", "12", "64", "0,64"},
        {"1", "Instruction", "32K", "8", "64", "0,64"},
        {"2", "Unified", "2M", "16", "64", "0,64"},
        {"3", "Unified", "36864K", "12", "64", "0-7,64-71"},
    };
    static const char *const names[] = {
        "level", "type", "size", "ways_of_associativity", "coherency_line_size", "shared_cpu_list"};
    struct aob_error error = {{0}};
    char file[128];
    for (size_t c = 0; c < AOB_COUNT(caches); c++)
        for (size_t n = 0; n < AOB_COUNT(names); n++) {
            snprintf(file, sizeof file, "%s/index%zu", folder, c);
            assert_true(aob_folder_create(file, &error));
            snprintf(file, sizeof file, "%s/index%zu/%s", folder, c, names[n]);
            assert_true(aob_file_write(file, caches[c][n], strlen(caches[c][n]), &error));
        }
}

static void test_machine(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    struct aob_profile profile = {.units = 8};
    char file[128];
    write_machine();
    assert_true(aob_profile_machine(&profile, folder, &error));
    assert_int_equal(profile.level_count, 3);
    static const struct aob_profile_level expected[3] = {
        {.size = 49152, .sets = 64, .ways = 12, .units = 1, .cold_at_pass = true},
        {.size = 2097152, .sets = 2048, .ways = 16, .units = 1},
        {.size = 37748736, .sets = 49152, .ways = 12, .units = 8}};
    for (int l = 0; l < 3; l++) {
        assert_int_equal(profile.levels[l].size, expected[l].size);
        assert_int_equal(profile.levels[l].sets, expected[l].sets);
        assert_int_equal(profile.levels[l].ways, expected[l].ways);
        assert_int_equal(profile.levels[l].units, expected[l].units);
        assert_int_equal(profile.levels[l].cold_at_pass, expected[l].cold_at_pass);
    }
    assert_string_equal(profile.levels[2].name, "L3");
    aob_profile_finish(&profile);
    snprintf(file, sizeof file, "%s/index2/ways_of_associativity", folder);
    assert_true(aob_file_write(file, "0", 1, &error)); /* as some hypervisors say */
    assert_false(aob_profile_machine(&profile, folder, &error));
    assert_contains(error.text, "index2 does not tell");
    aob_profile_finish(&profile);
    assert_false(aob_profile_machine(&profile, "/nowhere", &error));
    assert_contains(error.text, "names no data cache");
}

/* What the kernel tells is held to the rules of a file. */
static void test_machine_rules(void **state)
{
    (void)state;
    static const struct {
        const char *file, *value, *says;
    } rows[] = {
        {"index2/coherency_line_size", "32", "index2: it brings 32 bytes at a time, less than the 64"},
        {"index2/coherency_line_size", "96", "index2: a line of 96 bytes is no power of two"},
        {"index0/ways_of_associativity", "13", "index0: 13 ways do not divide"},
        {"index3/size", "1000001", "index3: 1000001 bytes are no whole number of lines"},
    };
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_error error = {{0}};
        struct aob_profile profile = {.units = 8};
        char file[128];
        write_machine();
        snprintf(file, sizeof file, "%s/%s", folder, rows[i].file);
        assert_true(aob_file_write(file, rows[i].value, strlen(rows[i].value), &error));
        assert_false(aob_profile_machine(&profile, folder, &error));
        assert_contains(error.text, rows[i].says);
        assert_contains(error.text, ": write a profile with levels of your own");
        aob_profile_finish(&profile);
    }
}

static const char *value_of(const struct aob_profile *profile, const char *key)
{
    for (size_t i = 0; i < profile->fact_count; i++)
        if (strcmp(profile->facts[i].key, key) == 0) {
            bool is_default = strncmp(profile->facts[i].source, "default: ", 9) == 0;
            assert_int_equal(profile->facts[i].confirmed, 0);
            return is_default ? profile->facts[i].value : "written";
        }
    return "none";
}

/* What is left out is a fact as well, without a source. What is written stays as it is. */
static void test_defaults(void **state)
{
    (void)state;
    struct aob_profile profile;
    struct aob_error error = {{0}};
    write_file(good);
    assert_true(aob_profile_read(&profile, path, &error));
    assert_string_equal(value_of(&profile, "block"), "8x8");
    assert_string_equal(value_of(&profile, "block_height"), "16");
    assert_string_equal(value_of(&profile, "levels.L1.sector"), "written");
    assert_string_equal(value_of(&profile, "levels.L2.sector"), "128");
    assert_string_equal(value_of(&profile, "levels.L2.units"), "written");
    assert_string_equal(value_of(&profile, "levels.L2.cold"), "written");
    assert_string_equal(value_of(&profile, "levels.L1.units"), "none"); /* a unit has one: no choice */
    aob_profile_finish(&profile);
    struct aob_text text = {0};
    aob_text_add(&text, "%.*s", (int)(strstr(good, "    units: ") - good), good);
    write_file(text.data);
    assert_true(aob_profile_read(&profile, path, &error));
    assert_string_equal(value_of(&profile, "levels.L2.units"), "all");
    assert_string_equal(value_of(&profile, "levels.L2.cold"), "frame");
    aob_profile_finish(&profile);
    aob_text_finish(&text);
    write_machine();
    assert_true(aob_profile_machine(&profile, folder, &error));
    assert_string_equal(value_of(&profile, "levels.L1.index"), "modulo");
    assert_string_equal(value_of(&profile, "levels.L1.cold"), "none");
    assert_string_equal(value_of(&profile, "levels.L3.cold"), "frame");
    aob_profile_finish(&profile);
}

/* Two processors share a first cache, so 16 of them are 8 units, all of which share the last level. */
static void test_machine_units(void **state)
{
    (void)state;
    write_machine();
    assert_int_equal(aob_profile_machine_units(folder, 16), 8);
    assert_int_equal(aob_profile_machine_units(folder, 1), 1);
    assert_int_equal(aob_profile_machine_units("/nowhere", 3), 3);
}

static void test_machine_large(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    struct aob_profile profile = {.units = 8};
    char file[128];
    write_machine();
    static const char *const large[][2] = {{"size", "67108864K"},
                                           {"coherency_line_size", "16"},
                                           {"ways_of_associativity", "1"}}; /* 2^32 lines */
    for (size_t i = 0; i < AOB_COUNT(large); i++) {
        snprintf(file, sizeof file, "%s/index3/%s", folder, large[i][0]);
        assert_true(aob_file_write(file, large[i][1], strlen(large[i][1]), &error));
    }
    assert_false(aob_profile_machine(&profile, folder, &error));
    assert_contains(error.text,
                    "index3: a cache of "); /* too many lines, or more than this machine's memory */
    aob_profile_finish(&profile);
}

static void judge_tree(const char *file)
{
    struct aob_profile profile;
    struct aob_error error = {{0}};
    if (!aob_profile_read(&profile, file, &error))
        fail_msg("%s", error.text);
    size_t facts = 5 + 4 * (size_t)profile.level_count; /* those that every profile has */
    assert_true(profile.fact_count >= facts);
    for (size_t f = 0; f < profile.fact_count; f++)
        assert_true(*profile.facts[f].source && *profile.facts[f].value);
    aob_profile_finish(&profile);
}

/* Every file of configs/profiles is read, and each of its numbers has a source. Where the kernel does not tell the caches,
 * `llvmpipe` says so. */
static void test_tree(void **state)
{
    (void)state;
    glob_t files;
    struct aob_profile machine = {.units = 1};
    struct aob_text pattern = {0};
    const char *build = getenv("AOBUDGET_BUILD");
    assert_non_null(build);
    bool tells = aob_profile_machine(&machine, AOB_PROFILE_SYSFS, NULL);
    aob_profile_finish(&machine);
    aob_text_add(&pattern, "%s/../../configs/profiles/*.yaml", build);
    assert_int_equal(glob(pattern.data, 0, NULL, &files), 0);
    assert_true(files.gl_pathc >= 10);
    for (size_t i = 0; i < files.gl_pathc; i++)
        if (tells || !strstr(files.gl_pathv[i], "/llvmpipe.yaml"))
            judge_tree(files.gl_pathv[i]);
    globfree(&files);
    aob_text_finish(&pattern);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_good),          cmocka_unit_test(test_damaged),
        cmocka_unit_test(test_machine),       cmocka_unit_test(test_machine_units),
        cmocka_unit_test(test_machine_rules), cmocka_unit_test(test_machine_large),
        cmocka_unit_test(test_defaults),      cmocka_unit_test(test_tree),
    };
    return cmocka_run_group_tests(tests, open_folder, remove_folder);
}
