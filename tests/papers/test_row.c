/* The rows of the table, on journals made by hand: verdicts, and reasons, each beside figures that show it and beside
 * such that do not. */
#include <stdlib.h>
#include "script.h"

static void samples(struct script *script, double share, double two, double three, double four)
{
    script->share = share;
    add(script, "alchemy", "\"samples_per_band\": 2", "obscurance", two, "blur", 1.0, NULL);
    add(script, "alchemy", "\"samples_per_band\": 3", "obscurance", three, "blur", 1.0, NULL);
    add(script, "alchemy", "\"samples_per_band\": 4", "obscurance", four, "blur", 1.43, NULL);
}

static void reasons_of_alchemy(void **state)
{
    (void)state;
    struct script s = {json_array(), 0};
    samples(&s, 0.01, 10, 15, 20);
    expect(&s, "alchemy-samples", AOB_PAPER_REPRODUCED, "");
    samples(&s, 0.01, 10, 12, 14); /* 6 before the first sample, 2 each; of 10 that is .6 */
    expect(&s, "alchemy-samples", AOB_PAPER_SHAPE, "costs 0.6 [0.5");
    samples(&s, 0.2, 10, 12, 14);
    expect(&s, "alchemy-samples", AOB_PAPER_NOT_JUDGED, "[0.8, 1.8] still holds the bar 1.125");
    samples(&s, 0.04, 10, 10.1, 14); /* 1.01 misses 1.125 for sure, and may be above 1 or below */
    expect(&s, "alchemy-samples", AOB_PAPER_NOT_JUDGED, "the intervals still leave the order open");
    samples(&s, 0.01, 10, 20, 30); /* nothing before the first sample explains this one */
    expect(&s, "alchemy-samples", AOB_PAPER_SHAPE, "no reason known");
    samples(&s, 0.01, 10, 15, 20);
    expect(&s, "alchemy-filter", AOB_PAPER_REPRODUCED, "");

    static const double up[] = {0.5, 0.1};
    static const char *const says[] = {"without it the quotient is 1.2", "no reason known"};
    for (int i = 0; i < 2; i++) { /* 2.2 and 1.8 in all; the rest is 1.2 or 1.7 of Alchemy */
        add(&s, "volumetric_obscurance", "\"samples\": 6", "coarse", i ? 0.85 : 0.6, "upsample", up[i], NULL);
        add(&s, "alchemy", "\"samples\": 4", "obscurance", 0.5, NULL);
        expect(&s, "alchemy-vo", AOB_PAPER_SHAPE, says[i]);
    }
    json_decref(s.records);
}

static void reasons_of_alchemy_beta(void **state)
{
    (void)state;
    struct script s = {json_array(), 0};
    static const struct {
        const char *bytes, *floats;
        enum aob_paper_verdict verdict;
        const char *says;
    } betas[] = {
        {"-0.001", "0.0", AOB_PAPER_REPRODUCED, ""},
        {"-0.006", "-0.0001", AOB_PAPER_SHAPE, "normals of 32-bit floats 1e-4 leaves 0.0001"},
        {"-0.006", "-0.006", AOB_PAPER_SHAPE, "no reason known"},
        {"-0.02", "-0.0001", AOB_PAPER_NOT_REPRODUCED, "normals of 32-bit floats 1e-4 leaves 0.0001"}};
    for (size_t i = 0; i < sizeof betas / sizeof *betas; i++) {
        char text[128];
        static const char *const normals[] = {"rgba8", "rgba32f"};
        for (int d = 0; d < 2; d++) {
            snprintf(text, sizeof text, "\"bias\": 0, \"normal_encoding\": \"%s\"", normals[d]);
            add(&s, "alchemy", text, NULL);
            snprintf(text, sizeof text, "\"bias\": 1e-4, \"normal_encoding\": \"%s\"", normals[d]);
            add(&s, "alchemy", text, NULL);
        }
        static const char *const none = "-0.013";
        const char *const biases[] = {none, betas[i].bytes, none, betas[i].floats};
        for (size_t r = 0; r < 4; r++) {
            json_t *error = json_pack("{s:f}", "bias", atof(biases[r]));
            json_object_set_new(json_array_get(s.records, r), "error", error);
        }
        expect(&s, "alchemy-beta", betas[i].verdict, betas[i].says);
    }
    json_decref(s.records);
}

