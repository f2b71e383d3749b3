/* What the canonical G-buffer's file carries from the ray tracer to the devices. */
#include "check.h"
#include <unistd.h>
#include "rig.h"

enum { W = 40, H = 24, GUARD = 3 };

static void store(const struct aob_rig *rig, const char *scene, char path[64])
{
    struct aob_error error = {{0}};
    struct aob_mesh mesh = {0};
    aob_scene_find(scene)->build(&mesh);
    snprintf(path, 64, "/tmp/aob_test_gbuffer_%ld.exr", (long)getpid());
    assert_true(aob_gbuffer_store(&rig->hits, &mesh, path, &error));
    aob_mesh_finish(&mesh);
}

static void moving(struct aob_rig *rig, bool moves)
{
    struct aob_mesh mesh = {0};
    struct aob_camera camera = aob_scene_find("corner")->views[0].camera;
    camera.moves = moves;
    camera.previous_eye = aob_vec_add(camera.eye, aob_vec(0.1, 0, 0));
    camera.previous_target = camera.target;
    aob_scene_find("corner")->build(&mesh);
    aob_rig_init(rig, &mesh, &camera, W, H, GUARD);
    aob_mesh_finish(&mesh);
}

static void test_velocity_of_a_moving_camera_only(void **state)
{
    (void)state;
    for (int moves = 0; moves < 2; moves++) {
        struct aob_rig rig;
        struct aob_gbuffer back;
        struct aob_error error = {{0}};
        char path[64];
        moving(&rig, moves);
        store(&rig, "corner", path);
        assert_true(aob_gbuffer_load(&back, path, &(struct aob_gbuffer_desc){&rig.camera, W, H, GUARD, false},
                                     &error));
        assert_int_equal(back.velocity != NULL, moves);
        assert_null(back.albedo);
        for (int i = 0; moves && i < rig.hits.width * rig.hits.height; i++)
            assert_memory_equal(&back.velocity[3 * i], rig.hits.velocity[i], 3 * sizeof(float));
        aob_gbuffer_finish(&back);
        aob_rig_finish(&rig);
        unlink(path);
    }
}

static void test_a_still_file_does_not_serve_a_moving_camera(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct aob_gbuffer back;
    struct aob_error error = {{0}};
    char path[64];
    moving(&rig, false);
    store(&rig, "corner", path);
    rig.camera.moves = true;
    assert_false(
        aob_gbuffer_load(&back, path, &(struct aob_gbuffer_desc){&rig.camera, W, H, GUARD, false}, &error));
    assert_contains(error.text, "not a G-buffer");
    aob_rig_finish(&rig);
    unlink(path);
}

/* Its velocities are those of what moves, and a file without them does not serve. */
static void test_velocity_of_a_moving_object(void **state)
{
    (void)state;
    const struct aob_scene_info *scene = aob_scene_find("passing_box");
    for (int frame = 0; frame < 3; frame += 2) {
        struct aob_rig rig;
        struct aob_gbuffer back;
        struct aob_error error = {{0}};
        struct aob_mesh mesh = {0};
        char path[64];
        scene->build(&mesh);
        aob_mesh_move(&mesh, frame);
        aob_rig_init(&rig, &mesh, &scene->views[0].camera, W, H, GUARD);
        aob_mesh_finish(&mesh);
        store(&rig, "passing_box", path);
        struct aob_gbuffer_desc desc = {&rig.camera, W, H, GUARD, frame > 0};
        assert_true(aob_gbuffer_load(&back, path, &desc, &error));
        assert_int_equal(back.velocity != NULL, frame > 0);
        for (int i = 0; frame && i < rig.hits.width * rig.hits.height; i++)
            assert_memory_equal(&back.velocity[3 * i], rig.hits.velocity[i], 3 * sizeof(float));
        aob_gbuffer_finish(&back);
        desc.objects_move = !frame;
        /* what is there is left out, what is not there is asked for */
        assert_int_equal(aob_gbuffer_load(&back, path, &desc, &error), frame > 0);
        aob_gbuffer_finish(&back);
        aob_rig_finish(&rig);
        unlink(path);
    }
}

/* The front view of `cornell`: red on the left, green on the right, sky beyond the room. */
static void test_colours_of_a_painted_scene(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct aob_gbuffer back;
    struct aob_image image = {0};
    struct aob_error error = {{0}};
    char path[64];
    aob_rig_scene(&rig, "cornell", "front", W, H, GUARD);
    store(&rig, "cornell", path);
    assert_true(
        aob_gbuffer_load(&back, path, &(struct aob_gbuffer_desc){&rig.camera, W, H, GUARD, false}, &error));
    assert_true(aob_image_read(&image, path, &error));
    const float *material = aob_image_channel(&image, "material");
    int seen[2] = {0};
    for (int i = 0; i < rig.hits.width * rig.hits.height; i++) {
        const float *a = &back.albedo[3 * i];
        int column = i % rig.hits.width;
        bool sky = rig.hits.primitive[i] == AOB_NO_PRIMITIVE;
        assert_true((material[i] < 0) == sky && (a[0] + a[1] + a[2] == 0) == sky);
        assert_true(back.shine[2 * i] == (sky ? 0 : 1) && back.shine[2 * i + 1] == 0);
        if (sky || a[2] == 0.68f)
            continue;
        bool red = column < rig.hits.width / 2;
        assert_true(a[0] == (red ? 0.63f : 0.14f) && a[1] == (red ? 0.065f : 0.45f));
        assert_true(material[i] == (red ? 2 : 3));
        seen[red]++;
    }
    assert_true(seen[0] > 10 && seen[1] > 10);
    aob_image_finish(&image);
    aob_gbuffer_finish(&back);
    aob_rig_finish(&rig);
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_velocity_of_a_moving_camera_only),
                                       cmocka_unit_test(test_velocity_of_a_moving_object),
                                       cmocka_unit_test(test_colours_of_a_painted_scene),
                                       cmocka_unit_test(test_a_still_file_does_not_serve_a_moving_camera)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
