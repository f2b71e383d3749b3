#include "check.h"
#include "lines.h"
#include "merge/union.h"

#define OK(key, digest, rest)                                                                                \
    "{\"key\":\"" key "\",\"status\":\"ok\",\"image_digest\":\"" digest "\"" rest "}"
#define BAD(key, status) "{\"key\":\"" key "\",\"status\":\"" status "\"}"
enum { SOURCES = 3, LINES = 5 };

/* Of the first: a and b are good, c is invalid, d failed, e has a time. */
static const char *const lines[SOURCES][LINES] = {
    {OK("b", "1", ""), OK("a", "1", ""), BAD("c", "invalid"), BAD("d", "failed"),
     OK("e", "1", ",\"time\":{\"cpu_ms\":1}")},
    {OK("a", "2", ",\"scene\":\"s\""), OK("b", "1", ",\"sequence\":{\"flicker\":1}"), BAD("c", "failed"),
     BAD("d", "invalid"), OK("e", "1", ",\"time\":{\"cpu_ms\":2}")},
    {OK("x", "1", ""), OK("c", "1", ""), OK("d", "1", ""), BAD("a", "failed"),
     OK("e", "1", ",\"errors\":[{\"rmse\":1}]")},
};

static const struct aob_merge_case *find(const struct aob_merge_union *all, const char *key)
{
    for (size_t i = 0; i < all->count; i++)
        if (strcmp(all->cases[i].key, key) == 0)
            return &all->cases[i];
    fail_msg("no case %s", key);
    return NULL;
}

static void assert_conflict(const struct aob_merge_union *all, size_t at, const char *key, const char *other,
                            const char *differs)
{
    const char *text[5];
    assert_int_equal(json_unpack(json_array_get(all->conflicts, at), "{s:s, s:[s, s], s:s, s:s}", "key",
                                 &text[0], "folders", &text[1], &text[2], "differs", &text[3], "kept",
                                 &text[4]),
                     0);
    assert_string_equal(text[4], "out/conflicts.jsonl");
    assert_string_equal(text[0], key);
    assert_string_equal(text[1], "0");
    assert_string_equal(text[2], other);
    assert_string_equal(text[3], differs);
}

static void test_union(void **state)
{
    (void)state;
    static const char *const names[SOURCES] = {"0", "1", "2"};
    struct aob_merge_source sources[SOURCES];
    const struct aob_merge_source *pointers[SOURCES];
    for (size_t i = 0; i < SOURCES; i++) {
        sources[i] = make_source(names[i], "{}", lines[i], LINES);
        pointers[i] = &sources[i];
    }
    const struct aob_merge_set set = {.out = "out", .sources = pointers, .count = SOURCES};
    json_t *keys = json_pack("[s, s, s, s, s, s]", "a", "b", "c", "d", "e", "none");
    struct aob_merge_union all;
    aob_merge_union_make(&all, &set, keys);
    assert_int_equal(all.count, 7);
    for (size_t i = 0; i < 6; i++)
        assert_string_equal(all.cases[i].key, json_string_value(json_array_get(keys, i)));
    assert_string_equal(all.cases[6].key, "x"); /* what no plan has comes last */
    assert_ptr_equal(find(&all, "a")->line, &sources[0].lines.items[1]);
    assert_ptr_equal(find(&all, "b")->line, &sources[0].lines.items[0]);
    assert_ptr_equal(find(&all, "c")->line, &sources[2].lines.items[1]); /* ok before invalid */
    assert_ptr_equal(find(&all, "d")->line, &sources[2].lines.items[2]);
    assert_ptr_equal(find(&all, "e")->line, &sources[0].lines.items[4]);
    assert_ptr_equal(find(&all, "x")->source, &sources[2]);
    assert_null(find(&all, "none")->source);
    assert_int_equal(all.missing, 1);
    assert_int_equal(all.dropped, 1); /* e: another time is no other result */
    assert_int_equal(json_array_size(all.conflicts), 3);
    assert_conflict(&all, 0, "a", "1", "image_digest");
    assert_conflict(&all, 1, "b", "1", "sequence");
    assert_conflict(&all, 2, "e", "2", "errors");
    aob_merge_union_finish(&all);
    json_decref(keys);
    for (size_t i = 0; i < SOURCES; i++)
        aob_merge_source_close(&sources[i]);
}

/* A record is compared with the one that stands in the end, not with one that gave way. */
static void test_gave_way(void **state)
{
    (void)state;
    static const char *const own[SOURCES][1] = {
        {"{\"key\":\"a\",\"status\":\"failed\",\"error\":1}"},
        {"{\"key\":\"a\",\"status\":\"failed\",\"error\":2}"},
        {OK("a", "1", "")},
    };
    struct aob_merge_source sources[SOURCES];
    const struct aob_merge_source *pointers[SOURCES];
    for (size_t i = 0; i < SOURCES; i++) {
        sources[i] = make_source("folder", "{}", own[i], 1);
        pointers[i] = &sources[i];
    }
    const struct aob_merge_set set = {.out = "out", .sources = pointers, .count = SOURCES};
    struct aob_merge_union all;
    aob_merge_union_make(&all, &set, NULL);
    assert_ptr_equal(find(&all, "a")->source, &sources[2]);
    assert_int_equal(json_array_size(all.conflicts), 0);
    assert_int_equal(all.other_count, 0);
    assert_int_equal(all.dropped, 0);
    aob_merge_union_finish(&all);
    for (size_t i = 0; i < SOURCES; i++)
        aob_merge_source_close(&sources[i]);
}

static void test_description(void **state)
{
    (void)state;
    static const char text[] =
        "{\"scene\":\"corner\",\"view\":\"front\",\"technique\":\"gtao\",\"params\":{\"radius\":0.5,"
        "\"slices\":2},\"backend\":\"vulkan\",\"width\":64,\"height\":36,\"status\":\"ok\"}";
    char *shown = aob_merge_case_describe(&(struct aob_piece){text, sizeof text - 1});
    assert_string_equal(shown, "corner/front gtao radius=0.5 slices=2, vulkan 64x36");
    free(shown);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_union), cmocka_unit_test(test_gave_way),
                                       cmocka_unit_test(test_description)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
