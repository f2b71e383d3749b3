/* Loading by assimp, each time in a child process as its header demands. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "base/file.h"
#include "scene/load.h"
#include "scene/scene.h"
#include "title.h"

static void bunny_is_as_published(void **state)
{
    (void)state;
    const struct aob_scene_info *scene = aob_scene_find("bunny");
    if (!aob_file_exists(scene->file))
        skip();
    struct paths paths;
    struct aob_mesh mesh;
    make_paths(&paths, "obj");
    assert_int_equal(load(scene->file, paths.flat), LOADED);
    assert_true(aob_mesh_restore(&mesh, paths.flat, NULL));
    unlink(paths.flat);
    assert_int_equal(mesh.triangle_count, 69666);
    struct aob_vec3 low, high;
    aob_mesh_bounds(&mesh, &low, &high);
    assert_true(fabs(low.x + 1) < 1e-6 && fabs(high.y - 0.991233) < 1e-6 && fabs(high.z - 0.775047) < 1e-6);
    assert_non_null(mesh.normals);
    for (size_t i = 0; i < mesh.vertex_count; i++)
        assert_true(fabs(aob_vec_length(mesh.normals[i]) - 1) < 1e-6);
    aob_mesh_finish(&mesh);
}

static void packaged_meshes_have_the_triangles_of_their_titles(void **state)
{
    (void)state;
    struct paths paths;
    make_paths(&paths, "obj");
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++) {
        if (!(*s)->file || !aob_file_exists((*s)->file))
            continue;
        struct aob_mesh mesh;
        assert_int_equal(load((*s)->file, paths.flat), LOADED);
        assert_true(aob_mesh_restore(&mesh, paths.flat, NULL));
        unlink(paths.flat);
        assert_int_equal(mesh.triangle_count, title_triangles((*s)->title));
        aob_mesh_finish(&mesh);
    }
}

static const char two_faces[] = "o first\nv 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nf 1 2 3 4\n"
                                "o second\nv 0 0 5\nv 1 0 5\nv 0 1 5\nf 5 6 7\nl 1 2\n";

static void obj_polygons_become_triangles(void **state)
{
    (void)state;
    struct aob_mesh mesh;
    load_text(&mesh, "obj", two_faces);
    assert_int_equal(mesh.triangle_count, 3);
    struct aob_vec3 low, high;
    aob_mesh_bounds(&mesh, &low, &high);
    assert_true(high.x == 2 && high.y == 3 && high.z == 5 && low.z == 0);
    assert_non_null(mesh.normals);
    for (size_t i = 0; i < mesh.vertex_count; i++)
        assert_true(fabs(mesh.normals[i].z - 1) < 1e-6);
    aob_mesh_finish(&mesh);
}

static void ply_is_read(void **state)
{
    (void)state;
    struct aob_mesh mesh;
    load_text(
        &mesh, "ply",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    assert_int_equal(mesh.triangle_count, 2);
    aob_mesh_finish(&mesh);
}

static void bad_files_are_refused_with_one_line(void **state)
{
    (void)state;
    static const char *const bad[] = {"",
                                      "this is no mesh\n",
                                      "v 0 0 0\nv 1 0 0\n",
                                      "v 0 0 0\nf 1 1 1\n",
                                      "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                                      "v 0 0 0\nv 1 0 0\nf 1 2 9\n"};
    struct paths paths;
    make_paths(&paths, "obj");
    assert_int_equal(load("/nonexistent/file.obj", paths.flat), REFUSED);
    assert_int_equal(load("/tmp", paths.flat), REFUSED);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_true(aob_file_write(paths.source, bad[i], strlen(bad[i]), NULL));
        assert_int_equal(load(paths.source, paths.flat), REFUSED);
    }
    unlink(paths.source);
}

/* A truncated OBJ may be a smaller mesh; whatever comes, it is a sound mesh or a refusal. */
static void truncated_files_are_sound_or_refused(void **state)
{
    (void)state;
    struct paths paths;
    make_paths(&paths, "obj");
    for (size_t cut = 0; cut < sizeof two_faces; cut += 3) {
        assert_true(aob_file_write(paths.source, two_faces, cut, NULL));
        int end = load(paths.source, paths.flat);
        assert_true(end == LOADED || end == REFUSED);
        if (end != LOADED)
            continue;
        struct aob_mesh mesh;
        assert_true(aob_mesh_restore(&mesh, paths.flat, NULL));
        assert_true(mesh.triangle_count >= 1 && mesh.triangle_count <= 3);
        aob_mesh_finish(&mesh);
    }
    unlink(paths.source);
    unlink(paths.flat);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bunny_is_as_published),
        cmocka_unit_test(packaged_meshes_have_the_triangles_of_their_titles),
        cmocka_unit_test(obj_polygons_become_triangles),
        cmocka_unit_test(ply_is_read),
        cmocka_unit_test(bad_files_are_refused_with_one_line),
        cmocka_unit_test(truncated_files_are_sound_or_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
