/* What the properties of light draw by lot: lights that are lights, and materials at both ends. */
#include "stress/effects.h"
#include "check.h"
#include <math.h>
#include <stdlib.h>

static void lights_are_not_negative(void **state)
{
    (void)state;
    struct aob_chance chance = aob_chance_of("lights");
    double strongest = 0;
    for (int n = 0; n < 200; n++) {
        const struct aob_light light = aob_effects_light(&chance);
        for (int c = 0; c < 3; c++) {
            assert_near(light.sh[0][c], 2 * sqrt(M_PI), 1e-12); /* a mean radiance of 1 */
            assert_near(aob_light_least(&light, c), 0, 1e-9);
        }
        for (int k = 0; k < 20; k++) {
            double rgb[3];
            aob_light_irradiance(&light, aob_chance_direction(&chance), rgb);
            assert_true(rgb[0] >= -1e-9);
            strongest = fmax(strongest, rgb[0]);
        }
    }
    assert_true(strongest > 1.5 && strongest < 4); /* what the bounds of these properties count on */
}

static void materials_have_both_ends(void **state)
{
    (void)state;
    struct aob_chance chance = aob_chance_of("materials");
    struct aob_gbuffer gbuffer = {.projection = {.width = 40, .height = 30}};
    size_t ends[2] = {0}, count = 2 * 40 * 30;
    aob_effects_paint(&gbuffer, &chance);
    for (size_t i = 0; i < count; i++) {
        assert_true(gbuffer.shine[i] >= 0 && gbuffer.shine[i] <= 1);
        assert_true(gbuffer.albedo[i] >= 0 && gbuffer.albedo[i] <= 1);
        ends[0] += gbuffer.shine[i] == 0;
        ends[1] += gbuffer.shine[i] == 1;
    }
    assert_true(ends[0] > count / 4 && ends[0] < count / 2 && ends[1] > count / 4 && ends[1] < count / 2);
    aob_gbuffer_finish(&gbuffer);
}

static void outputs_have_their_components(void **state)
{
    (void)state;
    static const int components[AOB_OUTPUT_COUNT] = {
        [AOB_OUT_VISIBILITY] = 1, [AOB_OUT_BENT_NORMAL] = 3, [AOB_OUT_VISIBILITY_RGB] = 3,
        [AOB_OUT_SPECULAR] = 1,   [AOB_OUT_IRRADIANCE] = 3,  [AOB_OUT_LIT] = 3};
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        assert_int_equal(aob_output_components((enum aob_output)which), components[which]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(lights_are_not_negative),
                                       cmocka_unit_test(materials_have_both_ends),
                                       cmocka_unit_test(outputs_have_their_components)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
