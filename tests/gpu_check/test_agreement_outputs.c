#include "check.h"
#include <math.h>
#include <string.h>
#include "gpu_check/agreement.h"
#include "technique/graph.h"

/* Every output just inside and just outside each tolerance, on a GPU and on a software driver. The last pixel is sky. */

enum { COUNT = 1000, MOST = 4 };
static float image[MOST * (COUNT + 1)], expected[MOST * (COUNT + 1)], truth[MOST * (COUNT + 1)],
    depth[COUNT + 1], normal[4 * (COUNT + 1)];
static struct aob_light light;
static struct aob_agreement_desc row = {.width = COUNT + 1,
                                        .height = 1,
                                        .image = image,
                                        .expected = expected,
                                        .depth = depth,
                                        .sky_depth = 100,
                                        .normal = normal,
                                        .light = &light};

/* As in docs/decisions/0029-tolerances-of-gpu-check.md. Whatever is not among them is light. */
struct bars {
    double scale, share, bias, rmse;
};
static struct bars bars_of(enum aob_output output, bool software)
{
    static const struct bars bars[] = {[AOB_OUT_VISIBILITY] = {1, 0.1, 2e-3, 5e-4},
                                       [AOB_OUT_BENT_NORMAL] = {2, 0.1, 2e-3, 5e-4},
                                       [AOB_OUT_VISIBILITY_RGB] = {1, 0.1, 2e-3, 5e-4},
                                       [AOB_OUT_SPECULAR] = {1, 0.25, 5e-3, 3e-3}};
    struct bars of = {3, 0.15, 2e-3, 1e-3};
    if ((size_t)output < sizeof bars / sizeof *bars)
        of = bars[output];
    return software ? (struct bars){of.scale, 1e-3, 1e-4, 1e-4} : of;
}

static void fill(enum aob_output output)
{
    row.output = output;
    row.truth = NULL;
    light = aob_light_uniform;
    for (int c = 0; c < 3; c++)
        light.sh[0][c] *= 3;
    for (int i = 0; i < MOST * (COUNT + 1); i++)
        image[i] = expected[i] = 0.5f;
    for (int i = 0; i <= COUNT; i++) {
        depth[i] = i < COUNT ? 1 : 1000;
        memcpy(&normal[(ptrdiff_t)4 * i], (float[4]){0, 0, 1, 0}, 4 * sizeof(float));
    }
    for (int c = 0; c < MOST; c++)
        image[aob_output_components(output) * COUNT + c] = 7; /* the sky's */
}

/* Moves the last component of the first pixels; every second one the other way where `balanced`. */
static void move(int pixels, double by, bool balanced)
{
    int components = aob_output_components(row.output);
    for (int i = 0; i < pixels; i++)
        image[components * (i + 1) - 1] = (float)(0.5 + (balanced && i % 2 ? -by : by));
}

static bool agrees(bool software, struct aob_error *error)
{
    struct aob_agreement agreement;
    aob_agreement_measure(&row, &agreement);
    return aob_agreement_judge(&agreement, software, error);
}

static void refuse(bool software, const char *words)
{
    struct aob_error error = {{0}};
    assert_false(agrees(software, &error));
    assert_contains(error.text, words);
}

static void try_share(enum aob_output output, bool software)
{
    const struct bars bars = bars_of(output, software);
    int most = (int)lround(bars.share * COUNT);
    fill(output);
    move(COUNT, 0.99 * bars.scale / 255, true);
    assert_true(agrees(software, NULL));
    fill(output);
    move(most, 1.01 * bars.scale / 255, true);
    assert_true(agrees(software, NULL));
    move(most + 1, 1.01 * bars.scale / 255, true);
    refuse(software, "of the pixels differ by more than ");
}

