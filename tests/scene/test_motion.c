/* Where a camera is in each frame of a motion, and what of a mesh has moved. */
#include "scene/motion.h"
#include "check.h"
#include "scene/mesh.h"
#include "scene/scene.h"

static void near_vec(struct aob_vec3 a, double x, double y, double z)
{
    assert_true(aob_vec_length(aob_vec_sub(a, aob_vec(x, y, z))) < 1e-12);
}

static void a_camera_goes_straight(void **state)
{
    (void)state;
    const struct aob_motion motion = {5, {1, 2, 3}, {0, 0, 0.1}, {3, 2, -1}, {0, 0.8, 0.3}};
    const struct aob_camera lens = {.fov_deg = 41, .shift = {0.5, 0}};
    for (int t = 0; t < 5; t++) {
        struct aob_camera camera = aob_motion_camera(&motion, &lens, t);
        assert_true(camera.fov_deg == 41 && camera.shift[0] == 0.5 && camera.moves == (t > 0));
        near_vec(camera.eye, 1 + 0.5 * t, 2, 3 - t);
        near_vec(camera.target, 0, 0.2 * t, 0.1 + 0.05 * t);
        if (t)
            near_vec(camera.previous_eye, 0.5 + 0.5 * t, 2, 4 - t);
        if (t)
            near_vec(camera.previous_target, 0, 0.2 * (t - 1), 0.05 + 0.05 * t);
    }
    struct aob_camera last = aob_motion_camera(&motion, &lens, 4);
    assert_true(last.target.y == 0.8 && last.target.z == 0.3); /* to the bit */
}

static void a_still_camera_stays(void **state)
{
    (void)state;
    const struct aob_motion motion = {3, {1, 2, 3}, {0, 0, 0.1}, {1, 2, 3}, {0, 0, 0.1}};
    assert_false(aob_motion_has_camera(&motion));
    for (int t = 0; t < 3; t++) {
        struct aob_camera camera = aob_motion_camera(&motion, &(struct aob_camera){.fov_deg = 60}, t);
        assert_true(!camera.moves && camera.eye.x == 1 && camera.target.z == 0.1);
    }
}

/* Its triangles alone, each corner once, as far as the number of the frame says. */
static void what_moves_moves(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0}, still = {0};
    aob_mesh_add_quad(&mesh, aob_vec(0, 0, 0), aob_vec(1, 0, 0), aob_vec(0, 1, 0));
    aob_mesh_start(&mesh, aob_vec(0.25, 0, -0.5));
    aob_mesh_add_quad(&mesh, aob_vec(5, 0, 0), aob_vec(1, 0, 0), aob_vec(0, 1, 0));
    aob_mesh_rest(&mesh);
    aob_mesh_add_quad(&mesh, aob_vec(9, 0, 0), aob_vec(1, 0, 0), aob_vec(0, 1, 0));
    assert_true(mesh.moving_first == 2 && mesh.moving_count == 2 && mesh.frame == 0);
    aob_mesh_move(&mesh, 6);
    assert_int_equal(mesh.frame, 6);
    near_vec(mesh.positions[0], 0, 0, 0);
    near_vec(mesh.positions[4], 6.5, 0, -3);
    near_vec(mesh.positions[6], 7.5, 1, -3);
    near_vec(mesh.positions[8], 9, 0, 0);
    aob_mesh_finish(&mesh);
    aob_mesh_add_quad(&still, aob_vec(0, 0, 0), aob_vec(1, 0, 0), aob_vec(0, 1, 0));
    aob_mesh_move(&still, 3);
    near_vec(still.positions[1], 1, 0, 0);
    aob_mesh_finish(&still);
}

/* The same triangles that move otherwise, or not at all, are another geometry. */
static void a_digest_has_the_motion(void **state)
{
    (void)state;
    char keys[3][AOB_KEY_SIZE];
    for (int i = 0; i < 3; i++) {
        struct aob_mesh mesh = {0};
        if (i)
            aob_mesh_start(&mesh, aob_vec(0.1 * i, 0, 0));
        aob_mesh_add_quad(&mesh, aob_vec(0, 0, 0), aob_vec(1, 0, 0), aob_vec(0, 1, 0));
        if (i)
            aob_mesh_rest(&mesh);
        aob_mesh_digest(&mesh, keys[i]);
        aob_mesh_finish(&mesh);
    }
    assert_string_not_equal(keys[0], keys[1]);
    assert_string_not_equal(keys[0], keys[2]);
    assert_string_not_equal(keys[1], keys[2]);
}

static void scenes_say_whether_they_move(void **state)
{
    (void)state;
    int moving = 0;
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++) {
        struct aob_mesh mesh = {0};
        if (!(*s)->build) {
            assert_false((*s)->moves);
            continue;
        }
        (*s)->build(&mesh);
        assert_int_equal((*s)->moves, mesh.moving_count > 0);
        moving += (*s)->moves;
        aob_mesh_finish(&mesh);
    }
    assert_true(moving > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_camera_goes_straight),
        cmocka_unit_test(a_still_camera_stays),
        cmocka_unit_test(what_moves_moves),
        cmocka_unit_test(a_digest_has_the_motion),
        cmocka_unit_test(scenes_say_whether_they_move),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
