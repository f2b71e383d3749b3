#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "base/file.h"
#include "base/memory.h"
#include "technique/registry.h"

static char *module_path(const char *name)
{
    const char *build = getenv("AOBUDGET_BUILD");
    char file[256];
    snprintf(file, sizeof file, "%s/%s", build ? build : ".", name);
    return strdup(file);
}

static void test_builtins_are_sound(void **state)
{
    (void)state;
    struct aob_registry registry;
    struct aob_error error;
    aob_registry_init(&registry);
    assert_true(registry.count >= 3);
    for (size_t i = 0; i < registry.count; i++)
        if (!aob_technique_judge(registry.entries[i].technique, &error))
            fail_msg("%s", error.text);
    assert_non_null(aob_registry_find(&registry, NULL, "gtao"));
    assert_null(aob_registry_find(&registry, NULL, "fixed_pass"));
    aob_registry_finish(&registry);
}

/* Built in and from a module, each by its address; the module once, however often it is loaded. */
static void test_builds_stand_side_by_side(void **state)
{
    (void)state;
    struct aob_registry registry;
    struct aob_error error;
    char *path = module_path("modules/gtao.so");
    aob_registry_init(&registry);
    size_t count = registry.count;
    for (int twice = 0; twice < 2; twice++)
        if (!aob_registry_load(&registry, path, &error))
            fail_msg("%s", error.text);
    assert_int_equal(registry.count, count + 1);
    const struct aob_registry_entry *builtin = aob_registry_find(&registry, NULL, "gtao"),
                                    *loaded = aob_registry_find(&registry, path, "gtao");
    assert_null(builtin->module);
    assert_string_equal(loaded->module, path);
    assert_ptr_not_equal(loaded->technique, builtin->technique);
    assert_string_not_equal(loaded->digest, builtin->digest);
    assert_null(aob_registry_find(&registry, path, "hbao"));
    assert_null(aob_registry_find(&registry, "other.so", "gtao"));
    aob_registry_finish(&registry);
    free(path);
}

/* An address is of one build: the file must still hold it. */
static void test_addresses(void **state)
{
    (void)state;
    struct aob_registry registry;
    struct aob_error error = {{0}};
    char *path = module_path("modules/gtao.so"), digest[AOB_KEY_SIZE], other[AOB_KEY_SIZE];
    assert_true(aob_hash_file(path, digest, &error));
    strcpy(other, digest);
    other[0] ^= 1;
    aob_registry_init(&registry);
    const struct aob_technique *gtao =
        aob_registry_open(&registry, &(struct aob_address){"gtao", path, digest}, &error);
    assert_non_null(gtao);
    assert_ptr_equal(gtao, aob_registry_find(&registry, path, "gtao")->technique);
    assert_null(aob_registry_open(&registry, &(struct aob_address){"gtao", path, other}, &error));
    assert_contains(error.text,
                    "gtao.so: the file is another one than when its technique 'gtao' was planned");
    assert_null(aob_registry_open(&registry, &(struct aob_address){"hbao", path, digest}, &error));
    assert_null(aob_registry_open(&registry, &(struct aob_address){"gtao", NULL, digest}, &error));
    assert_contains(error.text, "the program: the file is another one");
    assert_null(aob_registry_open(&registry, &(struct aob_address){"gtao", "nowhere.so", digest}, &error));
    assert_contains(error.text, "nowhere.so: cannot open");
    aob_registry_finish(&registry);
    free(path);
}

struct known {
    const char *name, *module, *digest;
    bool offered;
};
static const struct known knowns[] = {
    {"a", NULL, "1", true},     {"b", NULL, "2", true},      {"a", "one.so", "3", true},
    {"c", "one.so", "3", true}, {"c", "same.so", "3", true}, {"d", "one.so", "3", true},
    {"d", "two.so", "4", true}, {"b", "far.so", "5", false}, {"e", "far.so", "5", false},
};

/* Who names no module means the offered one, else what is built in; who names one means that one. */
static void test_names(void **state)
{
    (void)state;
    struct aob_technique_info items[AOB_COUNT(knowns)];
    const struct aob_technique_list list = {items, AOB_COUNT(knowns)};
    struct aob_error error;
    for (size_t i = 0; i < AOB_COUNT(knowns); i++) {
        items[i] = (struct aob_technique_info){.name = (char *)(uintptr_t)knowns[i].name,
                                               .module = (char *)(uintptr_t)knowns[i].module,
                                               .offered = knowns[i].offered};
        strcpy(items[i].digest, knowns[i].digest);
    }
    assert_ptr_equal(aob_technique_list_find(&list, NULL, "a", &error), &items[2]);
    assert_ptr_equal(aob_technique_list_find(&list, NULL, "b", &error), &items[1]);
    assert_ptr_equal(aob_technique_list_find(&list, NULL, "c", &error), &items[3]);
    assert_ptr_equal(aob_technique_list_find(&list, "same.so", "c", &error), &items[4]);
    assert_ptr_equal(aob_technique_list_find(&list, "two.so", "d", &error), &items[6]);
    assert_ptr_equal(aob_technique_list_find(&list, "far.so", "b", &error), &items[7]);
    assert_null(aob_technique_list_find(&list, NULL, "d", &error));
    assert_contains(error.text, "technique 'd' is in one.so and in two.so: ");
    assert_null(aob_technique_list_find(&list, NULL, "e", &error));
    assert_contains(error.text, "unknown technique 'e' without a module; write module: far.so");
    assert_null(aob_technique_list_find(&list, NULL, "f", &error));
    assert_contains(error.text, "unknown technique 'f'; see: aobudget list techniques");
    assert_null(aob_technique_list_find(&list, "far.so", "a", &error));
    assert_contains(error.text, "far.so has no technique 'a'; it has b, e");
}

