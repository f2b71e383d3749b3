/* The closed forms of the listed scenes against the ray tracer, pixel by pixel, and what the score says of wrong images. */
#include "score/oracle_score.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "check.h"
#include "rig.h"

enum { WIDTH = 64, HEIGHT = 36, GUARD = 8, SPP = 1024 };

static void trace(const struct aob_rig *rig, double radius, struct aob_visibility *traced)
{
    const struct aob_visibility_term term = {.radius = radius};
    struct aob_error error = {""};
    const struct aob_visibility_desc desc = {.terms = &term,
                                             .term_count = 1,
                                             .x0 = GUARD,
                                             .y0 = GUARD,
                                             .width = WIDTH,
                                             .height = HEIGHT,
                                             .spp = SPP};
    if (!aob_tracer_visibility(rig->tracer, &rig->camera, &rig->hits, &desc, traced, &error))
        fail_msg("%s", error.text);
}

static struct aob_oracle_score score(const struct aob_rig *rig, const char *scene, double radius,
                                     const float *image)
{
    struct aob_oracle_score score;
    const struct aob_oracle_desc desc = {
        .oracle = aob_oracle_find(scene), .camera = &rig->camera, .gbuffer = &rig->gbuffer, .radius = radius};
    assert_non_null(desc.oracle);
    aob_oracle_score(&desc, image, &score);
    return score;
}

/* A view that shows hardly a point with a closed form proves nothing. */
static const struct expected {
    const char *scene;
    double radius;
    size_t pixels, band_pixels; /* at least, in each view */
} rows[] = {
    {"plane", 0.5, 1100, 0},        {"plane", INFINITY, 1100, 0}, {"corner", 0.5, 880, 66},
    {"corner", 2, 880, 176},        {"wall", 0.2, 660, 100},      {"wall", 0.5, 660, 220},
    {"wall", INFINITY, 660, 220},   {"sheet", 0.3, 660, 132},     {"sheet", 0.5, 660, 132},
    {"sphere", 0.5, 440, 0},        {"sphere", INFINITY, 440, 0}, {"room", 0.5, 2200, 2200},
    {"room", INFINITY, 2200, 2200}, {"disc", 0.16, 13, 13},       {"disc", 0.5, 220, 220},
    {"disc", INFINITY, 880, 220},
};

static void forms_are_what_the_tracer_finds(void **state)
{
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        const struct aob_scene_info *scene = aob_scene_find(rows[i].scene);
        for (size_t v = 0; v < scene->view_count; v++) {
            struct aob_rig rig;
            struct aob_visibility traced;
            aob_rig_scene(&rig, rows[i].scene, scene->views[v].name, WIDTH, HEIGHT, GUARD);
            trace(&rig, rows[i].radius, &traced);
            struct aob_oracle_score s = score(&rig, rows[i].scene, rows[i].radius, traced.ao);
            if (!(s.rmse <= 0.003) || (s.band_pixels && !(s.band_rmse <= 0.003)) ||
                s.pixels < rows[i].pixels || s.band_pixels < rows[i].band_pixels)
                fail_msg("%s/%s, radius %g: RMSE %.5f, in band %.5f, pixels %zu, in band %zu", rows[i].scene,
                         scene->views[v].name, rows[i].radius, s.rmse, s.band_rmse, s.pixels, s.band_pixels);
            aob_visibility_finish(&traced);
            aob_rig_finish(&rig);
        }
    }
}

static void a_wrong_image_scores_how_wrong_it_is(void **state)
{
    (void)state;
    struct aob_rig rig;
    float *image = AOB_NEW_ARRAY(float, WIDTH *HEIGHT);
    aob_rig_scene(&rig, "room", NULL, WIDTH, HEIGHT, GUARD);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        image[i] = i % 2 ? 0.3f : 0.1f;
    struct aob_oracle_score s = score(&rig, "room", 1, image);
    assert_int_equal(s.pixels, WIDTH * HEIGHT);
    assert_int_equal(s.band_pixels, WIDTH * HEIGHT);
    assert_near(s.rmse, sqrt(0.05), 1e-6); /* the mean of 0.01 and 0.09 */
    assert_near(s.bias, 0.2, 1e-6);
    image[7] = NAN;
    assert_int_equal(score(&rig, "room", 1, image).pixels, WIDTH * HEIGHT - 1);
    s = score(&rig, "room", 0.3, image); /* less than the diagonal */
    assert_int_equal(s.pixels, 0);
    assert_true(isnan(s.rmse) && isnan(s.bias) && isnan(s.band_rmse));
    aob_rig_finish(&rig);
    free(image);
}

static void only_listed_oracles_have_one(void **state)
{
    (void)state;
    size_t found = 0;
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++)
        found += aob_oracle_find((*s)->name) != NULL;
    assert_int_equal(found, 7);
    assert_null(aob_oracle_find("cornell"));
    assert_null(aob_oracle_find(NULL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(forms_are_what_the_tracer_finds),
        cmocka_unit_test(a_wrong_image_scores_how_wrong_it_is),
        cmocka_unit_test(only_listed_oracles_have_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
