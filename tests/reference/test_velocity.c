/* Off-centre views and the velocity of a moving camera, against reprojection by hand. */
#include "shot.h"

enum { W = 64, H = 48 };

/* A wall z = 0 of 2 x 2 m about the origin: round it there is sky. */
static void wall_shot(struct shot *shot, struct aob_camera camera)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-1, -1, 0), aob_vec(2, 0, 0), aob_vec(0, 2, 0));
    cast_shot(shot, &mesh, camera, W, H);
}

static void near_velocity(const struct shot *shot, size_t pixel, double x, double y)
{
    assert_true(fabs((double)shot->hits.velocity[pixel][0] - x) < 1e-3);
    assert_true(fabs((double)shot->hits.velocity[pixel][1] - y) < 1e-3);
}

/* Of the wall; the sky's is that of what is nowhere. */
static void near_earlier_depth(const struct shot *shot, size_t pixel, double depth)
{
    double then = (double)shot->hits.velocity[pixel][2];
    bool sky = shot->hits.primitive[pixel] == AOB_NO_PRIMITIVE;
    assert_true(sky ? then == (double)AOB_NO_VELOCITY : fabs(then - depth) < 1e-5 * depth);
}

static void a_still_camera_has_no_velocity(void **state)
{
    (void)state;
    struct shot shot;
    wall_shot(&shot, (struct aob_camera){.eye = {0, 0, 4}, .fov_deg = 60});
    assert_null(shot.hits.velocity);
    finish_shot(&shot);
}

/* 0.1 m to the left and 0.05 m down since then: things moved right and up by that over depth and pixel size. */
static void a_step_aside_moves_by_parallax(void **state)
{
    (void)state;
    for (int ortho = 0; ortho < 2; ortho++) {
        struct shot shot;
        size_t wall = 0;
        wall_shot(&shot, (struct aob_camera){.eye = {0, 0, 4},
                                             .target = {0, 0, 0},
                                             .fov_deg = 60,
                                             .ortho_height = ortho ? 4 : 0,
                                             .shift = {0.2, 0.1},
                                             .moves = true,
                                             .previous_eye = {0.1, 0.05, 4},
                                             .previous_target = {0.1, 0.05, 0}});
        double pixel = ortho ? 4.0 / H : 4 * 2 * tan(M_PI / 6) / H; /* metres of the wall a pixel */
        for (size_t i = 0; i < pixel_count(&shot); i++) {
            bool sky = shot.hits.primitive[i] == AOB_NO_PRIMITIVE;
            near_velocity(&shot, i, sky ? 0 : 0.1 / pixel, sky ? 0 : -0.05 / pixel);
            near_earlier_depth(&shot, i, 4);
            wall += !sky;
        }
        assert_true(wall > 200 && wall < pixel_count(&shot) - 200);
        finish_shot(&shot);
    }
}

/* Nearer by 1 m since then: what stood at p stood at p 4/5 from the centre. */
static void a_step_forward_spreads_the_image(void **state)
{
    (void)state;
    struct shot shot;
    wall_shot(&shot,
              (struct aob_camera){.eye = {0, 0, 4}, .fov_deg = 60, .moves = true, .previous_eye = {0, 0, 5}});
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        if (shot.hits.primitive[i] != AOB_NO_PRIMITIVE)
            near_velocity(&shot, i, ((double)(i % W) + 0.5 - W / 2.0) / 5,
                          ((double)(i / W) + 0.5 - H / 2.0) / 5);
        near_earlier_depth(&shot, i, 5);
    }
    finish_shot(&shot);
}

/* Turned about the vertical by `a` since then: wall and sky alike, whatever their depth. */
static void a_turn_moves_wall_and_sky_alike(void **state)
{
    (void)state;
    struct shot shot;
    double a = 0.07, s = 2 * tan(M_PI / 6) / H;
    const double shift[2] = {-0.1, 0.15};
    wall_shot(&shot, (struct aob_camera){.eye = {0.3, 0.2, 4},
                                         .target = {0.3, 0.2, 0},
                                         .fov_deg = 60,
                                         .shift = {shift[0], shift[1]},
                                         .moves = true,
                                         .previous_eye = {0.3, 0.2, 4},
                                         .previous_target = {0.3 + sin(a), 0.2, 4 - cos(a)}});
    for (size_t i = 0; i < pixel_count(&shot); i++) {
        double cx = W / 2.0 - shift[0] * H, cy = H / 2.0 + shift[1] * H;
        double qx = (double)(i % W) + 0.5, qy = (double)(i / W) + 0.5;
        double x = (qx - cx) * s, y = (qy - cy) * s, depth = cos(a) + x * sin(a);
        near_velocity(&shot, i, qx - (cx + (x * cos(a) - sin(a)) / depth / s), qy - (cy + y / depth / s));
        near_earlier_depth(&shot, i, 4 * depth); /* the point's at depth 4 */
    }
    finish_shot(&shot);
}

