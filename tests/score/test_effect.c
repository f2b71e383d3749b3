#include <math.h>
#include "check.h"
#include "score/effect.h"
#include "score/flip.h"

enum { W = 4, H = 2, N = W * H };

/* Pixels 0..3 are in band, 4..6 are not, the last is sky and holds what would spoil any sum. */
struct still {
    float depth[N], visible[N], image[3 * N], truth[3 * N], se[3 * N], plain[3 * N], model[3 * N];
    struct aob_score_desc desc;
    struct aob_effect effect;
};

static void still_init(struct still *still, enum aob_output output, int components)
{
    *still = (struct still){.effect = {.output = output, .components = components}};
    for (int i = 0; i < N; i++) {
        still->depth[i] = i == N - 1 ? 1e9f : 1;
        still->visible[i] = i < 4 ? 0.5f : 1;
        for (int c = 0; c < components; c++) {
            int at = i * components + c;
            still->truth[at] = 0.5f;
            still->image[at] = 0.5f + (i < 4 ? 0.1f : -0.2f) * (float)(c + 1);
            still->se[at] = 0.01f * (float)(c + 1);
            still->plain[at] = 0.5f - 0.3f;
            still->model[at] = 0.5f + 0.05f;
            if (i == N - 1)
                still->image[at] = still->truth[at] = NAN;
        }
    }
    still->desc = (struct aob_score_desc){
        .width = W, .height = H, .depth = still->depth, .sky_depth = 5e8f, .truth = still->visible};
    still->effect.image = still->image;
    still->effect.truth = still->truth;
    still->effect.se = still->se;
    still->effect.plain = still->plain;
    still->effect.model = still->model;
}

/* Over three channels with errors of one, two and three times .1 in band and -.2 elsewhere: squares add up to 14 of the first. */
static void colours_are_the_mean_of_their_squares(void **state)
{
    (void)state;
    struct still still;
    struct aob_metrics m;
    still_init(&still, AOB_OUT_VISIBILITY_RGB, 3);
    aob_metrics_init(&m);
    aob_effect_score(&still.desc, &still.effect, &m);
    assert_near(m.bounce_band, 0.1 * sqrt(14.0 / 3), 1e-6);
    assert_near(m.bounce_rmse, sqrt((4 * 0.01 * 14 + 3 * 0.04 * 14) / 21), 1e-6);
    assert_near(m.bounce_bias, (4 * 0.1 * 6 - 3 * 0.2 * 6) / 21, 1e-6);
    assert_near(m.bounce_se, 0.01 * sqrt(14.0 / 3), 1e-7);
    assert_near(m.bounce_plain, 0.3, 1e-6);
    assert_near(m.bounce_model, 0.05, 1e-6);
    assert_true(isnan(m.rmse) && isnan(m.specular_rmse) && isnan(m.irradiance_rmse));
}

/* The truth is .5 throughout, so what is relative is twice what is not. */
static void light_is_relative(void **state)
{
    (void)state;
    struct still still;
    struct aob_metrics m;
    still_init(&still, AOB_OUT_IRRADIANCE, 3);
    aob_metrics_init(&m);
    aob_effect_score(&still.desc, &still.effect, &m);
    assert_near(m.irradiance_band, 0.2 * sqrt(14.0 / 3), 1e-6);
    assert_near(m.irradiance_plain, 0.6, 1e-6);
    assert_near(m.irradiance_bias, 2 * (4 * 0.1 * 6 - 3 * 0.2 * 6) / 21, 1e-6);
    assert_true(isnan(m.bounce_rmse));
    still_init(&still, AOB_OUT_SPECULAR, 1);
    aob_effect_score(&still.desc, &still.effect, &m);
    assert_near(m.specular_band, 0.2, 1e-6);
    assert_near(m.specular_rmse, 2 * sqrt((4 * 0.01 + 3 * 0.04) / 7), 1e-6);
    assert_near(m.specular_se, 0.02, 1e-7);
    assert_near(m.specular_plain, 0.6, 1e-6);
}

