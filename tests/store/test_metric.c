#include <math.h>
#include <string.h>
#include "check.h"
#include "store/metric.h"

/* A field without a row would be written nowhere, one with two rows twice. */
static void every_field_has_one_row(void **state)
{
    (void)state;
    struct aob_metrics all;
    size_t rows = 0;
    memset(&all, 0, sizeof all);
    for (const struct aob_metric *m = aob_metric_table; m->name; m++, rows++) {
        assert_true(aob_metric_get(&all, m) == 0);
        aob_metric_set(&all, m, 1);
        assert_ptr_equal(aob_metric_find(m->name), m);
        assert_true(m->doc[strlen(m->doc) - 1] == '.');
        assert_true(*m->title);
    }
    assert_int_equal(rows, sizeof all / sizeof(double));
    assert_null(aob_metric_find("no_such_metric"));
}

static void json_gives_back_what_it_took(void **state)
{
    (void)state;
    struct aob_metrics out, back;
    double value = 1;
    aob_metrics_init(&out);
    for (const struct aob_metric *m = aob_metric_table; m->name; m++, value += m->whole ? 1 : 0.25)
        aob_metric_set(&out, m, m->whole ? ceil(value) : value);
    out.ssim = NAN;
    json_t *object = json_object();
    aob_metrics_to_json(&out, 1u << AOB_OUT_VISIBILITY, object);
    assert_null(json_object_get(object, "bent_mean")); /* of an output that was not asked for */
    aob_metrics_to_json(&out, ~(1u << AOB_OUT_VISIBILITY), object);
    assert_true(json_is_null(json_object_get(object, "ssim")));
    assert_true(json_is_integer(json_object_get(object, "pixels")));
    assert_true(json_number_value(json_object_get(json_object_get(object, "covariance"),
                                                  "missing_estimator")) == out.missing_estimator);
    aob_metrics_from_json(&back, object);
    for (const struct aob_metric *m = aob_metric_table; m->name; m++)
        assert_true(aob_metric_get(&out, m) == aob_metric_get(&back, m) || m == aob_metric_find("ssim"));
    assert_true(isnan(back.ssim));
    json_decref(object);
    aob_metrics_from_json(&back, NULL);
    assert_true(isnan(back.rmse) && isnan(back.pixels) && isnan(back.definition_missing));
}

/* Known and brief ones only, in the order of the table. */
static void a_line_has_the_brief_ones(void **state)
{
    (void)state;
    struct aob_metrics metrics;
    struct aob_text text = {0};
    aob_metrics_init(&metrics);
    metrics.rmse = 0.04567;
    metrics.mae = 0.5;
    metrics.bias = -0.01;
    aob_metrics_print_brief(&metrics, ~0u, ", ", &text);
    assert_string_equal(text.data, ", RMSE 0.0457, bias \u22120.0100");
    metrics.bent_mean = 12.5;
    aob_text_finish(&text);
    aob_metrics_print_brief(&metrics, ~0u, "; ", &text);
    assert_string_equal(text.data, "; RMSE 0.0457; bias \u22120.0100; bent normal 12.5000 degrees");
    aob_text_finish(&text);
    aob_metrics_print_brief(&metrics, 1u << AOB_OUT_VISIBILITY, "; ", &text);
    assert_string_equal(text.data, "; RMSE 0.0457; bias \u22120.0100");
    aob_text_finish(&text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_field_has_one_row),
                                       cmocka_unit_test(json_gives_back_what_it_took),
                                       cmocka_unit_test(a_line_has_the_brief_ones)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
