#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "score/score.h"
#include "rig.h"

/* A surface that is nearer to the eye than the radius. Most of its ball lies outside the image, where nothing is known;
 * what the image shows of it must be found as well as from afar. The scene is only what the image shows, so that the
 * ray-traced truth knows no more than the image does. */

enum { W = 480, H = 270, SPP = 512 };
#define HEIGHT 0.3 /* of the eye over the floor, and before the wall */

/* Adds the part of a plane (`axis` 1: y = 0, 2: z = 0) that rows `from` to `to` of the image show. */
static void add_shown(struct aob_mesh *mesh, const struct aob_camera *camera, int axis, double from,
                      double to)
{
    struct aob_projection projection = aob_camera_projection(camera, W, H, 0);
    const double corners[4][2] = {{0, from}, {0, to}, {W, to}, {W, from}};
    uint32_t at[4];
    for (int i = 0; i < 4; i++) {
        struct aob_vec3 origin, way;
        aob_camera_ray(camera, &projection, corners[i][0], corners[i][1], &origin, &way);
        double share = axis == 1 ? -origin.y / way.y : -origin.z / way.z;
        at[i] = aob_mesh_add_vertex(mesh, aob_vec_add(origin, aob_vec_scale(way, share)));
    }
    aob_mesh_add_triangle(mesh, at[0], at[1], at[2]);
    aob_mesh_add_triangle(mesh, at[0], at[2], at[3]);
}

/* Floor and wall, and their crease in the middle of the image. */
static void show_crease(struct aob_rig *rig)
{
    struct aob_mesh mesh = {0};
    struct aob_camera camera = {.eye = {0, HEIGHT, HEIGHT}, .fov_deg = 60};
    add_shown(&mesh, &camera, 2, 0, H / 2.0);
    add_shown(&mesh, &camera, 1, H / 2.0, H);
    aob_rig_init(rig, &mesh, &camera, W, H, 0);
    aob_mesh_finish(&mesh);
}

static double band_rmse(const struct aob_rig *rig, struct aob_gpu *gpu, const char *technique,
                        const char *params, const float *truth)
{
    float *ao = AOB_NEW_ARRAY(float, W *H);
    double sum = 0;
    size_t count = 0;
    aob_rig_run(rig, gpu, technique, params, AOB_FETCH_STORAGE, ao);
    for (int i = 0; i < W * H; i++)
        if (truth[i] < AOB_BAND_LIMIT) {
            sum += pow((double)ao[i] - (double)truth[i], 2);
            count++;
        }
    free(ao);
    assert_true(count > W * H / 2); /* the eye is among it */
    return sqrt(sum / (double)count);
}

/* With the cosine and a hard cutoff, so that one truth serves all. The bars are those of the whole crease seen from afar
 * (test_gtao.c, test_hbao.c, test_ray_march.c), at the same samples. */
static const struct {
    const char *technique, *params;
    double bar;
} rows[] = {{"gtao", "falloff=0 blur=0 slices=9 steps=12", 0.02},
            {"gtao", "falloff=0 blur=0 slices=9 steps=24", 0.012},
            {"gtao", "falloff=0 blur=0 slices=16 steps=64", 0.008},
            {"hbao", "attenuation=0 weighting=cosine blur=0 directions=32 steps=16", 0.05},
            {"ray_march", "attenuation=0 weighting=cosine directions=16 rays=8 steps=24", 0.02}};

static void test_near_crease(void **state)
{
    (void)state;
    static const double radii[] = {0.5, 1, 2, 100};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float *truth = AOB_NEW_ARRAY(float, W *H);
    show_crease(&rig);
    for (size_t r = 0; r < AOB_COUNT(radii); r++)
        for (size_t s = 0; s < AOB_COUNT(rows); s++) {
            char params[120];
            snprintf(params, sizeof params, "radius=%g %s", radii[r], rows[s].params);
            if (s == 0 && radii[r] <= 1) /* nothing that is shown lies farther apart */
                aob_rig_definition(&rig, "gtao", params, SPP, truth);
            double rmse = band_rmse(&rig, gpu, rows[s].technique, params, truth);
            printf("crease %g away, R=%g %s %s: in-band RMSE %.4f (bar %.3f)\n", HEIGHT * M_SQRT2, radii[r],
                   rows[s].technique, rows[s].params, rmse, rows[s].bar);
            assert_true(rmse <= rows[s].bar);
        }
    free(truth);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_near_crease)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