/* The lit image is relative too, and looked at as it is asked for. */
static void lit_images_are_looked_at(void **state)
{
    (void)state;
    struct still still;
    struct aob_metrics m;
    still_init(&still, AOB_OUT_LIT, 3);
    still.effect.plain = still.effect.model = NULL;
    still.effect.exposure = 0.75;
    aob_metrics_init(&m);
    aob_effect_score(&still.desc, &still.effect, &m);
    assert_near(m.lit_band, 0.2 * sqrt(14.0 / 3), 1e-6);
    assert_near(m.lit_rmse, 2 * sqrt((4 * 0.01 * 14 + 3 * 0.04 * 14) / 21), 1e-6);
    assert_near(m.lit_bias, 2 * (4 * 0.1 * 6 - 3 * 0.2 * 6) / 21, 1e-6);
    assert_near(m.lit_se, 0.02 * sqrt(14.0 / 3), 1e-7);
    assert_near(m.lit_exposure, 0.75, 0);
    assert_near(m.lit_flip, aob_flip_colour(&still.desc, still.image, still.truth, 0.75), 0);
    assert_true(fabs(m.lit_flip - aob_flip_colour(&still.desc, still.image, still.truth, 1)) > 1e-3);
    assert_true(isnan(m.irradiance_rmse));
}

/* Nothing is a share of no light. */
static void what_is_dark_has_no_relative_error(void **state)
{
    (void)state;
    struct still still;
    struct aob_metrics m;
    still_init(&still, AOB_OUT_SPECULAR, 1);
    for (int i = 0; i < N; i++)
        still.truth[i] = 0;
    aob_metrics_init(&m);
    aob_effect_score(&still.desc, &still.effect, &m);
    assert_true(isnan(m.specular_rmse) && isnan(m.specular_band) && isnan(m.specular_bias) &&
                isnan(m.specular_se) && isnan(m.specular_plain));
}

static void refuse(enum aob_output output, float value, const char *says)
{
    struct still still;
    struct aob_error error = {{0}};
    still_init(&still, output, 1);
    assert_true(aob_effect_judge(&still.desc, &still.effect, &error));
    still.image[5] = value;
    assert_false(aob_effect_judge(&still.desc, &still.effect, &error));
    assert_contains(error.text, says);
}

static void what_is_no_light_is_refused(void **state)
{
    (void)state;
    struct still still;
    refuse(AOB_OUT_SPECULAR, 1.02f,
           "pixel (1, 1) of the specular is 1.02: it must be finite and within 0..1");
    refuse(AOB_OUT_SPECULAR, NAN, "within 0..1");
    refuse(AOB_OUT_VISIBILITY_RGB, -0.01f, "visibility_rgb is -0.01");
    refuse(AOB_OUT_IRRADIANCE, -1e-6f, "it must be finite and not negative");
    refuse(AOB_OUT_IRRADIANCE, INFINITY, "irradiance is inf");
    refuse(AOB_OUT_LIT, -0.5f, "the lit is -0.5: it must be finite and not negative");
    still_init(&still, AOB_OUT_IRRADIANCE, 1);
    still.image[5] = 1e6f; /* a bright light */
    assert_true(aob_effect_judge(&still.desc, &still.effect, NULL));
}

/* Jimenez et al. 2016: open stays open, closed stays closed, black reflects nothing; one value by hand, of albedo .5 at v = .5: a =
 * .6878, b = -1.75585, c = 2.0679. */
static void bounces_follow_the_text(void **state)
{
    (void)state;
    for (double albedo = 0; albedo <= 1; albedo += 0.125) {
        assert_near(aob_effect_bounced(1, albedo), 1, 2e-4);
        assert_near(aob_effect_bounced(0, albedo), 0, 0);
    }
    for (double v = 0; v <= 1; v += 0.0625)
        assert_near(aob_effect_bounced(v, 0), v, 6e-4);
    assert_near(aob_effect_bounced(0.5, 0.5), 0.0859750 - 0.4389625 + 1.03395, 1e-7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(colours_are_the_mean_of_their_squares),
                                       cmocka_unit_test(light_is_relative),
                                       cmocka_unit_test(lit_images_are_looked_at),
                                       cmocka_unit_test(what_is_dark_has_no_relative_error),
                                       cmocka_unit_test(what_is_no_light_is_refused),
                                       cmocka_unit_test(bounces_follow_the_text)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
