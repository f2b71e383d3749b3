#include <jansson.h>
#include <stdbool.h>
#include <stdlib.h>
#include "base/json_keep.h"
#include "base/memory.h"
#include "check.h"
#include "random.h"

static char *keep(const char *text, const char *const *paths)
{
    size_t size = strlen(text);
    char *out = AOB_NEW_ARRAY(char, size + 1);
    out[aob_json_keep(text, size, paths, out)] = '\0';
    return out;
}

static void assert_kept(const char *text, const char *const *paths, const char *expected)
{
    char *out = keep(text, paths);
    assert_string_equal(out, expected);
    free(out);
}

static void test_places(void **state)
{
    (void)state;
    const char *const b[] = {"b", NULL}, *const deep[] = {"b.*.c", "l.x", NULL};
    assert_kept("{\"a\":1,\"b\":2}", b, "{\"b\":2}");
    assert_kept("{\"b\":{\"a\":[1]},\"a\":[1,{\"b\":\"}\\\"\"}]}", b, "{\"b\":{\"a\":[1]}}");
    assert_kept("{\"a\":1}", b, "{}");
    assert_kept("{\"b\": {\"p\": {\"d\": 1, \"c\": 2}}}", deep, "{\"b\": {\"p\": { \"c\": 2}}}");
    assert_kept("{\"l\":[{\"x\":1},{\"x\":2,\"y\":3}]}", deep, "{\"l\":[{\"x\":1},{\"x\":2}]}");
    assert_kept("{\"b\":{\"c\":1},\"lx\":1,\"l\":null}", deep, "{\"b\":{\"c\":1},\"l\":null}");
    assert_kept("{\"l.x\":1,\"b.p.c\":1,\"b\":{\"p.c\":1,\"p.q\":{\"c\":2}}}", deep,
                "{\"b\":{\"p.c\":1,\"p.q\":{\"c\":2}}}");
    assert_kept("{\"b\"\r\n:1,\r \n\t\"a\"\t\r:\n2\r}", b, "{\"b\"\r\n:1}");
}

/* A random value; objects have members of few names. */
static json_t *draw(uint32_t *random, int depth)
{
    static const char *const names[] = {"a", "b", "c\"}", "a.b", "\\"};
    size_t kind = random_below(random, depth ? 6 : 3), count = random_below(random, 4);
    if (kind == 0)
        return json_integer((json_int_t)random_below(random, 1000));
    if (kind == 1)
        return json_string(names[random_below(random, 5)]);
    if (kind == 2)
        return random_below(random, 2) ? json_null() : json_real(0.5);
    json_t *value = kind == 3 ? json_array() : json_object();
    for (size_t i = 0; i < count; i++)
        if (kind == 3)
            json_array_append_new(value, draw(random, depth - 1));
        else
            json_object_set_new(value, names[random_below(random, 5)], draw(random, depth - 1));
    return value;
}

/* What is kept of a parsed value by "a.*" and "b". `in_a`: it is the outermost object's member `a`, or in an array there. */
static void keep_members(json_t *value, int depth, bool in_a)
{
    json_t *member;
    const char *name;
    void *next;
    size_t i;
    json_array_foreach(value, i, member) keep_members(member, depth, in_a);
    json_object_foreach_safe(value, next, name, member)
    {
        bool a = depth == 0 && strcmp(name, "a") == 0;
        if (a)
            keep_members(member, 1, true);
        else if (depth == 0 && strcmp(name, "b") != 0)
            json_object_del(value, name);
    }
}

static void test_against_the_parser(void **state)
{
    (void)state;
    static const char *const paths[] = {"a.*", "b", NULL};
    uint32_t random = 3;
    for (int n = 0; n < 5000; n++) {
        json_t *value = json_object();
        const char *const outer[] = {"x", "a", "b"};
        for (size_t i = 0, first = random_below(&random, 3); i < 3; i++)
            json_object_set_new(value, outer[(first + i) % 3], draw(&random, 4));
        char *text = json_dumps(value, random_below(&random, 2) ? JSON_COMPACT : 0), *out = keep(text, paths);
        json_t *left = json_loads(out, 0, NULL);
        size_t size = aob_json_keep(text, strlen(text), paths, text); /* in its own place */
        assert_int_equal(size, strlen(out));
        assert_memory_equal(text, out, size);
        keep_members(value, 0, false);
        if (!json_equal(left, value))
            fail_msg("%s became %s", text, out);
        json_decref(left);
        json_decref(value);
        free(text);
        free(out);
    }
}

/* Whatever the bytes are, nothing outside of them is read or written. Under the sanitizers this is a test. */
static void test_no_json(void **state)
{
    (void)state;
    static const char *const paths[] = {"a", "b.a", NULL};
    static const char letters[] = "{}[]\",:ab\\ 1";
    uint32_t random = 5;
    for (int n = 0; n < 20000; n++) {
        size_t size = random_below(&random, 24);
        char *text = AOB_NEW_ARRAY(char, size + 1), *out = AOB_NEW_ARRAY(char, size + 1);
        for (size_t i = 0; i < size; i++)
            text[i] = letters[random_below(&random, sizeof letters - 1)];
        char *exact = size ? memcpy(malloc(size), text, size) : NULL;
        assert_true(aob_json_keep(size ? exact : text, size, paths, out) <= size);
        free(exact);
        free(text);
        free(out);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_places),
                                       cmocka_unit_test(test_against_the_parser),
                                       cmocka_unit_test(test_no_json)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