static void behind_the_previous_camera_is_nowhere(void **state)
{
    (void)state;
    struct shot shot;
    wall_shot(&shot, (struct aob_camera){.eye = {0, 0, 4},
                                         .fov_deg = 40,
                                         .moves = true,
                                         .previous_eye = {0, 0, 4},
                                         .previous_target = {0, 0, 9}});
    for (size_t i = 0; i < pixel_count(&shot); i++)
        for (int c = 0; c < 3; c++)
            assert_true(shot.hits.velocity[i][c] == AOB_NO_VELOCITY);
    finish_shot(&shot);
}

/* Half of the wall goes by (0.1, -0.05, 0.2) m a frame, before a camera that is still or has come 1 m nearer. In frame 0 nothing
 * came from anywhere. */
static void what_moves_was_a_step_earlier(void **state)
{
    (void)state;
    for (int frame = 0; frame < 4; frame += 3)
        for (int moves = 0; moves < 2; moves++) {
            struct shot shot;
            struct aob_mesh mesh = {0};
            size_t counts[2] = {0, 0};
            aob_mesh_add_quad(&mesh, aob_vec(-1, -1, 0), aob_vec(1, 0, 0), aob_vec(0, 2, 0));
            aob_mesh_start(&mesh, aob_vec(0.1, -0.05, 0.2));
            aob_mesh_add_quad(&mesh, aob_vec(0, -1, 0), aob_vec(1, 0, 0), aob_vec(0, 2, 0));
            aob_mesh_rest(&mesh);
            aob_mesh_move(&mesh, frame);
            cast_shot(&shot, &mesh,
                      (struct aob_camera){
                          .eye = {0, 0, 4}, .fov_deg = 60, .moves = moves, .previous_eye = {0, 0, 5}},
                      W, H);
            assert_int_equal(shot.hits.velocity != NULL, frame || moves);
            double size = 2 * tan(M_PI / 6) / H;
            for (size_t i = 0; shot.hits.velocity && i < pixel_count(&shot); i++) {
                if (shot.hits.primitive[i] == AOB_NO_PRIMITIVE)
                    continue;
                bool goes = shot.hits.primitive[i] >= 2;
                double z = goes ? 0.2 * frame : 0, x = ((double)(i % W) + 0.5 - W / 2.0) * size * (4 - z),
                       y = -((double)(i / W) + 0.5 - H / 2.0) * size * (4 - z);
                double depth = 4 + moves - z + (goes && frame ? 0.2 : 0);
                double was_x = goes && frame ? x - 0.1 : x, was_y = goes && frame ? y + 0.05 : y;
                near_velocity(&shot, i, x / (4 - z) / size - was_x / depth / size,
                              -y / (4 - z) / size + was_y / depth / size);
                near_earlier_depth(&shot, i, depth);
                counts[goes]++;
            }
            assert_true(!shot.hits.velocity || (counts[0] > 100 && counts[1] > 100));
            finish_shot(&shot);
        }
}

/* The same rays as a part of a centred picture of twice the size. */
static void off_centre_is_a_crop_of_a_larger_view(void **state)
{
    (void)state;
    enum { X0 = 47, Y0 = 9 };
    for (int ortho = 0; ortho < 2; ortho++) {
        struct shot part, whole;
        struct aob_camera camera = {
            .eye = {0.5, 1.6, 4}, .target = {0, 0.6, 0}, .fov_deg = 50, .ortho_height = ortho ? 2.5 : 0};
        struct aob_camera larger = camera;
        larger.fov_deg = 2 * atan(2 * tan(25 * M_PI / 180)) * 180 / M_PI;
        larger.ortho_height = 2 * camera.ortho_height;
        camera.shift[0] = (X0 - W / 2.0) / H;
        camera.shift[1] = (H / 2.0 - Y0) / H;
        struct aob_mesh mesh = {0};
        aob_scene_find("spheres")->build(&mesh);
        cast_shot(&part, &mesh, camera, W, H);
        aob_scene_find("spheres")->build(&mesh);
        cast_shot(&whole, &mesh, larger, 2 * W, 2 * H);
        for (size_t i = 0; i < pixel_count(&part); i++) {
            size_t j = (i / W + Y0) * 2 * W + i % W + X0;
            assert_int_equal(part.hits.primitive[i], whole.hits.primitive[j]);
            assert_true(fabsf(part.hits.depth[i] - whole.hits.depth[j]) <= 1e-6f * whole.hits.depth[j]);
        }
        finish_shot(&part);
        finish_shot(&whole);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_still_camera_has_no_velocity),
        cmocka_unit_test(a_step_aside_moves_by_parallax),
        cmocka_unit_test(a_step_forward_spreads_the_image),
        cmocka_unit_test(a_turn_moves_wall_and_sky_alike),
        cmocka_unit_test(behind_the_previous_camera_is_nowhere),
        cmocka_unit_test(what_moves_was_a_step_earlier),
        cmocka_unit_test(off_centre_is_a_crop_of_a_larger_view),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
