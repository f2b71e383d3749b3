/* Scale and place of a file do not show: the same scene written as binary PLY with 32-bit vertices, scaled and moved,
 * loaded, cast and traced with camera and radius likewise. */
#include "shot.h"
#include <stdlib.h>
#include <string.h>
#include "base/text.h"
#include "scene/load.h"

enum { W = 64, H = 36, SPP = 1024 };

static struct aob_vec3 place(struct aob_vec3 p, double scale, struct aob_vec3 move)
{
    return aob_vec_add(aob_vec_scale(p, scale), move);
}

/* Little-endian, as this machine is. */
static void write_ply(const struct aob_mesh *mesh, double scale, struct aob_vec3 move, const char *path)
{
    struct aob_text text = {0};
    aob_text_add(
        &text,
        "ply\nformat binary_little_endian 1.0\nelement vertex %zu\nproperty float x\nproperty float "
        "y\nproperty float z\nelement face %zu\nproperty list uchar int vertex_indices\nend_header\n",
        mesh->vertex_count, mesh->triangle_count);
    size_t size = text.size + mesh->vertex_count * 12 + mesh->triangle_count * 13;
    char *bytes = aob_alloc(size, 1), *at = bytes + text.size;
    memcpy(bytes, text.data, text.size);
    for (size_t i = 0; i < mesh->vertex_count; i++, at += 12) {
        struct aob_vec3 p = place(mesh->positions[i], scale, move);
        const float v[3] = {(float)p.x, (float)p.y, (float)p.z};
        memcpy(at, v, sizeof v);
    }
    for (size_t i = 0; i < mesh->triangle_count; i++, at += 13) {
        *at = 3;
        memcpy(at + 1, mesh->triangles[i], sizeof mesh->triangles[i]);
    }
    assert_true(aob_file_write(path, bytes, size, NULL));
    free(bytes);
    aob_text_finish(&text);
}

static double extent(const struct aob_mesh *mesh)
{
    struct aob_vec3 low, high;
    aob_mesh_bounds(mesh, &low, &high);
    return fmax(high.x - low.x, fmax(high.y - low.y, high.z - low.z));
}

/* Loads the scene by a file of its own. */
static void load_placed(const struct aob_mesh *mesh, double scale, struct aob_vec3 move,
                        struct aob_mesh *loaded)
{
    struct paths paths;
    make_paths(&paths, "ply");
    write_ply(mesh, scale, move, paths.source);
    assert_int_equal(load(paths.source, paths.flat), LOADED);
    assert_true(aob_mesh_restore(loaded, paths.flat, NULL));
    unlink(paths.source);
    unlink(paths.flat);
}

static void trace_placed(struct shot *shot, const struct aob_mesh *mesh, struct aob_camera camera,
                         double scale, struct aob_vec3 move)
{
    struct aob_mesh loaded;
    const struct aob_visibility_term term = {.radius = 0.5 * scale};
    load_placed(mesh, scale, move, &loaded);
    camera.eye = place(camera.eye, scale, move);
    camera.target = place(camera.target, scale, move);
    cast_shot(shot, &loaded, camera, W, H);
    trace_shot(shot, &term, 1, SPP);
}

static void compare(const struct shot *here, const struct shot *there, const char *what)
{
    size_t kept = 0, pixels = pixel_count(here), surface = 0;
    double square = 0;
    for (size_t i = 0; i < pixels; i++) {
        surface += here->hits.primitive[i] != AOB_NO_PRIMITIVE;
        if (here->hits.primitive[i] != there->hits.primitive[i])
            continue;
        kept++;
        square += pow((double)(here->visibility[0].ao[i] - there->visibility[0].ao[i]), 2);
    }
    double share = (double)kept / (double)pixels, rmse = sqrt(square / (double)kept);
    printf("%s: %.2f %% of the pixels keep their primitive, RMSE %.5f over them\n", what, 100 * share, rmse);
    assert_true(surface > pixels / 2);
    assert_true(share >= 0.995);
    assert_true(rmse <= 0.003);
}

static void check_scene(const char *name, const char *view)
{
    const struct aob_scene_info *scene = aob_scene_find(name);
    struct aob_mesh mesh = {0};
    struct shot here;
    scene->build(&mesh);
    double far = 100 * extent(&mesh);
    const struct {
        double scale;
        struct aob_vec3 move;
    } variants[] = {{1e-3, {0, 0, 0}}, {1e3, {0, 0, 0}}, {1, {far, 0, 0}}, {1, {-far, far, far}}};
    trace_placed(&here, &mesh, aob_scene_view(scene, view)->camera, 1, aob_vec(0, 0, 0));
    for (size_t v = 0; v < AOB_COUNT(variants); v++) {
        struct shot there;
        char what[96];
        snprintf(what, sizeof what, "%s/%s x %g + (%g, %g, %g)", name, view, variants[v].scale,
                 variants[v].move.x, variants[v].move.y, variants[v].move.z);
        trace_placed(&there, &mesh, aob_scene_view(scene, view)->camera, variants[v].scale, variants[v].move);
        compare(&here, &there, what);
        finish_shot(&there);
    }
    finish_shot(&here);
    aob_mesh_finish(&mesh);
}

static void a_room_keeps_its_reference(void **state)
{
    (void)state;
    check_scene("cornell", "blocks");
}

static void a_machine_keeps_its_reference(void **state)
{
    (void)state;
    check_scene("machine", "train");
}

/* Its file's first number is -0.01, whose first byte is a line end. */
static void a_hall_keeps_its_reference(void **state)
{
    (void)state;
    check_scene("atrium", "column");
}

/* One line, with the spacing of 32-bit floats there; at 100 extents none. */
static void far_vertices_are_warned_of(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    aob_scene_find("cornell")->build(&mesh);
    for (int thousands = 0; thousands < 2; thousands++) {
        struct aob_error warnings[AOB_MESH_WARNINGS] = {{{0}}};
        struct aob_mesh loaded;
        double move = (thousands ? 1e4 : 100) * extent(&mesh); /* 2 m: 20 km, where floats are 2^-9 m apart */
        load_placed(&mesh, 1, aob_vec(0, 0, move), &loaded);
        assert_int_equal(aob_mesh_suspect(&loaded, "room.ply", warnings), thousands);
        if (thousands) {
            printf("%s\n", warnings[0].text);
            assert_non_null(strstr(warnings[0].text, "room.ply"));
            assert_non_null(strstr(warnings[0].text, "rounded to steps of 0.002;"));
        }
        aob_mesh_finish(&loaded);
    }
    aob_mesh_finish(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_room_keeps_its_reference),
        cmocka_unit_test(a_machine_keeps_its_reference),
        cmocka_unit_test(a_hall_keeps_its_reference),
        cmocka_unit_test(far_vertices_are_warned_of),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
