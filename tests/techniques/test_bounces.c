#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "reference/incident.h"
#include "rig.h"
#include "score/effect.h"
#include "score/score.h"

/* Visibility after bounces against path-traced truths, between surfaces of one albedo. What counts is in band: where
 * visibility is below .995. */

enum { W = 240, H = 135, SPP = 128 };

/* A scene all of whose surfaces have one albedo, with its truths. */
struct still {
    struct aob_rig rig;
    struct aob_visibility visibility;
    struct aob_incident bounced;
    double radius;
};

static void still_init(struct still *still, const char *scene, const char *view, float albedo, double radius)
{
    const struct aob_scene_info *info = aob_scene_find(scene);
    struct aob_mesh mesh = {0};
    struct aob_error error = {{0}};
    *still = (struct still){.radius = radius};
    info->build(&mesh);
    if (!mesh.materials)
        aob_mesh_paint(
            &mesh, (struct aob_material){.base_colour = {0.1f}, .roughness = 1}); /* a table, no triangle */
    for (size_t m = 0; m < mesh.material_count; m++)
        mesh.materials[m] = (struct aob_material){.base_colour = {albedo, albedo, albedo}, .roughness = 1};
    aob_rig_init(&still->rig, &mesh, &aob_scene_view(info, view)->camera, W, H, 0);
    aob_mesh_finish(&mesh);
    const struct aob_visibility_term term = {.radius = radius};
    const struct aob_visibility_desc visible = {.terms = &term, .term_count = 1, .spp = SPP};
    const struct aob_incident_desc incident = {.radius = radius, .bounces = 8, .spp = SPP};
    const struct aob_rig *rig = &still->rig;
    if (!aob_tracer_visibility(rig->tracer, &rig->camera, &rig->hits, &visible, &still->visibility, &error) ||
        !aob_tracer_incident(rig->tracer, &rig->camera, &rig->hits, &incident, &still->bounced, &error))
        fail_msg("%s", error.text);
}

static void still_finish(struct still *still)
{
    aob_visibility_finish(&still->visibility);
    aob_incident_finish(&still->bounced);
    aob_rig_finish(&still->rig);
}

/* RMSE in band of an estimate to the path-traced light; NULL: of the fit, given the true visibility. */
static double error_of(const struct still *still, const float *estimate, int stride, float albedo)
{
    double square = 0;
    size_t count = 0;
    for (int i = 0; i < W * H; i++) {
        double v = (double)still->visibility.ao[i];
        if (still->rig.hits.primitive[i] == AOB_NO_PRIMITIVE || v >= AOB_BAND_LIMIT)
            continue;
        double e = estimate ? (double)estimate[i * stride] : aob_effect_bounced(v, (double)albedo);
        square += pow(e - (double)still->bounced.rgb[i][0], 2);
        count++;
    }
    assert_true(count > 500);
    return sqrt(square / (double)count);
}

/* The fit with the true visibility has at most .35 of the error of that visibility at albedo .5 and .8. */
static void test_fit_of_true_visibility(void **state)
{
    (void)state;
    static const char *const scenes[][2] = {{"corner", "front"}, {"cornell", "front"}, {"atrium", "nave"}};
    for (size_t s = 0; s < AOB_COUNT(scenes); s++)
        for (int a = 0; a < 2; a++) {
            const float albedo = a ? 0.8f : 0.5f;
            struct still still;
            still_init(&still, scenes[s][0], scenes[s][1], albedo, s == 1 ? 0.5 : 1);
            double plain = error_of(&still, still.visibility.ao, 1, albedo),
                   fit = error_of(&still, NULL, 1, albedo);
            printf("%s R=%g albedo %g: plain %.4f, fit %.4f, share %.3f\n", scenes[s][0], still.radius,
                   (double)albedo, plain, fit, fit / plain);
            assert_true(fit <= 0.35 * plain);
            still_finish(&still);
        }
}

/* gtao's output over its own plain visibility: at most these shares of the error. */
static void test_gtao(void **state)
{
    (void)state;
    static const struct {
        const char *scene, *view;
        float albedo;
        double radius, share;
    } rows[] = {{"corner", "front", 0.8f, 1, 0.5},  {"cornell", "front", 0.8f, 0.5, 0.5},
                {"atrium", "nave", 0.8f, 1, 0.65},  {"atrium", "aisle", 0.8f, 1, 0.65},
                {"corner", "front", 0.2f, 1, 1.05}, {"cornell", "front", 0.2f, 0.5, 1.05},
                {"atrium", "nave", 0.2f, 1, 1.05}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    float *ao = AOB_NEW_ARRAY(float, W *H), *rgb = AOB_NEW_ARRAY(float, 3 * W * H);
    for (size_t r = 0; r < AOB_COUNT(rows); r++) {
        struct still still;
        char params[80];
        still_init(&still, rows[r].scene, rows[r].view, rows[r].albedo, rows[r].radius);
        snprintf(params, sizeof params, "radius=%g slices=9 steps=12 blur=0", rows[r].radius);
        aob_rig_run_outputs(&still.rig, gpu, "gtao", params, AOB_FETCH_SAMPLED,
                            (float *[AOB_OUTPUT_COUNT]){ao, [AOB_OUT_VISIBILITY_RGB] = rgb});
        double plain = error_of(&still, ao, 1, 0), bounced = error_of(&still, rgb, 3, 0);
        printf("%s %s R=%g albedo %g: plain %.4f, bounced %.4f, share %.3f of %g\n", rows[r].scene,
               rows[r].view, rows[r].radius, (double)rows[r].albedo, plain, bounced, bounced / plain,
               rows[r].share);
        assert_true(bounced <= rows[r].share * plain);
        still_finish(&still);
    }
    free(ao);
    free(rgb);
    aob_gpu_close(gpu);
}

/* The device's polynomial is the one of the text, of each channel's own diffuse albedo: base colour in 8 bits of its root, times
 * what is no metal. */
static void test_channels_and_metal(void **state)
{
    (void)state;
    const struct aob_material materials[] = {{.base_colour = {0.9f, 0.5f, 0.1f}, .roughness = 1},
                                             {.base_colour = {0.9f, 0.5f, 0.1f}, .metalness = 0.4f},
                                             {.base_colour = {1, 1, 1}, .metalness = 1}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    float ao[64 * 36], rgb[64 * 36][3];
    for (size_t m = 0; m < AOB_COUNT(materials); m++) {
        struct aob_mesh mesh = {0};
        struct aob_rig rig;
        aob_mesh_paint(&mesh, materials[m]);
        aob_scene_find("corner")->build(&mesh);
        aob_rig_init(&rig, &mesh, &aob_scene_find("corner")->views[0].camera, 64, 36, 0);
        aob_mesh_finish(&mesh);
        aob_rig_run_outputs(&rig, gpu, "gtao", "radius=1", AOB_FETCH_STORAGE,
                            (float *[AOB_OUTPUT_COUNT]){ao, [AOB_OUT_VISIBILITY_RGB] = rgb[0]});
        for (int i = 0; i < 64 * 36; i++)
            for (int c = 0; c < 3; c++) {
                double root = round(255 * sqrt((double)materials[m].base_colour[c])) / 255;
                double diffuse = root * root * (1 - round(255 * (double)materials[m].metalness) / 255);
                assert_near(rgb[i][c], aob_effect_bounced((double)ao[i], diffuse), 6e-4); /* half floats */
            }
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_fit_of_true_visibility),
                                       cmocka_unit_test(test_gtao),
                                       cmocka_unit_test(test_channels_and_metal)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
