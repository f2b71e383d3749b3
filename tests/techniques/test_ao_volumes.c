#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "score/score.h"
#include "rig.h"

enum { W = 160, H = 90, PIXELS = W * H, SPP = 1024 };

/* Every triangle cut evenly into smaller ones, no side longer than `size`. */
static struct aob_mesh cut(const struct aob_mesh *mesh, double size)
{
    struct aob_mesh out = {0};
    for (size_t t = 0; t < mesh->triangle_count; t++) {
        struct aob_vec3 p[3];
        for (int k = 0; k < 3; k++)
            p[k] = mesh->positions[mesh->triangles[t][k]];
        struct aob_vec3 u = aob_vec_sub(p[1], p[0]), v = aob_vec_sub(p[2], p[0]);
        double longest = fmax(aob_vec_length(u), fmax(aob_vec_length(v), aob_vec_length(aob_vec_sub(v, u))));
        int n = (int)ceil(longest / size);
        uint32_t first = (uint32_t)out.vertex_count;
        for (int i = 0; i <= n; i++)
            for (int j = 0; j <= n; j++)
                aob_mesh_add_vertex(&out, aob_vec_add(p[0], aob_vec_add(aob_vec_scale(u, (double)i / n),
                                                                        aob_vec_scale(v, (double)j / n))));
        for (int i = 0; i < n; i++)
            for (int j = 0; i + j < n; j++) {
                uint32_t a = first + (uint32_t)(i * (n + 1) + j), b = a + (uint32_t)n + 1;
                aob_mesh_add_triangle(&out, a, b, a + 1);
                if (i + j + 2 <= n)
                    aob_mesh_add_triangle(&out, b, b + 1, a + 1);
            }
    }
    return out;
}

struct score {
    double band_rmse, bias, brighter_share, brighter_most, se;
};

static struct score compare(const float *ao, const struct aob_visibility *truth)
{
    struct score s = {0};
    size_t band = 0;
    for (int i = 0; i < PIXELS; i++)
        s.se += (double)truth->se[i] * (double)truth->se[i] / PIXELS;
    s.se = sqrt(s.se);
    for (int i = 0; i < PIXELS; i++) {
        double e = (double)ao[i] - (double)truth->ao[i];
        s.bias += e / PIXELS;
        s.brighter_share += (e > 3 * s.se) / (double)PIXELS;
        s.brighter_most = fmax(s.brighter_most, e);
        if ((double)truth->ao[i] < AOB_BAND_LIMIT) {
            s.band_rmse += e * e;
            band++;
        }
    }
    assert_true(band > 500); /* a view that shows no band proves nothing */
    s.band_rmse = sqrt(s.band_rmse / (double)band);
    return s;
}

static void trace(const struct aob_rig *rig, double radius, struct aob_visibility *truth)
{
    const struct aob_visibility_term term = {.radius = radius};
    const struct aob_visibility_desc desc = {.terms = &term, .term_count = 1, .spp = SPP};
    struct aob_error error;
    if (!aob_tracer_visibility(rig->tracer, &rig->camera, &rig->hits, &desc, truth, &error))
        fail_msg("%s", error.text);
}

static struct score score_mesh(struct aob_gpu *gpu, const struct aob_mesh *mesh,
                               const struct aob_camera *camera, double radius, float *ao)
{
    struct aob_rig rig;
    struct aob_visibility truth;
    char params[80];
    snprintf(params, sizeof params, "radius=%g divisor=1", radius);
    aob_rig_init(&rig, mesh, camera, W, H, 0);
    trace(&rig, radius, &truth);
    aob_rig_run(&rig, gpu, "ao_volumes", params, AOB_FETCH_SAMPLED, ao);
    struct score s = compare(ao, &truth);
    aob_visibility_finish(&truth);
    aob_rig_finish(&rig);
    return s;
}

/* One quad a wall, and cut at a quarter of the radius: the same image, and the ray tracer's. */
static void check_whole_and_cut(const char *name, const struct aob_mesh *mesh,
                                const struct aob_camera *camera, double radius)
{
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    static float whole[PIXELS], parts[PIXELS];
    struct aob_mesh fine = cut(mesh, radius / 4);
    struct score a = score_mesh(gpu, mesh, camera, radius, whole);
    struct score b = score_mesh(gpu, &fine, camera, radius, parts);
    double apart = 0;
    for (int i = 0; i < PIXELS; i++)
        apart += pow((double)whole[i] - (double)parts[i], 2) / PIXELS;
    printf("ao_volumes on %s R=%g: in-band RMSE %.4f whole, %.4f cut into %zu triangles (tracer SE %.4f); "
           "images %.1e apart\n",
           name, radius, a.band_rmse, b.band_rmse, fine.triangle_count, a.se, sqrt(apart));
    assert_true(a.band_rmse <= 0.01);
    assert_true(b.band_rmse <= 0.01);
    assert_true(sqrt(apart) <= 0.002);
    aob_mesh_finish(&fine);
    aob_gpu_close(gpu);
}

