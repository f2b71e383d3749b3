/* The share of occluders that are backs, where it is known; and which built-in scenes are fit for techniques that draw
 * triangles. */
#include "check.h"
#include "reference/backs.h"
#include "scene/load.h"
#include "scene/mesh_double.h"
#include "shot.h"

static double backs_of(struct aob_mesh *mesh, struct aob_vec3 eye, struct aob_vec3 target, double radius)
{
    struct shot shot;
    cast_shot(&shot, mesh, (struct aob_camera){.eye = eye, .target = target, .fov_deg = 60}, 48, 32);
    double backs = aob_tracer_backs(shot.tracer, &shot.camera, &shot.hits, radius);
    finish_shot(&shot);
    return backs;
}

static void turn_inside_out(struct aob_mesh *mesh, size_t first)
{
    for (size_t i = first; i < mesh->triangle_count; i++) {
        uint32_t *t = mesh->triangles[i], last = t[2];
        t[2] = t[1];
        t[1] = last;
    }
}

/* A level sheet that faces up, over a floor: a direction at the angle a to the normal meets its back at h / cos(a), so
 * within the radius R the share is 1 - (h/R)^2. */
static void a_sheet_over_a_floor(void **state)
{
    static const double radii[] = {0.1, 0.25, 0.4, 1};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(radii); i++)
        for (int down = 0; down < 2; down++) {
            struct aob_mesh mesh = {0};
            const double h = 0.2, size = 100;
            struct aob_vec3 u = aob_vec(0, 0, size), v = aob_vec(size, 0, 0);
            aob_mesh_add_quad(&mesh, aob_vec(-size / 2, 0, -size / 2), u, v);
            aob_mesh_add_quad(&mesh, aob_vec(-size / 2, h, -size / 2), down ? v : u, down ? u : v);
            double share = backs_of(&mesh, aob_vec(0, 0.1, 0), aob_vec(0.1, 0, 0), radii[i]);
            double wanted = down || radii[i] < h ? 0 : 1 - h * h / (radii[i] * radii[i]);
            assert_near(share, wanted, 2e-3);
        }
}

static void rooms_and_solids(void **state)
{
    (void)state;
    const struct aob_vec3 low = {-1, -1, -1}, high = {1, 1, 1}, in = {0.2, 0.1, 0.3}, side = {-1, -0.5, 0};
    for (int inward = 0; inward < 2; inward++) {
        struct aob_mesh mesh = {0};
        aob_mesh_add_box(&mesh, low, high, 0);
        if (inward)
            turn_inside_out(&mesh, 0);
        assert_near(backs_of(&mesh, in, side, INFINITY), !inward, 0); /* seen from inside */
    }
    for (int inward = 0; inward < 2; inward++) {
        struct aob_mesh mesh = {0};
        aob_mesh_add_box(&mesh, aob_vec(-9, -2, -9), aob_vec(9, -1.5, 9), 0);
        aob_mesh_add_box(&mesh, aob_vec(-1, -1.6, -1), high, 20); /* stands within the floor */
        if (inward)
            turn_inside_out(&mesh, 12);
        double share = backs_of(&mesh, aob_vec(3, 1, 4), aob_vec(0, -1, 0), 1);
        assert_true(inward ? share > 0.01 : share == 0);
    }
}

static void doubles_are_counted(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    aob_mesh_add_box(&mesh, aob_vec(0, 0, 0), aob_vec(1, 2, 3), 0);
    assert_int_equal(aob_mesh_double_count(&mesh), 0);
    aob_mesh_add_box(&mesh, aob_vec(1, 0, 0), aob_vec(2, 2, 3),
                     0); /* its wall lies back to back with the first one's */
    assert_int_equal(aob_mesh_double_count(&mesh), 0);
    for (uint32_t i = 0; i < 5; i++) {
        const uint32_t *t = mesh.triangles[i];
        aob_mesh_add_triangle(&mesh, t[i % 3], t[(i + 1) % 3], t[(i + 2) % 3]);
    }
    assert_int_equal(aob_mesh_double_count(&mesh), 5);
    aob_mesh_add_box(&mesh, aob_vec(0, 0, 0), aob_vec(1, 2, 3), 0); /* vertices of its own */
    assert_int_equal(aob_mesh_double_count(&mesh), 17);
    aob_mesh_finish(&mesh);
}

static void build(const struct aob_scene_info *scene, struct aob_mesh *mesh)
{
    struct paths paths;
    *mesh = (struct aob_mesh){0};
    if (scene->build) {
        scene->build(mesh);
        return;
    }
    make_paths(&paths, "obj");
    assert_int_equal(load(scene->file, paths.flat), LOADED); /* ./dev installs these */
    assert_true(aob_mesh_restore(mesh, paths.flat, NULL));
    unlink(paths.flat);
}

/* Of the built-in scenes only the grass has backs that matter: its blades are sheets. The radius is a tenth of the
 * distance to what the camera looks at. */
static void built_in_scenes_are_closed_or_grass(void **state)
{
    (void)state;
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++)
        for (size_t v = 0; v < (*s)->view_count; v++) {
            const struct aob_camera *camera = &(*s)->views[v].camera;
            double radius = aob_vec_length(aob_vec_sub(camera->eye, camera->target)) / 10;
            struct aob_mesh mesh;
            build(*s, &mesh);
            assert_int_equal(aob_mesh_double_count(&mesh), 0);
            double share = backs_of(&mesh, camera->eye, camera->target, radius);
            bool grass = strcmp((*s)->name, "grass") == 0;
            if (grass ? share < 0.02 : share >= 1e-3)
                fail_msg("%s/%s: %g of the directions meet backs", (*s)->name, (*s)->views[v].name, share);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sheet_over_a_floor),
        cmocka_unit_test(rooms_and_solids),
        cmocka_unit_test(doubles_are_counted),
        cmocka_unit_test(built_in_scenes_are_closed_or_grass),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
