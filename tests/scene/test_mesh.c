/* Shapes have the areas, normals and bounds that they should; the flat file comes back whole or not at all.
 */
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
#include "base/memory.h"
#include "scene/mesh.h"
#include "scene/scene.h"

static struct aob_vec3 area_vector(const struct aob_mesh *mesh, size_t triangle)
{
    const uint32_t *t = mesh->triangles[triangle];
    struct aob_vec3 a = mesh->positions[t[0]], b = mesh->positions[t[1]], c = mesh->positions[t[2]];
    return aob_vec_scale(aob_vec_cross(aob_vec_sub(b, a), aob_vec_sub(c, a)), 0.5);
}

/* Area and, by the divergence theorem, the volume within: positive only if the faces are closed and face out.
 */
static void measure(const struct aob_mesh *mesh, double *area, double *volume)
{
    *area = *volume = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        struct aob_vec3 n = area_vector(mesh, i);
        assert_true(aob_vec_length(n) > 0);
        *area += aob_vec_length(n);
        *volume += aob_vec_dot(n, mesh->positions[mesh->triangles[i][0]]) / 3;
    }
}

static void near_value(double value, double truth, double share)
{
    assert_true(fabs(value - truth) <= share * fabs(truth));
}

static void quad_faces_u_cross_v(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(1, 2, 3), aob_vec(0, 0, 4), aob_vec(5, 0, 0));
    for (size_t i = 0; i < 2; i++)
        near_value(area_vector(&mesh, i).y, 10, 1e-12);
    aob_mesh_finish(&mesh);
    assert_null(mesh.positions);
}

static void box_is_closed_and_turned(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    double area, volume;
    aob_mesh_add_box(&mesh, aob_vec(1, 2, 3), aob_vec(3, 3, 6), 90);
    measure(&mesh, &area, &volume);
    near_value(area, 22, 1e-12);
    near_value(volume, 6, 1e-12);
    struct aob_vec3 low, high;
    aob_mesh_bounds(&mesh, &low, &high);
    near_value(low.x, 0.5, 1e-12);
    near_value(high.z, 5.5, 1e-12);
    near_value(high.y, 3, 1e-12);
    aob_mesh_finish(&mesh);
}

static void sphere_is_round_and_closed(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    double area, volume;
    aob_mesh_add_sphere(&mesh, aob_vec(5, -3, 2), 2, 128);
    measure(&mesh, &area, &volume);
    near_value(area, 16 * M_PI, 2e-3);
    near_value(volume, 32 * M_PI / 3, 2e-3);
    aob_mesh_finish(&mesh);
    aob_mesh_add_sphere(&mesh, aob_vec(0, 0, 0), 1, 3);
    measure(&mesh, &area, &volume);
    assert_true(volume > 0);
    aob_mesh_finish(&mesh);
}

static void disc_faces_its_normal(void **state)
{
    (void)state;
    const struct aob_vec3 normals[] = {{0, 1, 0}, {0, -2, 0}, {1, 0, 0}, {0.3, -0.4, 0.5}};
    for (size_t k = 0; k < AOB_COUNT(normals); k++) {
        struct aob_mesh mesh = {0};
        aob_mesh_add_disc(&mesh, aob_vec(1, 1, 1), normals[k], 2, 200);
        struct aob_vec3 sum = {0};
        for (size_t i = 0; i < mesh.triangle_count; i++)
            sum = aob_vec_add(sum, area_vector(&mesh, i));
        near_value(aob_vec_dot(sum, aob_vec_normalize(normals[k])), 4 * M_PI, 1e-3);
        aob_mesh_finish(&mesh);
    }
}

static void check_refuses_bad_meshes(void **state)
{
    (void)state;
    struct aob_error error = {""};
    struct aob_mesh mesh = {0};
    assert_false(aob_mesh_check(&mesh, "empty", &error));
    assert_non_null(strstr(error.text, "empty"));
    aob_mesh_add_quad(&mesh, aob_vec(0, 0, 0), aob_vec(1, 0, 0), aob_vec(0, 1, 0));
    assert_true(aob_mesh_check(&mesh, "quad", &error));
    mesh.triangles[1][2] = 4;
    assert_false(aob_mesh_check(&mesh, "quad", &error));
    mesh.triangles[1][2] = 3;
    mesh.positions[2].y = NAN;
    assert_false(aob_mesh_check(&mesh, "quad", &error));
    aob_mesh_finish(&mesh);
}

static void digest_sees_every_part(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    char before[AOB_KEY_SIZE], after[AOB_KEY_SIZE];
    aob_mesh_add_quad(&mesh, aob_vec(0, 0, 0), aob_vec(1, 0, 0), aob_vec(0, 1, 0));
    aob_mesh_digest(&mesh, before);
    aob_mesh_digest(&mesh, after);
    assert_string_equal(before, after);
    mesh.positions[0].x = 1e-12;
    aob_mesh_digest(&mesh, after);
    assert_string_not_equal(before, after);
    mesh.positions[0].x = 0;
    mesh.triangles[0][0] = 1;
    aob_mesh_digest(&mesh, after);
    assert_string_not_equal(before, after);
    aob_mesh_finish(&mesh);
}

static void scratch_path(char path[64])
{
    snprintf(path, 64, "/tmp/aob_test_mesh_%ld.bin", (long)getpid());
}

static void add_normals(struct aob_mesh *mesh)
{
    mesh->normals = AOB_NEW_ARRAY(struct aob_vec3, mesh->vertex_count);
    for (size_t i = 0; i < mesh->vertex_count; i++)
        mesh->normals[i] = aob_vec(0, 0, 1);
}