/* By as many pixels as may differ: a mean may be farther off than a step. */
static void try_bias(enum aob_output output, bool software)
{
    static const char *const less[] = {[AOB_OUT_VISIBILITY] = "the image is 0.0",
                                       [AOB_OUT_BENT_NORMAL] = "its Z is 0.0",
                                       [AOB_OUT_VISIBILITY_RGB] = "its B is 0.0",
                                       [AOB_OUT_SPECULAR] = "the image is 0.0",
                                       [AOB_OUT_IRRADIANCE] = "its B is 0.0"};
    const struct bars bars = bars_of(output, software);
    int most = (int)lround(bars.share * COUNT);
    double by = bars.bias * bars.scale * COUNT / most;
    fill(output);
    move(most, 0.99 * by, false);
    assert_true(agrees(software, NULL));
    move(most, -0.99 * by, false);
    assert_true(agrees(software, NULL));
    move(most, 1.01 * by, false);
    refuse(software, output == AOB_OUT_BENT_NORMAL ? " higher on the whole" : " brighter on the whole");
    move(most, -1.01 * by, false);
    refuse(software, output == AOB_OUT_BENT_NORMAL ? " lower on the whole" : " darker on the whole");
    if ((size_t)output < sizeof less / sizeof *less)
        refuse(software, less[output]);
}

/* All values move a little, in balance, and all of them away from the truth. */
static void try_rmse(enum aob_output output, bool software)
{
    const struct bars bars = bars_of(output, software);
    int values = COUNT * aob_output_components(output);
    for (int outside = 0; outside < 2; outside++) {
        double by = (outside ? 1.01 : 0.99) * bars.rmse * bars.scale;
        fill(output);
        row.truth = truth;
        for (int i = 0; i < values; i++) {
            truth[i] = i % 2 ? 0.75f : 0.25f;
            image[i] = (float)(i % 2 ? 0.5 - by : 0.5 + by);
        }
        if (outside)
            refuse(software, "its RMSE against the truth is 0.25");
        else
            assert_true(agrees(software, NULL));
    }
}

static void each_tolerance_has_an_inside_and_an_outside(void **state)
{
    (void)state;
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        for (int software = 0; software < 2; software++) {
            try_share((enum aob_output)which, software);
            try_bias((enum aob_output)which, software);
            try_rmse((enum aob_output)which, software);
        }
}

static struct aob_agreement measure(void)
{
    struct aob_agreement agreement;
    aob_agreement_measure(&row, &agreement);
    return agreement;
}

static void a_light_is_measured_by_what_open_surfaces_receive(void **state)
{
    (void)state;
    fill(AOB_OUT_IRRADIANCE);
    light.sh[2][0] = 1.5; /* red from +Z: 2/3 Y10 of a surface that faces it */
    assert_near(measure().scale, 3 + 1.5 * 2 / 3 * sqrt(3 / (4 * M_PI)) / 3, 1e-6);
    for (int i = 0; i < COUNT; i += 2)
        normal[4 * i + 2] = -1;
    assert_near(measure().scale, 3, 1e-6);
}

static void a_tint_that_cancels_over_channels_is_found(void **state)
{
    (void)state;
    fill(AOB_OUT_VISIBILITY_RGB);
    for (int i = 0; i < COUNT; i++) {
        image[3 * i] = 0.503f;
        image[3 * i + 1] = 0.497f;
    }
    struct aob_agreement a = measure();
    assert_near(a.visible_share, 0, 1e-12);
    assert_near(fabs(a.bias), 0.003, 1e-6);
    assert_near(a.rms, 0.003 * sqrt(2.0 / 3), 1e-6);
    refuse(false, "on the whole (0.002 may be)");
}

static void what_is_no_number_in_one_component_is_found(void **state)
{
    (void)state;
    fill(AOB_OUT_BENT_NORMAL);
    image[3 * 7 + 1] = NAN;
    struct aob_agreement a = measure();
    assert_near(a.visible_share, 1e-3, 1e-12);
    assert_true(isinf(a.max) && isnan(a.bias));
    refuse(false, "its Y is");
}

static void neighbours_of_eight_bits_are_not_visible(void **state)
{
    (void)state;
    fill(AOB_OUT_VISIBILITY_RGB);
    for (int i = 0; i < 3 * COUNT; i++) {
        expected[i] = (float)(i % 255) / 255.0f;
        image[i] = (float)(i % 255 + 1) / 255.0f;
    }
    assert_near(measure().visible_share, 0, 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_tolerance_has_an_inside_and_an_outside),
        cmocka_unit_test(a_light_is_measured_by_what_open_surfaces_receive),
        cmocka_unit_test(a_tint_that_cancels_over_channels_is_found),
        cmocka_unit_test(what_is_no_number_in_one_component_is_found),
        cmocka_unit_test(neighbours_of_eight_bits_are_not_visible),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