static void refused(const char *path, const char *says)
{
    struct aob_registry registry;
    struct aob_error error = {{0}};
    aob_registry_init(&registry);
    assert_false(aob_registry_load(&registry, path, &error));
    assert_contains(error.text, says);
    aob_registry_finish(&registry);
}

struct values {
    int32_t a, b;
    float c;
};
static const char *const names[] = {"x", "y", NULL}, *const no_names[] = {NULL},
                         *const no_text[] = {"x", "caf\xe9", NULL};
static const struct aob_param good[] = {
    AOB_PARAM(struct values, a, .min = 0, .max = 9, .initial = 2, .doc = "A whole number."),
    AOB_PARAM(struct values, b, .choices = names, .initial = 1, .doc = "A choice."),
    AOB_PARAM(struct values, c, .min = -1, .max = 1, .doc = "A float."),
};

static bool build_nothing(struct aob_graph *graph, const void *values)
{
    (void)graph;
    (void)values;
    return false;
}

/* The good table with one row changed must be refused, by a line that says why. */
static void refuse_row(int row, const struct aob_param *changed, const char *says)
{
    static const struct aob_shader shaders[] = {{NULL, NULL}};
    struct aob_param params[3] = {good[0], good[1], good[2]};
    struct aob_technique technique = {.abi = AOB_ABI,
                                      .size = sizeof technique,
                                      .name = "t",
                                      .title = "t",
                                      .citation = "t",
                                      .params = params,
                                      .param_count = 3,
                                      .values_size = sizeof(struct values),
                                      .shaders = shaders,
                                      .build = build_nothing};
    struct aob_error error = {{0}};
    if (!aob_technique_judge(&technique, &error))
        fail_msg("the good one: %s", error.text);
    params[row] = *changed;
    assert_false(aob_technique_judge(&technique, &error));
    assert_contains(error.text, says);
}

static void test_rows_that_would_mislead_are_refused(void **state)
{
    (void)state;
    struct aob_param p;
#define REFUSE(row, field, value, says)                                                                      \
    do {                                                                                                     \
        p = good[row];                                                                                       \
        p.field = value;                                                                                     \
        refuse_row(row, &p, says);                                                                           \
    } while (0)
    REFUSE(1, initial, 2, "2 names, and 2 is none");
    REFUSE(1, initial, -1, "none of them");
    REFUSE(1, initial, 0.5, "none of them");
    REFUSE(1, choices, no_names, "0 names");
    REFUSE(1, choices, no_text, "a choice of 'b' is not UTF-8");
    REFUSE(1, min, (double)NAN, "choice 'b': min and max must be finite");
    REFUSE(1, max, (double)INFINITY, "choice 'b': min and max must be finite");
    REFUSE(1, name, "a", "'a' and 'a' have one name or one field");
    REFUSE(1, offset, 0, "'a' and 'b' have one name or one field");
    REFUSE(0, name, "guard_band", "called like a run option");
    REFUSE(0, name, "aob_size", "begins with aob_");
    REFUSE(0, offset, (size_t)-4, "offset");
    REFUSE(2, offset, sizeof(struct values), "offset");
    REFUSE(0, max, 1e12, "finite values of its type");
    REFUSE(0, initial, 1.5, "finite values of its type");
    REFUSE(2, max, (double)INFINITY, "finite values of its type");
    REFUSE(2, max, 1e300, "finite values of its type");
    REFUSE(2, initial, (double)NAN, "finite values of its type");
    REFUSE(2, initial, 2, "outside its bounds");
    REFUSE(2, doc, "caf\xe9", "UTF-8");
#undef REFUSE
}

static void test_foreign_files_are_refused(void **state)
{
    (void)state;
    char *old = module_path("tests/modules/old_abi.so"), *twice = module_path("tests/modules/twice.so");
    refused(twice, "twice.so: two of its techniques are named 'twice'");
    refused(old, "made for module interface 3, this program has 11: build it again");
    refused("/nonexistent/x.so", "cannot open");
    refused("/tmp", "is it a file?");
    refused("/etc/passwd", "cannot load");
    free(old);
    free(twice);
}

static const struct aob_shader no_shaders[] = {{NULL, NULL}};
static const struct aob_technique good_technique = {.abi = AOB_ABI,
                                                    .size = sizeof good_technique,
                                                    .name = "good",
                                                    .title = "t",
                                                    .citation = "c",
                                                    .shaders = no_shaders,
                                                    .values_size = 4,
                                                    .build = build_nothing};

