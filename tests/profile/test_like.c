/* Profiles that are like another one, but for the formats of the screen. */
#include "profile_file.h"

/* clang-format off */
static const char device_text[] =
    "title: made\n"
    "units: " FACT("3") "\n"
    "in_flight: " FACT("4") "\n"
    "tile: " FACT("8x8") "\n"
    "warp: " FACT("8x4") "\n"
    "layout: " FACT("morton") "\n"
    "depth_bytes: " FACT("8") "\n"
    "levels:\n"
    "  - name: L1\n"
    "    size: " FACT("12 KiB") "\n"
    "    line: " FACT("128") "\n"
    "    ways: " FACT("24") "\n"
    "    index: " FACT("modulo") "\n";
/* clang-format on */

static bool read_beside(const char *name, struct aob_profile *profile, struct aob_error *error)
{
    char *file = aob_path_join(folder, name);
    bool ok = aob_profile_read(profile, file, error);
    free(file);
    return ok;
}

/* A device with other buffers has its numbers and its facts, but for those that the file has. */
static void test_like(void **state)
{
    (void)state;
    struct aob_profile device, other;
    struct aob_error error = {{0}};
    char digests[2][AOB_KEY_SIZE];
    write_file(device_text);
    write_beside("other.yaml", "title: other\nlike: made.yaml\ndepth_bytes: {value: 2, confirmed: a text}\n"
                               "normal_bytes: " FACT("4") "\n");
    if (!read_beside("made.yaml", &device, &error) || !read_beside("other.yaml", &other, &error))
        fail_msg("%s", error.text);
    assert_string_equal(other.name, "other");
    assert_string_equal(other.title, "other");
    assert_contains(other.path, "/other.yaml");
    assert_int_equal(other.depth_bytes, 2);
    assert_int_equal(other.normal_bytes, 4);
    assert_int_equal(other.units, device.units);
    assert_memory_equal(other.levels, device.levels, sizeof device.levels);
    assert_int_equal(other.fact_count, device.fact_count + 1);
    int depths = 0;
    for (size_t f = 0; f < other.fact_count; f++)
        if (strcmp(other.facts[f].key, "depth_bytes") == 0) {
            depths++;
            assert_string_equal(other.facts[f].value, "2");
            assert_true(other.facts[f].confirmed);
        }
    assert_int_equal(depths, 1);
    aob_profile_digest(&device, digests[0]);
    aob_profile_digest(&other, digests[1]);
    assert_string_not_equal(digests[0], digests[1]);
    aob_profile_finish(&device);
    aob_profile_finish(&other);
}

static void test_like_refused(void **state)
{
    (void)state;
    static const struct {
        const char *text, *place, *says;
    } rows[] = {
        {"title: a\nlike: none.yaml\n", "a.yaml:2:7: ", "none.yaml"},
        {"title: a\nlike: a.yaml\n", "a.yaml:2:7: ", "like one that has all of its numbers itself"},
        {"title: a\nlike: made.yaml\nunits: " FACT("3") "\n", "a.yaml:3:1: ", "units"},
        {"like: made.yaml\n", "a.yaml:1:1: ", "'title' is missing"},
        {"title: a\nlike: made.yaml\ndepth_bytes: " FACT("6") "\n", "a.yaml:3:22: ", "6 bytes a texel"},
    };
    write_file(device_text);
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_profile profile;
        struct aob_error error = {{0}};
        write_beside("a.yaml", rows[i].text);
        assert_false(read_beside("a.yaml", &profile, &error));
        assert_contains(error.text, rows[i].place);
        assert_contains(error.text, rows[i].says);
        assert_null(profile.name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_like), cmocka_unit_test(test_like_refused)};
    return cmocka_run_group_tests(tests, open_folder, remove_folder);
}