static void radii(struct script *script, double share, const double *costs)
{
    static const char *const names[] = {"0.25", "0.5", "1", "1.5", "2", "3"};
    script->share = share;
    for (int i = 0; i < 6; i++) {
        char text[32];
        snprintf(text, sizeof text, "\"radius\": %s", names[i]);
        add(script, "alchemy", text, "obscurance", costs[i], NULL);
    }
}

static void fields(struct script *script, double share, double a, double b, double c, double d)
{
    const double costs[] = {a, b, c, d};
    script->share = share;
    for (int i = 0; i < 4; i++) {
        char text[32];
        snprintf(text, sizeof text, "\"fov_deg\": %d", 30 * (i + 1));
        add(script, "alchemy", text, "obscurance", costs[i], NULL);
    }
}

/* What grows or falls: judged by steps beyond their noise, with no share that is allowed. */
static void trends(void **state)
{
    (void)state;
    struct script s = {json_array(), 0};
    radii(&s, 0.01, (const double[]){1, 1.1, 1.3, 1.5, 1.52, 1.54});
    expect(&s, "alchemy-radius", AOB_PAPER_REPRODUCED, "");
    radii(&s, 0.01, (const double[]){1, 1.1, 1.3, 1.5, 1.75, 2.3});
    expect(&s, "alchemy-radius", AOB_PAPER_SHAPE, "no reason known");
    radii(&s, 0.01, (const double[]){1, 1, 1, 0.9, 0.9, 0.9});
    expect(&s, "alchemy-radius", AOB_PAPER_NOT_REPRODUCED, "no reason known");
    radii(&s, 0.1, (const double[]){1, 1.03, 1.05, 1.06, 1.06, 1.06});
    expect(&s, "alchemy-radius", AOB_PAPER_NOT_JUDGED, "the intervals still leave the claim open");
    fields(&s, 0.01, 1, 0.9, 0.91, 0.8); /* the step up is within the noise */
    expect(&s, "alchemy-field", AOB_PAPER_REPRODUCED, "");
    fields(&s, 0.001, 1, 0.9, 0.91, 0.8);
    expect(&s, "alchemy-field", AOB_PAPER_NOT_REPRODUCED, "no reason known");
    fields(&s, 0.1, 1, 0.98, 0.97, 0.96);
    expect(&s, "alchemy-field", AOB_PAPER_NOT_JUDGED, "the intervals still leave the claim open");
    fields(&s, 0.01, 1, 1, 1, 1.1);
    expect(&s, "alchemy-field", AOB_PAPER_NOT_REPRODUCED, "no reason known");
    json_decref(s.records);
}

/* Costs of the AO at full and half size by directions, the blur of both, and the pass that samples up. */
static void hbao(struct script *script, const double *full, const double *half, double blur, double up)
{
    static const int directions[] = {4, 8, 16};
    script->share = 0.005;
    for (int i = 0; i < 3; i++) {
        char text[64];
        snprintf(text, sizeof text, "\"directions\": %d, \"divisor\": 1", directions[i]);
        add(script, "hbao", text, "horizon", full[i], "blur_x1", blur, NULL);
        snprintf(text, sizeof text, "\"directions\": %d, \"divisor\": 2", directions[i]);
        add(script, "hbao", text, "horizon", half[i], "blur_x1", blur / 4, "upsample", up, NULL);
    }
}

static void reasons_of_hbao(void **state)
{
    (void)state;
    struct script s = {json_array(), 0};
    const double full[] = {1, 2.92, 9.25}, quarter[] = {0.25, 0.73, 2.3125}, steep[] = {1, 4, 16},
                 flat[] = {1, 1.2, 2}, halves[] = {0.5, 1.5, 5};
    hbao(&s, full, quarter, 0.17, 0);
    expect(&s, "hbao-samples", AOB_PAPER_REPRODUCED, "");
    hbao(&s, full, quarter, 0.17, 0);
    expect(&s, "hbao-blur", AOB_PAPER_REPRODUCED, "");
    hbao(&s, full, quarter, 1.2, 0);
    expect(&s, "hbao-blur", AOB_PAPER_NOT_REPRODUCED, "no reason known");
    hbao(&s, flat, quarter, 0.17, 0); /* 1 - (2 - 1) / 15 */
    expect(&s, "hbao-samples", AOB_PAPER_SHAPE, "costs 0.933 [");
    hbao(&s, steep, quarter, 0.17, 0); /* 1 - 15 / 15: none, and the text's have half */
    expect(&s, "hbao-samples", AOB_PAPER_SHAPE, "costs 0 [");
    hbao(&s, (const double[]){1, 1.1, 9.25}, quarter, 0.17,
         0); /* the line is the text's, so it is no reason */
    expect(&s, "hbao-samples", AOB_PAPER_SHAPE, "no reason known");
    const double less[] = {0.28, 0.75, 2.3125}; /* 1.17 / 0.3225 = 3.63 without the pass, 1.88 with it */
    hbao(&s, full, less, 0.17, 0.3);
    expect(&s, "hbao-half", AOB_PAPER_SHAPE, "without it the gains are 3.63 [");
    hbao(&s, full, halves, 0.17, 0.3);
    expect(&s, "hbao-half", AOB_PAPER_SHAPE, "no reason known");
    hbao(&s, full, quarter, 0.17, 0.3);
    expect(&s, "hbao-half-ao", AOB_PAPER_REPRODUCED, "");
    hbao(&s, full, halves, 0.17, 0);
    expect(&s, "hbao-half-ao", AOB_PAPER_SHAPE, "no reason known");
    json_decref(s.records);
}

