/* The modelled rows, on records made by hand: which passes and resources they add, and the statistics of their ratios. */
#include <math.h>
#include "check.h"
#include "papers/modelled.h"

static const char record[] =
    "[{\"technique\": \"t\", \"params\": {\"a\": 1}, \"status\": \"ok\", \"width\": 1280, \"cache\": "
    "{\"dev\": {\"status\": \"ok\","
    " \"modelled\": {\"passes\": ["
    "{\"name\": \"ao\", \"ms\": 2, \"low_ms\": 1.5, \"high_ms\": 3, \"launch_ms\": 0.25, \"limit\": "
    "\"texture\","
    " \"resources\": {\"alu\": 0.5, \"texture\": 1.5, \"L1\": 0.75, \"L2\": 0.25, \"memory\": 0.125, "
    "\"targets\": 0.0625}},"
    "{\"name\": \"blur_x\", \"ms\": 1, \"low_ms\": 0.5, \"high_ms\": 2, \"launch_ms\": 0.25, \"limit\": "
    "\"L1\","
    " \"resources\": {\"alu\": 0.25, \"texture\": 0.25, \"L1\": 2.5, \"L2\": 0.5, \"memory\": 0.5, "
    "\"targets\": 0.25}}]}},"
    " \"bare\": {\"status\": \"ok\", \"modelled\": null}, \"uncounted\": {\"status\": \"ok\", \"modelled\": "
    "null,"
    " \"not_modelled\": \"no storage buffers\"}, \"broken\": {\"status\": \"failed\", \"reason\": "
    "\"no levels\"}}}]";

static const struct aob_modelled_row row = {
    .name = "r", .technique = "t", .values = "a=1", .profile = "dev", .ms = 2, .width = 1280};

static bool read_row(struct aob_modelled_row wanted, struct aob_modelled *modelled, struct aob_error *error)
{
    json_t *records = json_loads(record, 0, NULL);
    assert_non_null(records);
    const struct aob_paper_run run = {.records = records};
    bool ok = aob_modelled_read(&wanted, &run, modelled, error);
    json_decref(records);
    return ok;
}

static void test_passes_and_resources(void **state)
{
    (void)state;
    struct aob_modelled m;
    struct aob_error error = {{0}};
    struct aob_modelled_row wanted = row;
    assert_true(read_row(wanted, &m, &error));
    assert_true(m.ms == 3 && m.low == 2 && m.high == 5);
    assert_true(m.parts[AOB_MODELLED_ALU] == 0.75 && m.parts[AOB_MODELLED_TEXTURE] == 1.75);
    assert_true(m.parts[AOB_MODELLED_FILLS] == 4 && m.parts[AOB_MODELLED_MEMORY] == 0.625);
    assert_true(m.parts[AOB_MODELLED_TARGETS] == 0.3125);
    assert_string_equal(m.limit, "L1"); /* 3.25 of both passes, though the first is limited by another */
    wanted.passes = "ao";
    assert_true(read_row(wanted, &m, &error) && m.ms == 2 && m.parts[AOB_MODELLED_FILLS] == 1);
    assert_string_equal(m.limit, "texture");
    wanted.width = 2560; /* half of its columns were run */
    assert_true(read_row(wanted, &m, &error) && m.parts[AOB_MODELLED_ALU] == 1);
    assert_true(m.ms == 3.75 && m.low == 2.75 && m.high == 5.75); /* the time between passes is there once */
}

static void test_no_time(void **state)
{
    (void)state;
    static const struct {
        const char *profile, *passes, *values, *says;
    } cases[] = {{"bare", NULL, "a=1", "bare: the profile has no rates"},
                 {"uncounted", NULL, "a=1", "uncounted: no storage buffers"},
                 {"broken", NULL, "a=1", "broken: no levels"},
                 {"gone", NULL, "a=1", "gone: the run has no figures of it"},
                 {"dev", "horizon", "a=1", "no pass 'horizon'"},
                 {"dev", NULL, "a=2", "no such case"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct aob_modelled_row wanted = row;
        struct aob_modelled m;
        struct aob_error error = {{0}};
        wanted.profile = cases[i].profile;
        wanted.passes = cases[i].passes;
        wanted.values = cases[i].values;
        assert_false(read_row(wanted, &m, &error));
        assert_contains(error.text, cases[i].says);
    }
}

/* Logarithms -ln 2, 0, ln 2, 2 ln 2: mean ln(2) / 2; deviations -1.5, -.5, .5, 1.5 times ln 2: variance 5/3 of its
 * square. */
static void test_statistics(void **state)
{
    (void)state;
    const double ratios[] = {0.5, 1, 2, 4};
    struct aob_modelled_sum sum = aob_modelled_summarise(ratios, 4);
    assert_int_equal(sum.count, 4);
    assert_near(sum.mean, sqrt(2), 1e-12);
    assert_near(sum.scatter, exp(sqrt(5.0 / 3) * log(2)), 1e-12);
    assert_near(sum.within, 0.75, 1e-12);
    sum = aob_modelled_summarise(ratios, 0);
    assert_true(isnan(sum.mean) && isnan(sum.scatter) && isnan(sum.within));
}

static const struct aob_modelled_row *find(const char *name)
{
    const struct aob_modelled_row *found = aob_modelled_rows;
    while (found->name && strcmp(found->name, name) != 0)
        found++;
    assert_non_null(found->name);
    return found;
}

/* Figures that were worked out apart from frames a second, in bc. */
static void test_the_texts_times(void **state)
{
    (void)state;
    assert_near(find("hbao-ultra-full-8x8")->ms, 52.3719, 1e-4);
    assert_near(find("hbao-ultra-full-8x8")->low, 50.6704, 1e-4);
    assert_near(find("hbao-ultra-full-8x8")->high, 54.1752, 1e-4);
    assert_near(find("hbao-8600gts-half-16x16")->ms, 143.4109, 1e-4);
    assert_near(find("hbao-ultra-blur")->ms, 3.1071, 1e-4);
    assert_near(find("alchemy-460se-filter")->ms, 1.6, 1e-12);
    for (const struct aob_modelled_row *r = aob_modelled_rows; r->name; r++)
        assert_true(r->config ? r->low < r->ms && r->ms < r->high && r->low > 0 : r->open != NULL);
    for (const struct aob_modelled_pair *pair = aob_modelled_pairs; pair->row; pair++)
        assert_string_equal(find(pair->row)->profile, find(pair->to)->profile);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_passes_and_resources),
                                       cmocka_unit_test(test_no_time), cmocka_unit_test(test_statistics),
                                       cmocka_unit_test(test_the_texts_times)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
