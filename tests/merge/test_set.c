#include "check.h"
#include "lines.h"
#include "merge/merged_info.h"
#include "merge/set.h"

enum { FOLDERS = 5 };

static void open_all(struct aob_merge_source *sources)
{
    static const char *const infos[FOLDERS] = {
        "{\"devices\": {\"vulkan\": null}, \"keys\": [\"a\", \"b\", \"c\"], \"asked\": [\"c\"], \"seconds\": "
        "{}}",
        "{\"devices\": {\"vulkan\": {\"device\": \"one\"}, \"null\": null}, \"keys\": [\"a\", \"b\", \"c\"], "
        "\"asked\": [\"a\"], \"techniques\": [{\"name\": \"x\"}]}",
        "{\"devices\": {\"vulkan\": {\"device\": \"two\"}}, \"keys\": [\"a\", \"b\", \"c\"]}",
        "{\"devices\": {\"vulkan\": {\"device\": \"one\"}, \"null\": {\"device\": \"none\"}}, "
        "\"keys\": [\"a\", \"d\"], \"asked\": [], \"techniques\": [{\"name\": \"x\"}, {\"name\": \"y\"}]}",
        "{\"devices\": {\"vulkan\": {\"device\": \"two\"}, \"null\": {\"device\": \"other\"}}, \"keys\": []}",
    };
    static const char *const paths[FOLDERS] = {"/0", "/1", "/2", "/3", "/4"};
    for (size_t i = 0; i < FOLDERS; i++)
        sources[i] = make_source(paths[i], infos[i], NULL, 0);
}

static void close_all(struct aob_merge_sets *sets, struct aob_merge_source *sources)
{
    aob_merge_sets_finish(sets);
    for (size_t i = 0; i < FOLDERS; i++)
        aob_merge_source_close(&sources[i]);
}

/* What could not be opened goes with the first; then each goes where nothing conflicts. */
static void test_devices(void **state)
{
    (void)state;
    struct aob_merge_source sources[FOLDERS];
    struct aob_merge_sets sets = {0};
    open_all(sources);
    aob_merge_sets_make(&sets, sources, FOLDERS, "to/out//");
    assert_int_equal(sets.count, 2);
    assert_string_equal(sets.items[0].out, "to/out");
    assert_string_equal(sets.items[1].out, "to/out-2");
    assert_int_equal(sets.items[0].count, 3);
    assert_ptr_equal(sets.items[0].sources[0], &sources[0]);
    assert_ptr_equal(sets.items[0].sources[1], &sources[1]);
    assert_ptr_equal(sets.items[0].sources[2], &sources[3]);
    assert_int_equal(sets.items[1].count, 2);
    assert_ptr_equal(sets.items[1].sources[0], &sources[2]);
    assert_ptr_equal(sets.items[1].sources[1], &sources[4]);
    assert_true(json_equal(sets.items[0].devices, json_object_get(sources[3].info, "devices")));
    assert_true(json_equal(sets.items[1].devices, json_object_get(sources[4].info, "devices")));
    close_all(&sets, sources);
}

static void assert_list(const json_t *info, const char *name, const char *text)
{
    char *list = json_dumps(json_object_get(info, name), JSON_COMPACT);
    assert_string_equal(list, text);
    free(list);
}

/* The plan is the first folder's, and what others plan besides; `asked` is gone where one folder has none. */
static void test_info(void **state)
{
    (void)state;
    struct aob_merge_source sources[FOLDERS];
    struct aob_merge_sets sets = {0};
    open_all(sources);
    aob_merge_sets_make(&sets, sources, FOLDERS, "out");
    json_t *info = aob_merged_info_create(&sets.items[0]);
    assert_list(info, "keys", "[\"a\",\"b\",\"c\",\"d\"]");
    assert_list(info, "asked", "[\"a\",\"c\"]");
    assert_list(info, "techniques", "[{\"name\":\"x\"},{\"name\":\"y\"}]");
    assert_list(info, "merged", "[\"/0\",\"/1\",\"/3\"]");
    assert_list(info, "devices", "{\"vulkan\":{\"device\":\"one\"},\"null\":{\"device\":\"none\"}}");
    assert_int_equal(json_integer_value(json_object_get(info, "cases")), 4);
    assert_null(json_object_get(info, "seconds"));
    assert_non_null(json_object_get(sources[0].info, "seconds")); /* the source's own stays */
    json_decref(info);
    info = aob_merged_info_create(&sets.items[1]);
    assert_null(json_object_get(info, "asked"));
    json_decref(info);
    close_all(&sets, sources);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_devices), cmocka_unit_test(test_info)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
