/* Damaged mesh files, through the worker that loads them. */
#include "scene/damaged_mesh.h"

enum { FILES = 500 };

static void test_damaged_meshes(void **state)
{
    struct damaged_counts counts = {0};
    (void)state;
    damaged_meshes(FILES, &counts);
    damaged_print("meshes", &counts);
    assert_int_equal(counts.faults, 0);
    assert_int_equal(counts.loaded + counts.refused, FILES);
    assert_true(counts.agreed > FILES / 20); /* the second reader is heard */
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_damaged_meshes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
