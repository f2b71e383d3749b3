#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "frame/raster.h"
#include "score/score.h"
#include "rig.h"

static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};

static void build(const char *scene, struct aob_mesh *mesh)
{
    *mesh = (struct aob_mesh){0};
    aob_scene_find(scene)->build(mesh);
}

static struct aob_raster_difference compare(const struct aob_rig *rig, const struct aob_mesh *mesh,
                                            const char *backend, const char *what, struct aob_hits *drawn)
{
    struct aob_error error = {{0}};
    struct aob_raster_difference d;
    struct aob_gpu *gpu = aob_rig_gpu(backend);
    if (!aob_raster_draw(gpu, mesh, &rig->camera, &rig->gbuffer.projection, drawn, &error))
        fail_msg("%s", error.text);
    aob_gpu_close(gpu);
    aob_raster_compare(&rig->hits, drawn, &d);
    printf("%s %s: %zu of %zu pixels other, %zu off edges; depth rmse %.2e, max %.2e, relative %.2e; normal "
           "%.2e\n",
           what, backend, d.other, d.pixels, d.off_edge, d.depth_rmse, d.depth_max, d.depth_relative_max,
           d.normal_max);
    return d;
}

/* Where a ray grazes a plane, the rounding of the ray's direction moves the hit by 1/cosine as much. */
static void expect_depths(const struct aob_rig *rig, const struct aob_hits *drawn)
{
    const struct aob_projection *view = &rig->gbuffer.projection;
    double worst = 0;
    for (int i = 0; i < drawn->width * drawn->height; i++) {
        if (rig->hits.primitive[i] != drawn->primitive[i] || drawn->primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        const float *n = rig->hits.normal[i];
        double x = (i % drawn->width + .5 - view->cx) * view->sx,
               y = (view->cy - i / drawn->width - .5) * view->sy;
        double spread = view->perspective ? sqrt(x * x + y * y + 1) : 1;
        double along = view->perspective ? (double)n[0] * x + (double)n[1] * y - (double)n[2] : (double)n[2];
        double e = fabs((double)drawn->depth[i] / (double)rig->hits.depth[i] - 1);
        worst = fmax(worst, e * fabs(along) / spread);
    }
    printf("  relative depth error x cosine: %.2e\n", worst);
    assert_true(worst <= 0x1p-20);
}

/* Distance in pixels from a pixel's centre to the nearest line along an edge of a triangle, in double precision. */
static double edge_distance(const struct aob_rig *rig, const struct aob_mesh *mesh, uint32_t triangle, int x,
                            int y)
{
    const struct aob_projection *view = &rig->gbuffer.projection;
    struct aob_frame_axes axes = aob_camera_axes(&rig->camera);
    struct aob_vec3 q[3], centre = {x + 0.5, y + 0.5, 1};
    double nearest = INFINITY;
    for (int k = 0; k < 3; k++) { /* homogeneous image positions: corners behind the eye are no exception */
        struct aob_vec3 v = aob_vec_sub(mesh->positions[mesh->triangles[triangle][k]], rig->camera.eye);
        double w = view->perspective ? -aob_vec_dot(v, axes.back) : 1;
        q[k] = aob_vec(aob_vec_dot(v, axes.right) / view->sx + view->cx * w,
                       -aob_vec_dot(v, axes.up) / view->sy + view->cy * w, w);
    }
    for (int k = 0; k < 3; k++) {
        struct aob_vec3 line = aob_vec_cross(q[k], q[(k + 1) % 3]);
        nearest = fmin(nearest, fabs(aob_vec_dot(line, centre)) / hypot(line.x, line.y));
    }
    return nearest;
}

/* A pixel whose neighbours all show one primitive may still see another: a triangle thinner than a pixel, which the
 * rasteriser's grid of 1/256 pixel moved over its centre or off it. */
static size_t unexplained(const struct aob_rig *rig, const struct aob_mesh *mesh,
                          const struct aob_hits *drawn)
{
    int w = drawn->width, h = drawn->height;
    const uint32_t *seen = rig->hits.primitive;
    size_t count = 0;
    for (int i = 0; i < w * h; i++) {
        int x = i % w, y = i / w;
        bool edge = seen[i] == drawn->primitive[i];
        for (int k = 0; k < 9 && !edge; k++) {
            int u = x + k % 3 - 1, v = y + k / 3 - 1;
            edge = u >= 0 && v >= 0 && u < w && v < h && seen[v * w + u] != seen[i];
        }
        double sliver = INFINITY;
        if (!edge && seen[i] != AOB_NO_PRIMITIVE)
            sliver = edge_distance(rig, mesh, seen[i], x, y);
        if (!edge && drawn->primitive[i] != AOB_NO_PRIMITIVE)
            sliver = fmin(sliver, edge_distance(rig, mesh, drawn->primitive[i], x, y));
        count += !edge && sliver > 1.0 / 128;
    }
    return count;
}

static void expect_alike(const struct aob_rig *rig, const struct aob_mesh *mesh, const struct aob_hits *drawn,
                         const struct aob_raster_difference *d)
{
    expect_depths(rig, drawn);
    assert_true(d->other <= d->pixels / 100);
    assert_int_equal(unexplained(rig, mesh, drawn), 0);
    assert_true(d->normal_max <= 1e-6);
}

static void test_atrium_on_every_backend(void **state)
{
    (void)state;
    struct aob_mesh mesh;
    struct aob_rig rig;
    build("atrium", &mesh);
    aob_rig_scene(&rig, "atrium", NULL, 640, 360, 0);
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_hits drawn;
        struct aob_raster_difference d = compare(&rig, &mesh, backends[b], "atrium", &drawn);
        expect_alike(&rig, &mesh, &drawn, &d);
        assert_int_equal(d.off_edge, 0);
        aob_hits_finish(&drawn);
    }
    aob_rig_finish(&rig);
    aob_mesh_finish(&mesh);
}