static void test_bad_tables_are_refused(void **state)
{
    (void)state;
    struct aob_error error;
    struct aob_technique bad = good_technique;
    assert_true(aob_technique_judge(&good_technique, &error));
    bad.abi = 12;
    assert_false(aob_technique_judge(&bad, &error));
    assert_contains(error.text, "made for module interface 12 ");
    assert_contains(error.text, "this program has 11 ");
    bad = good_technique;
    bad.size = sizeof bad - 8;
    assert_false(aob_technique_judge(&bad, &error));
    bad.size = sizeof bad + 8;
    assert_false(aob_technique_judge(&bad, &error));
    bad = good_technique;
    bad.name = "Bad-Name";
    assert_false(aob_technique_judge(&bad, &error));
    bad = good_technique;
    bad.build = NULL;
    assert_false(aob_technique_judge(&bad, &error));
}

static void expect_param(const struct aob_param *param, const char *says)
{
    struct aob_technique bad = good_technique;
    struct aob_error error = {{0}};
    bad.params = param;
    bad.param_count = 1;
    if (aob_technique_judge(&bad, &error) != !says)
        fail_msg("%s", error.text);
    if (says)
        assert_contains(error.text, says);
}

static void test_bad_params_are_refused(void **state)
{
    (void)state;
    const struct aob_param
        outside = {.name = "p", .doc = "d", .min = 0, .max = 1, .initial = 2},
        beyond = {.name = "p", .doc = "d", .offset = 4},
        even = {.name = "p", .doc = "d", .type = AOB_INT, .max = 9, .initial = 4, .rule = AOB_ODD},
        odd = {.name = "p", .doc = "d", .type = AOB_INT, .max = 9, .initial = 3, .rule = AOB_ODD},
        real = {.name = "p", .doc = "d", .max = 9, .initial = 1, .rule = AOB_ODD};
    expect_param(&outside, "outside its bounds");
    expect_param(&beyond, "offset");
    expect_param(&even, "rule");
    expect_param(&odd, NULL);
    expect_param(&real, "rule");
}

/* Text that JSON cannot carry would be missing from list, records and the page, without a word. */
static void test_texts_that_would_vanish_are_refused(void **state)
{
    (void)state;
    static const struct aob_shader shaders[] = {{NULL, NULL}};
    const struct aob_technique good_one = {.abi = AOB_ABI,
                                           .size = sizeof good_one,
                                           .name = "good",
                                           .title = "t",
                                           .citation = "c",
                                           .summary = "caf\xc3\xa9",
                                           .shaders = shaders,
                                           .values_size = sizeof(struct values),
                                           .build = build_nothing};
    struct aob_technique bad = good_one;
    const char **const texts[] = {&bad.title, &bad.citation, &bad.summary, &bad.notes};
    struct aob_error error = {{0}};
    assert_true(aob_technique_judge(&bad, &error));
    for (size_t i = 0; i < AOB_COUNT(texts); i++) {
        bad = good_one;
        *texts[i] = "caf\xe9";
        assert_false(aob_technique_judge(&bad, &error));
        assert_contains(error.text, "UTF-8");
    }
    bad = good_one;
    bad.param_count = 3;
    assert_false(aob_technique_judge(&bad, &error));
    assert_contains(error.text, "has no table for its 3 parameters");
}

static void test_travels_as_json(void **state)
{
    (void)state;
    struct aob_registry registry;
    struct aob_technique_list list = {0};
    aob_registry_init(&registry);
    const struct aob_registry_entry *gtao = aob_registry_find(&registry, NULL, "gtao");
    json_t *json = aob_technique_to_json(gtao);
    assert_true(aob_technique_list_add(&list, json));
    const struct aob_technique_info *info = aob_technique_list_find(&list, NULL, "gtao", NULL);
    assert_int_equal(info->param_count, gtao->technique->param_count);
    for (size_t i = 0; i < info->param_count; i++) {
        assert_string_equal(info->params[i].name, gtao->technique->params[i].name);
        assert_int_equal(info->params[i].unit, gtao->technique->params[i].unit);
        assert_int_equal(info->params[i].rule, gtao->technique->params[i].rule);
        assert_true(info->params[i].initial == gtao->technique->params[i].initial);
    }
    json_decref(json);
    aob_technique_list_finish(&list);
    aob_registry_finish(&registry);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_builtins_are_sound),
                                       cmocka_unit_test(test_builds_stand_side_by_side),
                                       cmocka_unit_test(test_addresses),
                                       cmocka_unit_test(test_names),
                                       cmocka_unit_test(test_foreign_files_are_refused),
                                       cmocka_unit_test(test_rows_that_would_mislead_are_refused),
                                       cmocka_unit_test(test_bad_tables_are_refused),
                                       cmocka_unit_test(test_bad_params_are_refused),
                                       cmocka_unit_test(test_texts_that_would_vanish_are_refused),
                                       cmocka_unit_test(test_travels_as_json)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
