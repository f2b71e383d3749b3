#include <stdlib.h>
#include "check.h"
#include "merge/named.h"

static void test_names(void **state)
{
    (void)state;
    static const char text[] =
        "{\"key\":\"k\",\"graph\":\"ab\",\"image\":\"images/k.exr\",\"errors\":["
        "{\"truth\":\"truths/1.exr\"},{\"rmse\":1},{\"truth\":\"truths/2.exr\"}],"
        "\"error\":{\"truth\":\"truths/2.exr\"},\"other\":{\"truth\":\"truths/3.exr\"},"
        "\"time\":{\"slots\":[],\"rounds_file\":\"rounds/r.jsonl.zst\"}}";
    static const char bare[] = "{\"key\":\"k\",\"status\":\"failed\",\"image\":null}";
    json_t *names = aob_merge_named(&(struct aob_piece){text, sizeof text - 1}),
           *expected = json_pack("[s, s, s, s, s]", "images/k.exr", "truths/1.exr", "truths/2.exr",
                                 "rounds/r.jsonl.zst", "graphs/ab.dot");
    assert_true(json_equal(names, expected));
    json_decref(names);
    json_decref(expected);
    names = aob_merge_named(&(struct aob_piece){bare, sizeof bare - 1});
    assert_int_equal(json_array_size(names), 0);
    json_decref(names);
}

static void test_safe(void **state)
{
    (void)state;
    static const char *const good[] = {"images/a.exr", "truths/a", "rounds/a.jsonl.zst", "graphs/a.dot"},
                             *const bad[] = {"",          "images",        "images/",        "images/..",
                                             "/images/a", "../images/a",   "images/../../a", "images/b/a",
                                             "report/a",  "journal.jsonl", "images/.hidden", "imagesx/a"};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        assert_true(aob_merge_named_is_safe(good[i]));
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        if (aob_merge_named_is_safe(bad[i]))
            fail_msg("'%s' passes for a file of a run", bad[i]);
    assert_true(aob_merge_named_is_graph(good[3]));
    assert_false(aob_merge_named_is_graph(good[0]));
}

/* Wherever it stands as a whole text, and nowhere else. */
static void test_change(void **state)
{
    (void)state;
    char line[] =
        "{\"a\":\"truths/1.exr\",\"b\":[\"truths/1.exr\"],\"c\":\"xtruths/1.exr\",\"d\":\"truths/1.exrx\"}";
    aob_merge_named_change(&(struct aob_piece){line, sizeof line - 1}, "truths/1.exr", "truths/2.exr");
    assert_string_equal(line, "{\"a\":\"truths/2.exr\",\"b\":[\"truths/2.exr\"],\"c\":\"xtruths/1.exr\","
                              "\"d\":\"truths/1.exrx\"}");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_names), cmocka_unit_test(test_safe),
                                       cmocka_unit_test(test_change)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
