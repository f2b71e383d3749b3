/* Image positions, rays and view space agree with each other. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include "base/memory.h"
#include "scene/camera.h"
#include "scene/scene.h"

static const struct aob_camera cameras[] = {
    {.eye = {0, 2, 4}, .target = {0, 0.8, 0}, .fov_deg = 60},
    {.eye = {3, 4, 8}, .target = {-1, 1, 2}, .fov_deg = 20},
    {.eye = {0, 5, 0}, .target = {0, 0, 0}, .fov_deg = 90},
    {.eye = {0, -5, 0}, .target = {0, 0, 0}, .fov_deg = 90},
    {.eye = {1, 2, 3}, .target = {4, 5, 6}, .ortho_height = 3},
    {.eye = {1, 2, 3}, .target = {4, 5, 6}, .ortho_height = 3, .shift = {0.4, -0.7}},
    {.eye = {3, 4, 8}, .target = {-1, 1, 2}, .fov_deg = 20, .shift = {-1, 0.3}},
};

static void near_vec(struct aob_vec3 a, struct aob_vec3 b)
{
    assert_true(aob_vec_length(aob_vec_sub(a, b)) < 1e-9);
}

static void axes_are_orthonormal_and_right_handed(void **state)
{
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cameras); i++) {
        struct aob_frame_axes axes = aob_camera_axes(&cameras[i]);
        near_vec(aob_vec_cross(axes.right, axes.up), axes.back);
        assert_true(fabs(aob_vec_length(axes.right) - 1) < 1e-12 &&
                    fabs(aob_vec_length(axes.up) - 1) < 1e-12);
        near_vec(axes.back, aob_vec_normalize(aob_vec_sub(cameras[i].eye, cameras[i].target)));
    }
    near_vec(aob_camera_axes(&cameras[0]).right, aob_vec(1, 0, 0));
    near_vec(aob_camera_axes(&cameras[2]).up, aob_vec(0, 0, -1));
    near_vec(aob_camera_axes(&cameras[2]).right, aob_vec(1, 0, 0));
    near_vec(aob_camera_axes(&cameras[3]).right, aob_vec(1, 0, 0));
}

/* A ray's point at depth s, taken to view space, is what struct aob_projection says. */
static void rays_match_the_projection(void **state)
{
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cameras); i++)
        for (int guard = 0; guard <= 7; guard += 7) {
            const struct aob_camera *camera = &cameras[i];
            struct aob_projection p = aob_camera_projection(camera, 160, 90, guard);
            assert_int_equal(p.width, 160 + 2 * guard);
            assert_int_equal(p.height, 90 + 2 * guard);
            struct aob_frame_axes axes = aob_camera_axes(camera);
            struct aob_vec3 origin, direction;
            const double depth = 2.5, qx = 12.5, qy = 70.5;
            aob_camera_ray(camera, &p, qx, qy, &origin, &direction);
            struct aob_vec3 v =
                aob_vec_sub(aob_vec_add(origin, aob_vec_scale(direction, depth)), camera->eye);
            double s = p.perspective ? depth : 1;
            assert_true(fabs(aob_vec_dot(v, axes.right) - (qx - p.cx) * p.sx * s) < 1e-9);
            assert_true(fabs(aob_vec_dot(v, axes.up) + (qy - p.cy) * p.sy * s) < 1e-9);
            assert_true(fabs(aob_vec_dot(v, axes.back) + depth) < 1e-9);
        }
}

static void guard_keeps_the_inner_image(void **state)
{
    (void)state;
    struct aob_projection inner = aob_camera_projection(&cameras[0], 160, 90, 0);
    struct aob_projection outer = aob_camera_projection(&cameras[0], 160, 90, 16);
    struct aob_vec3 o, a, b;
    aob_camera_ray(&cameras[0], &inner, 3.5, 4.5, &o, &a);
    aob_camera_ray(&cameras[0], &outer, 19.5, 20.5, &o, &b);
    near_vec(a, b);
}

static void field_of_view_is_vertical(void **state)
{
    (void)state;
    struct aob_projection p = aob_camera_projection(&cameras[0], 200, 100, 0);
    struct aob_vec3 origin, top, middle;
    aob_camera_ray(&cameras[0], &p, 100, 0, &origin, &top);
    aob_camera_ray(&cameras[0], &p, 100, 50, &origin, &middle);
    double cosine = aob_vec_dot(top, middle) / aob_vec_length(top);
    assert_true(fabs(acos(cosine) - M_PI / 6) < 1e-9);
    assert_true(top.y > middle.y);
    p = aob_camera_projection(&cameras[4], 200, 100, 0);
    assert_true(!p.perspective && fabs(p.sy * 100 - 3) < 1e-12 && p.sx == p.sy);
}