static void test_cornell(void **state)
{
    (void)state;
    const struct aob_scene_info *info = aob_scene_find("cornell");
    struct aob_mesh mesh = {0};
    /* The listed view has pixels exactly on the room's edges, where a ray starts on either side of the other wall. */
    struct aob_camera camera = aob_scene_view(info, NULL)->camera;
    camera.eye = aob_vec(0.0131, 1.0072, 3.4);
    info->build(&mesh);
    check_whole_and_cut("cornell", &mesh, &camera, 0.25);
    check_whole_and_cut("cornell", &mesh, &camera, 0.5);
    aob_mesh_finish(&mesh);
}

static struct aob_mesh box_on_plane(void)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-4, 0, -4), aob_vec(0, 0, 8), aob_vec(8, 0, 0));
    aob_mesh_add_box(&mesh, aob_vec(-1, 0, -1), aob_vec(1, 2, 1), 20);
    return mesh;
}
static const struct aob_camera box_camera = {.eye = {2, 3, 4}, .target = {0, 0.7, 0}, .fov_deg = 50};

static void test_box_on_plane(void **state)
{
    (void)state;
    struct aob_mesh mesh = box_on_plane();
    check_whole_and_cut("box on a plane", &mesh, &box_camera, 1);
    check_whole_and_cut("box on a plane", &mesh, &box_camera, 2);
    aob_mesh_finish(&mesh);
}

/* falloff 1: each triangle counts by its distance. The tracer computes the same by the triangles that its rays meet, so
 * the two agree with whole walls and with cut ones, while the two images differ. */
static void check_tapered(struct aob_gpu *gpu, const char *name, const struct aob_mesh *mesh,
                          const struct aob_camera *camera, double radius, double bar)
{
    static float ao[2][PIXELS], definition[PIXELS];
    double rmse[2] = {0}, apart = 0;
    char params[80];
    snprintf(params, sizeof params, "radius=%g falloff=1 divisor=1", radius);
    for (int fine = 0; fine < 2; fine++) {
        struct aob_mesh pieces = fine ? cut(mesh, radius / 4) : (struct aob_mesh){0};
        struct aob_rig rig;
        aob_rig_init(&rig, fine ? &pieces : mesh, camera, W, H, 0);
        aob_rig_run(&rig, gpu, "ao_volumes", params, AOB_FETCH_SAMPLED, ao[fine]);
        aob_rig_definition(&rig, "ao_volumes", params, SPP, definition);
        for (int i = 0; i < PIXELS; i++)
            rmse[fine] += pow((double)ao[fine][i] - (double)definition[i], 2) / PIXELS;
        aob_rig_finish(&rig);
        aob_mesh_finish(&pieces);
    }
    for (int i = 0; i < PIXELS; i++)
        apart += pow((double)ao[0][i] - (double)ao[1][i], 2) / PIXELS;
    printf(
        "ao_volumes, falloff 1, on %s R=%g: RMSE to its definition %.4f whole, %.4f cut; images %.3f apart\n",
        name, radius, sqrt(rmse[0]), sqrt(rmse[1]), sqrt(apart));
    assert_true(sqrt(rmse[0]) <= bar && sqrt(rmse[1]) <= bar);
    assert_true(sqrt(apart) > 2 * bar);
}

static void test_tapered_is_its_definition(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    const struct aob_scene_info *room = aob_scene_find("cornell");
    struct aob_camera camera = aob_scene_view(room, NULL)->camera;
    struct aob_mesh corner = {0}, cornell = {0}, box = box_on_plane();
    /* `corner` near the crease: whole walls of 40 m would be cut into a million triangles. */
    aob_mesh_add_quad(&corner, aob_vec(-4, 0, 0), aob_vec(0, 0, 6), aob_vec(8, 0, 0));
    aob_mesh_add_quad(&corner, aob_vec(-4, 0, 0), aob_vec(8, 0, 0), aob_vec(0, 6, 0));
    check_tapered(gpu, "corner", &corner,
                  &(struct aob_camera){.eye = {0, 2, 4}, .target = {0, 0.8, 0}, .fov_deg = 60}, 1, 0.005);
    check_tapered(gpu, "box on a plane", &box, &box_camera, 1, 0.005);
    camera.eye = aob_vec(0.0131, 1.0072, 3.4);
    room->build(&cornell);
    check_tapered(gpu, "cornell", &cornell, &camera, 0.25, 0.01);
    aob_mesh_finish(&corner);
    aob_mesh_finish(&cornell);
    aob_mesh_finish(&box);
    aob_gpu_close(gpu);
}

