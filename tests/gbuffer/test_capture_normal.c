/* Normals of a capture that do not lie square on the surface: they lean away from the viewer, or are turned round. */
#include "leaning_floor.h"
#include "reference/bound.h"

static struct aob_vec3 vector(const float v[3])
{
    return aob_vec((double)v[0], (double)v[1], (double)v[2]);
}

static struct aob_vec3 ray_of(const struct aob_projection *view, int x, int y)
{
    return aob_vec((x + 0.5 - view->cx) * view->sx, -(y + 0.5 - view->cy) * view->sy, -1);
}

/* Bent within the plane of the file's normal and the direction to the camera, no further than needed. */
static void check_bent(struct aob_vec3 got, struct aob_vec3 file, struct aob_vec3 to_camera,
                       double floor_cosine)
{
    double least = fmin(AOB_LEAST_FACING, floor_cosine), along = aob_vec_dot(file, to_camera);
    struct aob_vec3 plane = aob_vec_normalize(aob_vec_cross(file, to_camera));
    assert_near(aob_vec_length(got), 1, 1e-6);
    assert_near(aob_vec_dot(got, to_camera), fmax(along, least), 1e-6);
    assert_near(aob_vec_dot(got, plane), 0, 1e-6);
    assert_true(aob_vec_dot(got, file) > 0);
}

static void test_bent_to_the_horizon(void **state)
{
    static const double leans[] = {0, 1, 5, 20, 60};
    (void)state;
    for (size_t k = 0; k < AOB_COUNT(leans); k++) {
        struct aob_capture capture = leaning_floor(leans[k]);
        double lean = leans[k] * M_PI / 180;
        struct aob_vec3 file = aob_vec(0, cos(lean), -sin(lean)), up = aob_vec(0, 1, 0);
        struct aob_projection view = aob_camera_projection(&capture.camera, FLOOR_W, FLOOR_H, 0);
        size_t bent = 0, leaning = 0;
        for (int i = FLOOR_COUNT / 2; i < FLOOR_COUNT; i++) {
            struct aob_vec3 ray = aob_vec_normalize(ray_of(&view, i % FLOOR_W, i / FLOOR_W));
            struct aob_vec3 to_camera = aob_vec_scale(ray, -1);
            struct aob_vec3 normal = vector(capture.hits.normal[i]);
            bool away = aob_vec_dot(file, to_camera) < fmin(AOB_LEAST_FACING, to_camera.y) / 2;
            check_bent(vector(capture.hits.shading[i]), file, to_camera, to_camera.y);
            bool own = leans[k] > 2.5 || (leans[k] > 0 && away);
            assert_near(aob_vec_length(aob_vec_sub(normal, own ? up : file)), 0, 1e-5);
            bent += away;
            leaning += own;
        }
        assert_true(leans[k] == 0 ? bent == 0 : bent > 100);
        assert_int_equal(capture.leaning, leaning);
        assert_int_equal(capture.warning_count, leaning > 0);
        if (leaning)
            assert_contains(capture.warnings[0].text, "normals lean more than 2.5 degrees");
        aob_capture_finish(&capture);
    }
}

/* Nothing stands on the floor, so its visibility is 1 whatever its normals say. */
static void test_truth_of_an_open_floor(void **state)
{
    static const double leans[] = {0, 5, 20};
    enum { SPP = 64 };
    (void)state;
    for (size_t k = 0; k < AOB_COUNT(leans); k++) {
        struct aob_capture capture = leaning_floor(leans[k]);
        struct aob_projection view = aob_camera_projection(&capture.camera, FLOOR_W, FLOOR_H, 0);
        const struct aob_visibility_term term = {.radius = 0.05};
        const struct aob_visibility_desc desc = {.terms = &term, .term_count = 1, .spp = SPP};
        const struct aob_bound_desc slab = {.kind = AOB_BOUND_SLAB, .thickness = 0.05};
        struct aob_visibility result;
        struct aob_error error = {{0}};
        size_t lost = 0;
        struct aob_bound *bound = aob_bound_create(&capture.camera, &view, &capture.hits, &slab, &error);
        assert_non_null(bound);
        assert_true(aob_bound_visibility(bound, &desc, &result, &error));
        for (int i = 0; i < FLOOR_COUNT; i++) {
            /* A ray that leaves at the horizon itself may meet the rounding of the rebuilt surface. */
            assert_true(result.ao[i] >= 1 - 1.0f / SPP);
            lost += result.ao[i] < 1;
        }
        printf("lean %g: %zu of %d rays are lost\n", leans[k], lost, FLOOR_COUNT / 2 * SPP);
        assert_true(lost <= FLOOR_COUNT / 2 / 1000 + 3);
        aob_visibility_finish(&result);
        aob_bound_destroy(bound);
        aob_capture_finish(&capture);
    }
}