/* Every view of every procedural scene, with a guard band that moves the centre. */
static void test_every_procedural_scene(void **state)
{
    (void)state;
    for (const struct aob_scene_info *const *scene = aob_scenes; *scene; scene++)
        for (size_t v = 0; (*scene)->build && v < (*scene)->view_count; v++) {
            struct aob_mesh mesh;
            struct aob_rig rig;
            struct aob_hits drawn;
            char what[64];
            snprintf(what, sizeof what, "%s/%s", (*scene)->name, (*scene)->views[v].name);
            build((*scene)->name, &mesh);
            aob_rig_scene(&rig, (*scene)->name, (*scene)->views[v].name, 320, 180, 8);
            struct aob_raster_difference d = compare(&rig, &mesh, "vulkan", what, &drawn);
            expect_alike(&rig, &mesh, &drawn, &d);
            if (strcmp((*scene)->name, "grass") != 0) /* its far blades are thinner than a pixel */
                assert_int_equal(d.off_edge, 0);
            aob_hits_finish(&drawn);
            aob_rig_finish(&rig);
            aob_mesh_finish(&mesh);
        }
}

static void test_orthographic(void **state)
{
    (void)state;
    const struct aob_camera camera = {
        .eye = {3, 4, 8}, .target = {0, 1, 0}, .fov_deg = 60, .ortho_height = 6};
    struct aob_mesh mesh;
    struct aob_rig rig;
    build("spheres", &mesh);
    aob_rig_init(&rig, &mesh, &camera, 320, 180, 0);
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_hits drawn;
        struct aob_raster_difference d = compare(&rig, &mesh, backends[b], "orthographic spheres", &drawn);
        expect_alike(&rig, &mesh, &drawn, &d);
        aob_hits_finish(&drawn);
    }
    aob_rig_finish(&rig);
    aob_mesh_finish(&mesh);
}

/* The same scene a million units away gives the same image to the last bit but those that its own coordinates lost. */
static void test_far_from_the_origin(void **state)
{
    (void)state;
    struct aob_mesh mesh;
    struct aob_rig rig;
    struct aob_hits drawn;
    build("cornell", &mesh);
    struct aob_camera camera = aob_scene_view(aob_scene_find("cornell"), NULL)->camera;
    const struct aob_vec3 away = {1e6, -3e6, 2e6};
    for (size_t i = 0; i < mesh.vertex_count; i++)
        mesh.positions[i] = aob_vec_add(mesh.positions[i], away);
    camera.eye = aob_vec_add(camera.eye, away);
    camera.target = aob_vec_add(camera.target, away);
    aob_rig_init(&rig, &mesh, &camera, 320, 180, 0);
    struct aob_raster_difference d = compare(&rig, &mesh, "vulkan", "cornell far away", &drawn);
    expect_alike(&rig, &mesh, &drawn, &d);
    aob_hits_finish(&drawn);
    aob_rig_finish(&rig);
    aob_mesh_finish(&mesh);
}