/* The point (1, 2, 1) from 4 m: 2 tan 45 / 100 a pixel and metre of depth; the axis meets the image at (55, 40). */
static void off_centre_is_as_computed_by_hand(void **state)
{
    (void)state;
    struct aob_camera camera = {.eye = {0, 0, 5}, .fov_deg = 90, .shift = {0.25, -0.1}};
    for (int guard = 0; guard <= 6; guard += 6) {
        struct aob_projection p = aob_camera_projection(&camera, 160, 100, guard);
        struct aob_vec3 origin, direction;
        double q[2];
        assert_true(fabs(p.cx - (55 + guard)) < 1e-12 && fabs(p.cy - (40 + guard)) < 1e-12);
        assert_true(aob_camera_project(&camera, &p, aob_vec(1, 2, -4), q));
        assert_true(fabs(q[0] - (67.5 + guard)) < 1e-9 && fabs(q[1] - (15 + guard)) < 1e-9);
        aob_camera_ray(&camera, &p, 67.5 + guard, 15 + guard, &origin, &direction);
        near_vec(aob_vec_add(origin, aob_vec_scale(direction, 4)), aob_vec(1, 2, 1));
        assert_false(aob_camera_project(&camera, &p, aob_vec(1, 2, 4), q));
    }
    camera.ortho_height = 5; /* 0.05 m a pixel */
    struct aob_projection p = aob_camera_projection(&camera, 160, 100, 0);
    double q[2];
    assert_true(aob_camera_project(&camera, &p, aob_vec(1, 2, 4), q));
    assert_true(fabs(q[0] - 75) < 1e-9 && fabs(q[1] - 0) < 1e-9);
}

static void keys_know_lens_and_motion(void **state)
{
    (void)state;
    struct aob_camera camera = cameras[0], moving;
    struct aob_text still = {0}, shifted = {0}, moved = {0}, ignored = {0};
    aob_camera_print(&camera, true, &still);
    moving = camera;
    moving.moves = true;
    moving.previous_eye = aob_vec(1, 1, 1);
    aob_camera_print(&moving, true, &moved);
    aob_camera_print(&moving, false, &ignored);
    camera.shift[1] = 1e-9;
    aob_camera_print(&camera, true, &shifted);
    assert_string_equal(still.data, ignored.data);
    assert_string_not_equal(still.data, moved.data);
    assert_string_not_equal(still.data, shifted.data);
    struct aob_camera before = aob_camera_previous(&moving), same = aob_camera_previous(&cameras[0]);
    assert_true(!before.moves && before.eye.x == 1 && before.fov_deg == moving.fov_deg);
    near_vec(same.eye, cameras[0].eye);
    aob_text_finish(&still);
    aob_text_finish(&shifted);
    aob_text_finish(&moved);
    aob_text_finish(&ignored);
}

static void bad_cameras_are_refused(void **state)
{
    (void)state;
    const struct aob_camera bad[] = {
        {.eye = {1, 1, 1}, .target = {1, 1, 1}, .fov_deg = 60},
        {.eye = {NAN, 0, 0}, .fov_deg = 60},
        {.eye = {0, 0, 1}, .target = {0, INFINITY, 0}, .fov_deg = 60},
        {.eye = {0, 0, 1}, .fov_deg = 0.5},
        {.eye = {0, 0, 1}, .fov_deg = 171},
        {.eye = {0, 0, 1}, .fov_deg = NAN},
        {.eye = {0, 0, 1}, .ortho_height = -1, .fov_deg = 60},
        {.eye = {0, 0, 1}, .ortho_height = INFINITY},
        {.eye = {0, 0, 1}, .fov_deg = 60, .shift = {0, NAN}},
        {.eye = {0, 0, 1}, .fov_deg = 60, .shift = {-16.5, 0}},
        {.eye = {0, 0, 1}, .fov_deg = 60, .moves = true},
        {.eye = {0, 0, 1}, .fov_deg = 60, .moves = true, .previous_eye = {INFINITY, 0, 0}},
    };
    for (size_t i = 0; i < AOB_COUNT(bad); i++) {
        struct aob_error error = {""};
        assert_false(aob_camera_check(&bad[i], &error));
        assert_true(error.text[0]);
    }
    for (size_t i = 0; i < AOB_COUNT(cameras); i++)
        assert_true(aob_camera_check(&cameras[i], NULL));
}

static void framing_holds_the_box(void **state)
{
    (void)state;
    struct aob_vec3 low = aob_vec(-3, 1, 10), high = aob_vec(5, 2, 12);
    struct aob_camera camera = aob_scene_framing(low, high);
    assert_true(aob_camera_check(&camera, NULL));
    struct aob_frame_axes axes = aob_camera_axes(&camera);
    struct aob_projection p = aob_camera_projection(&camera, 160, 90, 0);
    for (int i = 0; i < 8; i++) {
        struct aob_vec3 corner =
            aob_vec(i & 1 ? low.x : high.x, i & 2 ? low.y : high.y, i & 4 ? low.z : high.z);
        struct aob_vec3 v = aob_vec_sub(corner, camera.eye);
        double depth = -aob_vec_dot(v, axes.back);
        assert_true(depth > 0);
        assert_true(fabs(aob_vec_dot(v, axes.right)) < 80 * p.sx * depth);
        assert_true(fabs(aob_vec_dot(v, axes.up)) < 45 * p.sy * depth);
    }
    camera = aob_scene_framing(low, low);
    assert_true(aob_camera_check(&camera, NULL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(axes_are_orthonormal_and_right_handed),
        cmocka_unit_test(rays_match_the_projection),
        cmocka_unit_test(guard_keeps_the_inner_image),
        cmocka_unit_test(field_of_view_is_vertical),
        cmocka_unit_test(off_centre_is_as_computed_by_hand),
        cmocka_unit_test(keys_know_lens_and_motion),
        cmocka_unit_test(bad_cameras_are_refused),
        cmocka_unit_test(framing_holds_the_box),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
