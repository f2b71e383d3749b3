/* What techniques make of an open floor whose normals lean away from the viewer: it stays open. */
#include "gbuffer/leaning_floor.h"
#include "rig.h"

/* The techniques that leave every open plane open. crytek_ssao is one half there by design, and ao_volumes needs
 * triangles. */
static const char *const techniques[] = {"gtao",      "hbao",           "alchemy", "volumetric_obscurance",
                                         "ray_march", "starcraft2_ssao"};

/* A rig of the capture's depth and normals, without geometry. */
static void rig_of_capture(struct aob_rig *rig, const struct aob_capture *capture)
{
    struct aob_mesh mesh = {0};
    *rig = (struct aob_rig){.camera = capture->camera, .width = FLOOR_W, .height = FLOOR_H};
    struct aob_projection view = aob_camera_projection(&capture->camera, FLOOR_W, FLOOR_H, 0);
    aob_gbuffer_init(&rig->gbuffer, &capture->hits, &view, 0);
    aob_mesh_add_quad(&mesh, aob_vec(0, 0, -1), aob_vec(1, 0, 0), aob_vec(0, 1, 0));
    aob_geometry_init(&rig->geometry, &mesh, &capture->camera);
    aob_mesh_finish(&mesh);
}

static void test_open_floor(void **state)
{
    static const double leans[] = {0, 5, 20};
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-osmesa");
    float *ao = AOB_NEW_ARRAY(float, FLOOR_COUNT);
    for (size_t k = 0; k < AOB_COUNT(leans); k++)
        for (size_t t = 0; t < AOB_COUNT(techniques); t++) {
            struct aob_capture capture = leaning_floor(leans[k]);
            struct aob_rig rig;
            double least = 1;
            rig_of_capture(&rig, &capture);
            aob_rig_run(&rig, gpu, techniques[t], "radius=0.05", AOB_FETCH_STORAGE, ao);
            for (int i = 0; i < FLOOR_COUNT; i++)
                least = fmin(least, (double)ao[i]);
            printf("lean %g, %s: at least %.4f\n", leans[k], techniques[t], least);
            assert_true(least >= 0.98);
            aob_rig_finish(&rig);
            aob_capture_finish(&capture);
        }
    free(ao);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_open_floor)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