/* Interpolated normals on a mesh that has them, against the ray tracer's. */
static void test_shading_normals(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    struct aob_rig rig;
    struct aob_hits drawn;
    const struct aob_camera camera = {.eye = {0, 1, 3}, .target = {0, 0, 0}, .fov_deg = 50};
    aob_mesh_add_sphere(&mesh, aob_vec(0, 0, 0), 1, 16);
    mesh.normals = AOB_NEW_ARRAY(struct aob_vec3, mesh.vertex_count);
    for (size_t i = 0; i < mesh.vertex_count; i++)
        mesh.normals[i] = aob_vec_normalize(mesh.positions[i]);
    aob_rig_init(&rig, &mesh, &camera, 320, 180, 0);
    struct aob_raster_difference d = compare(&rig, &mesh, "vulkan", "smooth sphere", &drawn);
    expect_alike(&rig, &mesh, &drawn, &d);
    double worst = 0, bend = 0;
    for (size_t i = 0; i < d.pixels; i++)
        for (int c = 0; c < 3 && rig.hits.primitive[i] == drawn.primitive[i]; c++) {
            worst = fmax(worst, fabs((double)drawn.shading[i][c] - (double)rig.hits.shading[i][c]));
            bend = fmax(bend, fabs((double)rig.hits.shading[i][c] - (double)rig.hits.normal[i][c]));
        }
    printf("shading normals: %.2e apart, bent by up to %.2f\n", worst, bend);
    assert_true(bend > 0.1);
    assert_true(worst <= 2e-3);
    aob_hits_finish(&drawn);
    aob_rig_finish(&rig);
    aob_mesh_finish(&mesh);
}

/* A floor at flat angles whose normals lean away: both bend them alike. */
static void test_leaning_normals(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    struct aob_rig rig;
    struct aob_hits drawn;
    const struct aob_camera camera = {.eye = {0, 0.3, 0}, .target = {0, 0.3, -1}, .fov_deg = 50};
    aob_mesh_add_quad(&mesh, aob_vec(-20, 0, 0), aob_vec(40, 0, 0), aob_vec(0, 0, -20));
    mesh.normals = AOB_NEW_ARRAY(struct aob_vec3, mesh.vertex_count);
    for (size_t i = 0; i < mesh.vertex_count; i++)
        mesh.normals[i] = aob_vec_normalize(aob_vec(0.1, 1, -0.3));
    aob_rig_init(&rig, &mesh, &camera, 160, 90, 0);
    compare(&rig, &mesh, "vulkan", "leaning normals", &drawn);
    double worst = 0;
    for (size_t i = 0; i < 160 * 90; i++)
        for (int c = 0; c < 3 && rig.hits.primitive[i] == drawn.primitive[i]; c++)
            worst = fmax(worst, fabs((double)drawn.shading[i][c] - (double)rig.hits.shading[i][c]));
    printf("leaning normals: %.2e apart\n", worst);
    assert_true(worst <= 2e-3);
    aob_hits_finish(&drawn);
    aob_rig_finish(&rig);
    aob_mesh_finish(&mesh);
}

static double score(const struct aob_rig *rig, const struct aob_gbuffer *gbuffer, struct aob_gpu *gpu,
                    const float *truth, double *band)
{
    struct aob_rig view = *rig;
    struct aob_metrics score;
    struct aob_error error = {{0}};
    size_t pixels = (size_t)rig->width * (size_t)rig->height;
    float *ao = AOB_NEW_ARRAY(float, pixels), *depth = AOB_NEW_ARRAY(float, pixels);
    for (int y = 0; y < rig->height; y++)
        memcpy(depth + y * rig->width, rig->gbuffer.depth + (y + rig->guard) * rig->hits.width + rig->guard,
               (size_t)rig->width * sizeof *depth);
    view.gbuffer = *gbuffer;
    aob_rig_run(&view, gpu, "gtao", "radius=0.5 slices=3 steps=6", AOB_FETCH_SAMPLED, ao);
    struct aob_score_desc desc = {.width = rig->width,
                                  .height = rig->height,
                                  .image = ao,
                                  .truth = truth,
                                  .depth = depth,
                                  .sky_depth = 0.5f * AOB_GBUFFER_SKY,
                                  .radius = 0.5,
                                  .pixel_scale = rig->gbuffer.projection.sy,
                                  .perspective = rig->gbuffer.projection.perspective};
    if (!aob_score_judge(&desc, &error))
        fail_msg("%s", error.text);
    aob_score(&desc, &score);
    free(ao);
    free(depth);
    *band = score.band_rmse;
    return score.rmse;
}