static void a_saved_mesh_comes_back(void **state)
{
    (void)state;
    char path[64], before[AOB_KEY_SIZE], after[AOB_KEY_SIZE];
    scratch_path(path);
    for (int normals = 0; normals < 2; normals++) {
        struct aob_mesh mesh = {0}, back;
        struct aob_error error = {""};
        aob_mesh_add_sphere(&mesh, aob_vec(0, 0, 0), 1, 12);
        if (normals) {
            add_normals(&mesh);
            aob_mesh_paint(&mesh, (struct aob_material){.base_colour = {1, 0, 0.5f}, .metalness = 1});
            aob_mesh_add_triangle(&mesh, 0, 1, 2);
        }
        aob_mesh_digest(&mesh, before);
        assert_true(aob_mesh_save(&mesh, path, &error));
        assert_true(aob_mesh_restore(&back, path, &error));
        aob_mesh_digest(&back, after);
        assert_string_equal(before, after);
        assert_int_equal(back.normals != NULL, normals);
        assert_int_equal(back.material_count, 2 * normals);
        assert_true(aob_mesh_material(&back, (uint32_t)back.triangle_count - 1)->metalness == (float)normals);
        aob_mesh_finish(&mesh);
        aob_mesh_finish(&back);
    }
    unlink(path);
}

static void refused(const char *path, const char *bytes, size_t size)
{
    struct aob_mesh mesh;
    struct aob_error error = {""};
    FILE *file = fopen(path, "wb"); /* without a flush to disk for each of hundreds */
    assert_non_null(file);
    fwrite(bytes, 1, size, file);
    fclose(file);
    assert_false(aob_mesh_restore(&mesh, path, &error));
    assert_non_null(strstr(error.text, path));
    assert_null(mesh.positions);
}

static void damaged_files_are_refused(void **state)
{
    (void)state;
    char path[64];
    scratch_path(path);
    struct aob_mesh mesh = {0};
    struct aob_error error = {""};
    aob_mesh_paint(&mesh, (struct aob_material){.metalness = 1});
    aob_mesh_add_quad(&mesh, aob_vec(0, 0, 0), aob_vec(1, 0, 0), aob_vec(0, 1, 0));
    assert_true(aob_mesh_save(&mesh, path, &error));
    aob_mesh_finish(&mesh);
    size_t size = 0;
    char *bytes = aob_file_read(path, 4096, &size, &error);
    assert_non_null(bytes);
    for (size_t cut = 0; cut < size; cut += 5)
        refused(path, bytes, cut);
    for (size_t i = 0; i < size; i++) {
        bytes[i] ^= 0x41;
        refused(path, bytes, size);
        bytes[i] ^= 0x41;
    }
    free(bytes);
    unlink(path);
    assert_false(aob_mesh_restore(&mesh, path, &error));
}

/* Whoever may write a file may seal it: a note that runs on to its end must not be read beyond it. */
static void a_note_without_end_is_refused(void **state)
{
    (void)state;
    char path[64];
    scratch_path(path);
    struct aob_mesh mesh = {0}, back;
    struct aob_error error = {""};
    aob_mesh_add_quad(&mesh, aob_vec(0, 0, 0), aob_vec(1, 0, 0), aob_vec(0, 1, 0));
    for (int i = 0; i < AOB_MESH_NOTES; i++)
        aob_mesh_note(&mesh, "%d", i);
    assert_true(aob_mesh_save(&mesh, path, &error));
    assert_true(aob_mesh_restore(&back, path, &error));
    aob_mesh_finish(&back);
    struct aob_mesh_note *last = &mesh.notes[AOB_MESH_NOTES - 1];
    memset(last->text, 'x', sizeof last->text);
    assert_true(aob_mesh_save(&mesh, path, &error));
    assert_false(aob_mesh_restore(&back, path, &error));
    assert_non_null(strstr(error.text, "it is not a flat mesh"));
    mesh.note_count--;
    assert_true(aob_mesh_save(&mesh, path, &error));
    assert_true(aob_mesh_restore(&back, path, &error));
    aob_mesh_finish(&back);
    aob_mesh_finish(&mesh);
    unlink(path);
}

static void every_procedural_scene_is_sound(void **state)
{
    (void)state;
    size_t count = 0;
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++, count++) {
        const struct aob_scene_info *scene = *s;
        assert_ptr_equal(aob_scene_find(scene->name), scene);
        assert_true(scene->view_count >= 2 && scene->metres_per_unit > 0 && scene->title[0]);
        assert_true(scene->file || scene->metre == 1 / scene->metres_per_unit);
        assert_ptr_equal(aob_scene_view(scene, NULL), &scene->views[0]);
        assert_null(aob_scene_view(scene, "no such view"));
        assert_int_equal(!scene->build, scene->file && scene->package);
        for (size_t v = 0; v < scene->view_count; v++) {
            assert_true(aob_camera_check(&scene->views[v].camera, NULL));
            assert_ptr_equal(aob_scene_view(scene, scene->views[v].name), &scene->views[v]);
        }
        if (!scene->build)
            continue;
        struct aob_mesh mesh = {0};
        scene->build(&mesh);
        assert_true(aob_mesh_check(&mesh, scene->name, NULL));
        aob_mesh_finish(&mesh);
    }
    assert_true(count >= 5);
    assert_null(aob_scene_find("no such scene"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quad_faces_u_cross_v),          cmocka_unit_test(box_is_closed_and_turned),
        cmocka_unit_test(sphere_is_round_and_closed),    cmocka_unit_test(disc_faces_its_normal),
        cmocka_unit_test(check_refuses_bad_meshes),      cmocka_unit_test(digest_sees_every_part),
        cmocka_unit_test(a_saved_mesh_comes_back),       cmocka_unit_test(damaged_files_are_refused),
        cmocka_unit_test(a_note_without_end_is_refused), cmocka_unit_test(every_procedural_scene_is_sound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