/* A floor and a wall behind it, both with normals that are turned round and that lean a little: every one is turned to
 * the side that is seen. */
static void check_turned(double lean)
{
    enum { W = 64, H = 48, COUNT = W * H };
    double s = 2 * tan(FLOOR_FOV * M_PI / 360) / H;
    float *planes = AOB_NEW_ARRAY(float, 4 * COUNT);
    for (int i = 0; i < COUNT; i++) {
        double up = -(i / W + 0.5 - H / 2.0) * s, floor = up < 0 ? 0.5 / -up : INFINITY;
        bool wall = floor > 3;
        planes[i] = (float)fmin(floor, 3);
        planes[2 * COUNT + i] = (float)-(wall ? sin(lean) : cos(lean));
        planes[3 * COUNT + i] = (float)-(wall ? cos(lean) : -sin(lean));
    }
    struct aob_capture capture = capture_of_planes(planes, W, H, EXR_PIXEL_FLOAT);
    for (int i = 0; i < COUNT; i++) {
        bool wall = planes[i] >= 3;
        struct aob_vec3 n = wall ? aob_vec(0, sin(lean), cos(lean)) : aob_vec(0, cos(lean), -sin(lean));
        assert_near(aob_vec_length(aob_vec_sub(vector(capture.hits.normal[i]), n)), 0, 1e-6);
        assert_memory_equal(capture.hits.normal[i], capture.hits.shading[i], sizeof *capture.hits.normal);
    }
    assert_int_equal(capture.derived, 0);
    aob_capture_finish(&capture);
    free(planes);
}

static void test_turned_round(void **state)
{
    (void)state;
    check_turned(0);
    check_turned(2 * M_PI / 180);
}

/* A half has 11 bits: what it says of a surface is steps, and the file's normals serve. */
static void test_coarse_depth(void **state)
{
    enum { W = 200, H = 200, COUNT = W * H };
    (void)state;
    double s = 2 * tan(FLOOR_FOV * M_PI / 360) / H;
    const struct aob_vec3 n = aob_vec_normalize(aob_vec(0.3, 0.2, 1));
    float *planes = AOB_NEW_ARRAY(float, 4 * COUNT);
    for (int i = 0; i < COUNT; i++) {
        double across = (i % W + 0.5 - W / 2.0) * s, up = -(i / W + 0.5 - H / 2.0) * s;
        planes[i] = (float)(8 / (n.z - n.x * across - n.y * up));
        planes[COUNT + i] = (float)n.x;
        planes[2 * COUNT + i] = (float)n.y;
        planes[3 * COUNT + i] = (float)n.z;
    }
    struct aob_capture capture = capture_of_planes(planes, W, H, EXR_PIXEL_HALF);
    for (int i = 0; i < COUNT; i++)
        assert_near(aob_vec_length(aob_vec_sub(vector(capture.hits.normal[i]), n)), 0, 1e-6);
    assert_int_equal(capture.leaning, 0);
    aob_capture_finish(&capture);
    free(planes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_bent_to_the_horizon),
        cmocka_unit_test(test_truth_of_an_open_floor),
        cmocka_unit_test(test_turned_round),
        cmocka_unit_test(test_coarse_depth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