static void crytek(struct script *script, double full, double half, double near)
{
    script->share = 0.005;
    add(script, "crytek_ssao", "\"screen_radius\": 0.0936, \"depth_divisor\": 1", "access", full, "tile_blur",
        9.0, NULL);
    add(script, "crytek_ssao", "\"screen_radius\": 0.0936, \"depth_divisor\": 2", "downsample", 0.1, "access",
        half - 0.1, "tile_blur", 9.0, NULL);
    add(script, "crytek_ssao", "\"screen_radius\": 1e-4, \"depth_divisor\": 1", "access", near, "tile_blur",
        9.0, NULL);
}

static void gtao(struct script *script, const char *best, double full, double half, double up)
{
    script->share = 0.005;
    add(script, "gtao", "\"slices\": 1, \"divisor\": 1, \"rmse\": 0.1", "horizon", 1.0, NULL);
    add(script, "gtao", "\"slices\": 3, \"divisor\": 1, \"rmse\": 0.07", "horizon", full, NULL);
    add(script, "gtao", "\"slices\": 3, \"divisor\": 2, \"rmse\": 0.07", "horizon", half, "upsample", up,
        NULL);
    add(script, "gtao", best, "horizon", 9.0, NULL);
}

static void reasons_of_others(void **state)
{
    (void)state;
    struct script s = {json_array(), 0};
    crytek(&s, 2, 1, 2); /* the blur, which the text does not speak of, would hide it */
    expect(&s, "crytek-half", AOB_PAPER_REPRODUCED, "");
    crytek(&s, 2, 2.1, 1.9);
    expect(&s, "crytek-half", AOB_PAPER_NOT_REPRODUCED, "faster by a factor of 1.05 [");
    crytek(&s, 2, 2.1, 0.9); /* near reads are cheap here: the cause is there, the gain is not */
    expect(&s, "crytek-half", AOB_PAPER_NOT_REPRODUCED, "no reason known");

#define BEST "\"slices\": 9, \"divisor\": 1, "
    gtao(&s, BEST "\"rmse\": 0.003, \"estimator_rmse\": 0.002, \"missing_rmse\": 0.002", 3, 1, 0.5);
    expect(&s, "gtao-error", AOB_PAPER_REPRODUCED, "");
    gtao(&s, BEST "\"rmse\": 0.07, \"estimator_rmse\": 0.002, \"missing_rmse\": 0.069", 3, 1, 0.5);
    expect(&s, "gtao-error", AOB_PAPER_NOT_REPRODUCED, "hidden sides, makes an error of 0.069");
    gtao(&s, BEST "\"rmse\": 0.07, \"estimator_rmse\": 0.068, \"missing_rmse\": 0.001", 3, 1, 0.5);
    expect(&s, "gtao-error", AOB_PAPER_NOT_REPRODUCED, "what it knows, one of 0.068");
    gtao(&s, BEST "\"rmse\": 0.07, \"estimator_rmse\": 0.001, \"missing_rmse\": 0.001", 3, 1, 0.5);
    expect(&s, "gtao-error", AOB_PAPER_NOT_REPRODUCED, "no reason known");
    gtao(&s, BEST "\"rmse\": 0.07, \"estimator_rmse\": 0.1, \"missing_rmse\": 0.1", 3, 1, 0.5);
    expect(&s, "gtao-half", AOB_PAPER_REPRODUCED, "");
    gtao(&s, BEST "\"rmse\": 0.07, \"estimator_rmse\": 0.1, \"missing_rmse\": 0.1", 3, 1, 3);
    expect(&s, "gtao-half", AOB_PAPER_NOT_REPRODUCED, "without it the quotient is 3 [");
    gtao(&s, BEST "\"rmse\": 0.07, \"estimator_rmse\": 0.1, \"missing_rmse\": 0.1", 3, 4, 1);
    expect(&s, "gtao-half", AOB_PAPER_NOT_REPRODUCED, "no reason known");
    json_decref(s.records);
}

