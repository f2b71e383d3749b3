/* Ambient occlusion volumes where the visibility is known without a ray: closed forms, and open ground. */
#include "check.h"
#include <math.h>
#include "base/memory.h"
#include "score/oracle_score.h"
#include "reference/oracle.h"
#include "rig.h"

enum { W = 160, H = 90, PIXELS = W * H };

/* Closed form O2. The walls are single quads of 40 m that pass the eye. */
static void test_corner_is_exact(void **state)
{
    (void)state;
    static const double radii[] = {0.5, 1, 1.37, 2};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    for (int view = 0; view < 2; view++) {
        aob_rig_scene(&rig, "corner", view ? "far" : "front", W, H, 0);
        for (size_t r = 0; r < AOB_COUNT(radii); r++) {
            double rmse[2];
            for (int fine = 0; fine < 2; fine++) {
                char params[80];
                snprintf(params, sizeof params, "radius=%g sides=%d divisor=1", radii[r], fine ? 16 : 8);
                rmse[fine] =
                    aob_rig_corner_rmse(&rig, gpu, "ao_volumes", params, aob_oracle_corner, radii[r]);
            }
            printf("ao_volumes on corner/%s R=%g: in-band RMSE %.6f with 8 sides, %.6f with 16\n",
                   view ? "far" : "front", radii[r], rmse[0], rmse[1]);
            assert_true(rmse[0] <= 0.002);
            assert_true(rmse[1] <= rmse[0]);
        }
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* The other listed scenes with a closed form, in each of their views. The ground is a quad of 40 m whose plane no pixel
 * hits exactly. */
static void test_closed_forms(void **state)
{
    (void)state;
    static const struct {
        const char *scene;
        size_t pixels; /* with a closed form, at least */
    } rows[] = {{"plane", 7000}, {"wall", 5000}, {"sheet", 5000}, {"room", PIXELS}, {"disc", 1000}};
    const double radius = 0.5;
    static float ao[PIXELS];
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        const struct aob_scene_info *info = aob_scene_find(rows[i].scene);
        for (size_t v = 0; v < info->view_count; v++) {
            struct aob_rig rig;
            struct aob_oracle_score score;
            aob_rig_scene(&rig, rows[i].scene, info->views[v].name, W, H, 0);
            aob_rig_run(&rig, gpu, "ao_volumes", "radius=0.5 divisor=1", AOB_FETCH_SAMPLED, ao);
            const struct aob_oracle_desc desc = {.oracle = aob_oracle_find(rows[i].scene),
                                                 .camera = &rig.camera,
                                                 .gbuffer = &rig.gbuffer,
                                                 .radius = radius};
            aob_oracle_score(&desc, ao, &score);
            printf("ao_volumes on %s/%s R=%g: RMSE %.6f to the closed form over %zu pixels\n", rows[i].scene,
                   info->views[v].name, radius, score.rmse, score.pixels);
            assert_true(score.pixels >= rows[i].pixels);
            assert_true(score.rmse <= 0.002);
            aob_rig_finish(&rig);
        }
    }
    aob_gpu_close(gpu);
}

/* One quad of any size is open ground, wherever the eye is: a pixel is in its plane, to rounding. */
static void test_ground_is_open(void **state)
{
    (void)state;
    static const double sides[] = {6, 40, 3000};
    static float ao[PIXELS];
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    for (size_t s = 0; s < AOB_COUNT(sides); s++)
        for (int k = 0; k < 8; k++) {
            struct aob_rig rig;
            struct aob_mesh mesh = {0};
            double half = sides[s] / 2, off = half * 0.07 * k;
            struct aob_camera camera = {.eye = {off + 0.31 * k, 0.11 + 0.3 * k, off - 0.17 * k},
                                        .target = {off, -0.05 * k, off + 0.01},
                                        .fov_deg = 30 + 10 * k};
            float least = 1;
            size_t ground = 0;
            aob_mesh_add_quad(&mesh, aob_vec(-half, 0, -half), aob_vec(0, 0, sides[s]),
                              aob_vec(sides[s], 0, 0));
            aob_rig_init(&rig, &mesh, &camera, W, H, 0);
            aob_rig_run(&rig, gpu, "ao_volumes", "radius=0.5 divisor=1", AOB_FETCH_SAMPLED, ao);
            for (int i = 0; i < PIXELS; i++) {
                ground += rig.hits.depth[i] > 0;
                least = fminf(least, ao[i]);
            }
            printf("ground of %g units, eye %d: visibility at least %.6f over %zu pixels\n", sides[s], k,
                   (double)least, ground);
            assert_true(ground > 300);
            assert_true(least >= 1 - 1e-6F);
            aob_rig_finish(&rig);
            aob_mesh_finish(&mesh);
        }
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_corner_is_exact),
                                       cmocka_unit_test(test_closed_forms),
                                       cmocka_unit_test(test_ground_is_open)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