/* Sheets nearer to each other than half the radius hide behind one another, and each counts. */
static void test_stacked_sheets_darken(void **state)
{
    (void)state;
    static float ao[PIXELS];
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    const struct aob_scene_info *plates = aob_scene_find("plates");
    struct aob_mesh mesh = {0};
    plates->build(&mesh);
    struct score s = score_mesh(gpu, &mesh, &aob_scene_view(plates, NULL)->camera, 0.8, ao);
    printf("ao_volumes on sheets .3 apart, R=.8: bias %.4f, %.2f %% of pixels brighter by 3 SE (%.4f), at "
           "most %.4f\n",
           s.bias, 100 * s.brighter_share, s.se, s.brighter_most);
    assert_true(s.bias <= -0.01);
    assert_true(s.brighter_share <= 0.01);
    assert_true(s.brighter_most <= 0.03);
    aob_mesh_finish(&mesh);
    aob_gpu_close(gpu);
}

static bool same_surface(const struct aob_rig *a, const struct aob_rig *b, int i)
{
    return a->hits.depth[i] == b->hits.depth[i] &&
           memcmp(a->hits.normal[i], b->hits.normal[i], sizeof a->hits.normal[i]) == 0;
}

/* An occluder within the scene's bounds: pixels of the same depth and normal do not brighten, many darken. */
static void test_occluder_never_brightens(void **state)
{
    (void)state;
    static float before[PIXELS], after[PIXELS];
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    for (int falloff = 0; falloff < 2; falloff++)
        for (int where = 0; where < 3; where++) {
            struct aob_mesh mesh = box_on_plane();
            struct aob_rig plain, more;
            char params[80];
            size_t same = 0, darker = 0;
            snprintf(params, sizeof params, "radius=1 falloff=%d divisor=1", falloff);
            aob_rig_init(&plain, &mesh, &box_camera, W, H, 0);
            aob_mesh_add_box(&mesh, aob_vec(0.5 * where - 1, 0.4 * where, 1.2),
                             aob_vec(0.5 * where - 0.4, 0.4 * where + 0.6, 1.7), 30);
            aob_rig_init(&more, &mesh, &box_camera, W, H, 0);
            aob_rig_run(&plain, gpu, "ao_volumes", params, AOB_FETCH_SAMPLED, before);
            aob_rig_run(&more, gpu, "ao_volumes", params, AOB_FETCH_SAMPLED, after);
            for (int i = 0; i < PIXELS; i++)
                if (same_surface(&plain, &more, i)) {
                    assert_true(after[i] <= before[i] + 1e-6F);
                    same++;
                    darker += after[i] < before[i] - 0.01F;
                }
            assert_true(same > PIXELS / 2 && darker > 50);
            aob_rig_finish(&plain);
            aob_rig_finish(&more);
            aob_mesh_finish(&mesh);
        }
    aob_gpu_close(gpu);
}

/* Half and quarter size sampled up: within the range of the low pixels, so near the full image, and cheaper. */
static void test_divided_is_near_the_full_image(void **state)
{
    (void)state;
    static float full[PIXELS], low[PIXELS];
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    aob_rig_scene(&rig, "cornell", NULL, W, H, 0);
    aob_rig_run(&rig, gpu, "ao_volumes", "radius=0.5 divisor=1", AOB_FETCH_SAMPLED, full);
    for (int divisor = 2; divisor <= 4; divisor *= 2) {
        char params[80];
        double sum = 0;
        snprintf(params, sizeof params, "radius=0.5 divisor=%d", divisor);
        aob_rig_run(&rig, gpu, "ao_volumes", params, AOB_FETCH_SAMPLED, low);
        for (int i = 0; i < PIXELS; i++)
            sum += pow((double)low[i] - (double)full[i], 2) / PIXELS;
        printf("ao_volumes on cornell, divisor %d against full: RMSE %.4f\n", divisor, sqrt(sum));
        assert_true(sqrt(sum) <= 0.015 * divisor);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_cornell),
                                       cmocka_unit_test(test_box_on_plane),
                                       cmocka_unit_test(test_tapered_is_its_definition),
                                       cmocka_unit_test(test_stacked_sheets_darken),
                                       cmocka_unit_test(test_occluder_never_brightens),
                                       cmocka_unit_test(test_divided_is_near_the_full_image)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