static void test_scores_agree(void **state)
{
    (void)state;
    const struct aob_visibility_term term = {.radius = 0.5};
    struct aob_visibility truth;
    struct aob_error error = {{0}};
    struct aob_mesh mesh;
    struct aob_rig rig;
    build("atrium", &mesh);
    aob_rig_scene(&rig, "atrium", NULL, 320, 180, 32);
    const struct aob_visibility_desc desc = {
        .terms = &term, .term_count = 1, .x0 = 32, .y0 = 32, .width = 320, .height = 180, .spp = 64};
    assert_true(aob_tracer_visibility(rig.tracer, &rig.camera, &rig.hits, &desc, &truth, &error));
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_hits drawn;
        struct aob_gbuffer raster;
        double band[2];
        struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
        assert_true(aob_raster_draw(gpu, &mesh, &rig.camera, &rig.gbuffer.projection, &drawn, &error));
        aob_gbuffer_init(&raster, &drawn, &rig.gbuffer.projection, rig.guard);
        double canonical = score(&rig, &rig.gbuffer, gpu, truth.ao, &band[0]);
        double other = score(&rig, &raster, gpu, truth.ao, &band[1]);
        printf("gtao on atrium, %s: rmse %.6f canonical, %.6f raster; in band %.6f, %.6f\n", backends[b],
               canonical, other, band[0], band[1]);
        assert_true(fabs(canonical - other) <= 0.005);
        assert_true(fabs(band[0] - band[1]) <= 0.005);
        aob_gpu_close(gpu);
        aob_gbuffer_finish(&raster);
        aob_hits_finish(&drawn);
    }
    aob_visibility_finish(&truth);
    aob_rig_finish(&rig);
    aob_mesh_finish(&mesh);
}

/* The comparison itself, by hand: 4 x 3 pixels, triangle 1 left of column 2, sky at the lower right. */
static void test_comparison(void **state)
{
    (void)state;
    enum { SKY = AOB_NO_PRIMITIVE };
    uint32_t seen[12] = {1, 1, 2, 2, 1, 1, 2, 2, 1, 1, 2, SKY}, drawn[12];
    float depth[12], other[12], normal[12][3] = {{0}}, turned[12][3] = {{0}};
    for (int i = 0; i < 12; i++) {
        drawn[i] = seen[i];
        depth[i] = other[i] = 2;
    }
    drawn[1] = 2;  /* at the edge between 1 and 2 */
    drawn[4] = 2;  /* two pixels from it */
    drawn[11] = 2; /* where the canonical one is sky */
    other[1] = 50; /* of another primitive: does not count */
    other[0] = 2.5f;
    turned[7][1] = -.25f;
    const struct aob_hits a = {.width = 4, .height = 3, .primitive = seen, .depth = depth, .normal = normal};
    const struct aob_hits b = {.width = 4, .height = 3, .primitive = drawn, .depth = other, .normal = turned};
    struct aob_raster_difference d;
    aob_raster_compare(&a, &b, &d);
    assert_int_equal(d.pixels, 12);
    assert_int_equal(d.other, 3);
    assert_int_equal(d.off_edge, 1);
    assert_near(d.depth_max, .5, 0);
    assert_near(d.depth_relative_max, .25, 0);
    assert_near(d.depth_rmse, sqrt(.25 / 9), 1e-15);
    assert_near(d.normal_max, .25, 0);
}

static void test_refusals(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    struct aob_hits drawn;
    struct aob_error error = {{0}};
    const struct aob_camera camera = {.eye = {0, 0, 1}, .fov_deg = 60};
    struct aob_projection projection = aob_camera_projection(&camera, 8, 8, 0);
    struct aob_gpu *null = aob_rig_gpu("null"), *egl = aob_rig_gpu("gl-egl");
    assert_false(aob_raster_draw(null, &mesh, &camera, &projection, &drawn, &error));
    assert_contains(error.text, "'null' draws nothing");
    assert_false(aob_raster_draw(egl, &mesh, &camera, &projection, &drawn, &error));
    assert_contains(error.text, "0 triangles");
    mesh.triangle_count = AOB_RASTER_MAX_TRIANGLES + 1;
    assert_false(aob_raster_draw(egl, &mesh, &camera, &projection, &drawn, &error));
    assert_contains(error.text, "16777216 triangles");
    aob_gpu_close(null);
    aob_gpu_close(egl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_atrium_on_every_backend),
                                       cmocka_unit_test(test_every_procedural_scene),
                                       cmocka_unit_test(test_orthographic),
                                       cmocka_unit_test(test_far_from_the_origin),
                                       cmocka_unit_test(test_shading_normals),
                                       cmocka_unit_test(test_leaning_normals),
                                       cmocka_unit_test(test_scores_agree),
                                       cmocka_unit_test(test_comparison),
                                       cmocka_unit_test(test_refusals)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