static void reasons_of_volumes(void **state)
{
    (void)state;
    struct script s = {json_array(), 0};
    static const struct {
        const char *error;
        enum aob_paper_verdict verdict;
    } solids[] = {{"\"bias\": 0.003, \"rmse\": 0.011, \"reference_se\": 0.0108", AOB_PAPER_REPRODUCED},
                  {"\"bias\": 0.0045, \"rmse\": 0.011, \"reference_se\": 0.0108", AOB_PAPER_NOT_REPRODUCED},
                  {"\"bias\": 0.0039, \"rmse\": 0.011, \"reference_se\": 0.0108", AOB_PAPER_NOT_JUDGED},
                  {"\"bias\": 0.001, \"rmse\": 0.011, \"reference_se\": 0.01", AOB_PAPER_NOT_REPRODUCED}},
      thins[] = {{"\"bias\": -0.001, \"reference_se\": 0.04", AOB_PAPER_REPRODUCED},
                 {"\"bias\": -0.0007, \"reference_se\": 0.04", AOB_PAPER_NOT_JUDGED},
                 {"\"bias\": 0.001, \"reference_se\": 0.04", AOB_PAPER_NOT_REPRODUCED}};
    static const char *const words[] = {[AOB_PAPER_NOT_REPRODUCED] = "no reason known",
                                        [AOB_PAPER_NOT_JUDGED] = "still leave the claim open",
                                        [AOB_PAPER_REPRODUCED] = ""};
    char text[160]; /* of 10,000 pixels the mean's noise is 1.96 hundredths of one's */
    for (size_t i = 0; i < sizeof solids / sizeof *solids; i++) {
        snprintf(text, sizeof text, "\"radius\": 0.25, \"pixels\": 10000, %s", solids[i].error);
        add(&s, "ao_volumes", text, NULL);
        expect(&s, "aov-solid", solids[i].verdict, words[solids[i].verdict]);
    }
    for (size_t i = 0; i < sizeof thins / sizeof *thins; i++) {
        snprintf(text, sizeof text, "\"radius\": 0.8, \"pixels\": 10000, \"rmse\": 1, %s", thins[i].error);
        add(&s, "ao_volumes", text, NULL);
        expect(&s, "aov-thin", thins[i].verdict, words[thins[i].verdict]);
    }
    json_decref(s.records);
}

/* What is not judged says why, whatever was measured. */
static void what_the_text_leaves_open(void **state)
{
    (void)state;
    struct script s = {json_array(), 0};
    add(&s, "alchemy", "\"guard_band\": 0", "obscurance", 1.0, NULL);
    add(&s, "alchemy", "\"guard_band\": 32", "obscurance", 1.0, NULL);
    expect(&s, "alchemy-guard", AOB_PAPER_NOT_JUDGED, "leaves the width of its band open");
    add(&s, "hbao", "\"divisor\": 1", "horizon", 22.0, NULL);
    add(&s, "hbao", "\"divisor\": 2", "horizon", 8.5, NULL);
    add(&s, "alchemy", "\"samples_per_band\": 4", "obscurance", 2.6, NULL);
    expect(&s, "alchemy-dragon", AOB_PAPER_NOT_JUDGED, "how many samples its HBAO took");
    json_decref(s.records);
    for (const struct aob_paper_row *row = aob_paper_rows; row->name; row++) {
        struct aob_paper_outcome outcome = {.row = row};
        struct aob_text reason = {0};
        assert_true((row->config != NULL) == (row->measure != NULL));
        assert_true((row->config != NULL) == (row->count > 0));
        assert_true(row->config || row->open);
        if (!row->config) {
            assert_true(aob_paper_judge(row, &outcome.result) == AOB_PAPER_NOT_JUDGED);
            aob_paper_explain(&outcome, &reason);
            assert_string_equal(reason.data, row->open);
        }
        aob_text_finish(&reason);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reasons_of_alchemy),
        cmocka_unit_test(reasons_of_alchemy_beta),
        cmocka_unit_test(trends),
        cmocka_unit_test(reasons_of_hbao),
        cmocka_unit_test(reasons_of_others),
        cmocka_unit_test(reasons_of_volumes),
        cmocka_unit_test(what_the_text_leaves_open),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
