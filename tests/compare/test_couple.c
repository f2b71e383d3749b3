#include "check.h"
#include <stdlib.h>
#include "base/memory.h"
#include "compare/couple.h"

enum { MOST = 8 };

struct made {
    struct aob_row rows[MOST];
    const struct aob_row *list[MOST];
    size_t count;
};

static void add(struct made *made, const char *key, const char *technique, double radius)
{
    struct aob_row *row = &made->rows[made->count];
    *row = (struct aob_row){.key = key,
                            .scene = "corner",
                            .view = "front",
                            .name = technique,
                            .backend = "null",
                            .width = 64,
                            .height = 36,
                            .label = NULL,
                            .json = json_pack("{s:{s:f}, s:{s:s}, s:{s:i}}", "params", "radius", radius,
                                              "options", "fetch", "sampled", "camera", "fov_deg", 60)};
    made->list[made->count++] = row;
}

static void finish(struct made *made)
{
    for (size_t i = 0; i < made->count; i++)
        json_decref((json_t *)(uintptr_t)made->rows[i].json);
}

static struct aob_couples find(const struct made *a, const struct made *b)
{
    struct aob_couples couples = {0};
    const struct aob_side of_a = {a->list, a->count}, of_b = {b->list, b->count};
    aob_couples_find(&couples, &of_a, &of_b);
    return couples;
}

/* By key; of another build by what it is; and what has no partner is left on its side. */
static void test_matching(void **state)
{
    (void)state;
    struct made a = {.count = 0}, b = {.count = 0};
    add(&a, "k1", "none", 1);
    add(&a, "k2", "gtao", 0.5);
    add(&a, "k3", "gtao", 1);
    add(&b, "k9", "gtao", 1);
    add(&b, "k8", "gtao", 2);
    add(&b, "k1", "none", 1);
    struct aob_couples couples = find(&a, &b);
    assert_int_equal(couples.count, 2);
    assert_ptr_equal(couples.items[0].a, &a.rows[0]);
    assert_ptr_equal(couples.items[0].b, &b.rows[2]);
    assert_true(couples.items[0].same_key);
    assert_ptr_equal(couples.items[1].a, &a.rows[2]);
    assert_ptr_equal(couples.items[1].b, &b.rows[0]);
    assert_false(couples.items[1].same_key);
    assert_int_equal(couples.alone_count[0], 1);
    assert_ptr_equal(couples.alone[0][0], &a.rows[1]);
    assert_int_equal(couples.alone_count[1], 1);
    assert_ptr_equal(couples.alone[1][0], &b.rows[1]);
    aob_couples_finish(&couples);
    finish(&a);
    finish(&b);
}

/* Two builds of one case in one run: none of them is meant more than the other. One of them is, if it has the key. */
static void test_two_builds(void **state)
{
    (void)state;
    struct made a = {.count = 0}, b = {.count = 0};
    add(&a, "old", "gtao", 1);
    add(&b, "new1", "gtao", 1);
    add(&b, "new2", "gtao", 1);
    struct aob_couples couples = find(&a, &b);
    assert_int_equal(couples.count, 0);
    assert_int_equal(couples.alone_count[0], 1);
    assert_int_equal(couples.alone_count[1], 2);
    aob_couples_finish(&couples);
    add(&b, "old", "gtao", 1);
    couples = find(&a, &b);
    assert_int_equal(couples.count, 1);
    assert_ptr_equal(couples.items[0].b, &b.rows[2]);
    assert_int_equal(couples.alone_count[1], 2);
    aob_couples_finish(&couples);
    finish(&a);
    finish(&b);
}

/* Each of these alone makes another case of it. */
static void test_what_tells_apart(void **state)
{
    (void)state;
    for (int what = 0; what < 9; what++) {
        struct made a = {.count = 0}, b = {.count = 0};
        add(&a, "a", "gtao", 1);
        add(&b, "b", what == 1 ? "hbao" : "gtao", what == 2 ? 2 : 1);
        struct aob_row *row = &b.rows[0];
        row->scene = what == 3 ? "plane" : row->scene;
        row->view = what == 4 ? "far" : row->view;
        row->backend = what == 5 ? "vulkan" : row->backend;
        row->height = what == 6 ? 37 : row->height;
        if (what == 0) /* a number is what it is, however it is written */
            json_object_set_new(json_object_get(row->json, "camera"), "fov_deg", json_real(60));
        if (what == 7)
            json_object_set_new(json_object_get(row->json, "camera"), "fov_deg", json_integer(61));
        if (what == 8)
            json_object_set_new(json_object_get(row->json, "options"), "fetch", json_string("storage"));
        struct aob_couples couples = find(&a, &b);
        assert_int_equal(couples.count, what == 0);
        aob_couples_finish(&couples);
        finish(&a);
        finish(&b);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_matching), cmocka_unit_test(test_two_builds),
                                       cmocka_unit_test(test_what_tells_apart)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
