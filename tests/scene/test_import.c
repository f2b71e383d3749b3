/* Loading by assimp, each time in a child process as its header demands. */
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "base/file.h"
#include "scene/gltf_document.h"
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

static double middle_side(const struct aob_mesh *mesh)
{
    struct aob_vec3 low, high;
    aob_mesh_bounds(mesh, &low, &high);
    double x = high.x - low.x, y = high.y - low.y, z = high.z - low.z;
    return fmax(fmin(x, y), fmin(fmax(x, y), z));
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
        double metre = fmin(1 / (*s)->metres_per_unit, 0.5 * middle_side(&mesh)); /* scene.h; in two digits */
        assert_true((*s)->metre <= 1.02 * metre && (*s)->metre >= 0.98 * metre);
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

/* What assimp makes of a wrong face is not what the file says, so one line tells it; a material that is missing is none. */
static void wrong_faces_are_told(void **state)
{
    struct aob_error lines[AOB_MESH_WARNINGS];
    struct aob_mesh mesh;
    (void)state;
    load_text(&mesh, "off", "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 1 9\n");
    assert_int_equal(aob_mesh_suspect(&mesh, "box", lines), 1);
    assert_string_equal(lines[0].text,
                        "box: its shape lacks something, or is wrong: OFF: Vertex index is out of range");
    aob_mesh_finish(&mesh);
    load_text(&mesh, "obj", "mtllib gone.mtl\nusemtl gone\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_int_equal(aob_mesh_suspect(&mesh, "box", lines), 0);
    aob_mesh_finish(&mesh);
}

/* A PLY whose vertices lack an axis would be flat; the same names below another element do not help, nor does w. */
static void a_ply_has_three_axes(void **state)
{
    (void)state;
    static const struct {
        const char *properties, *why;
    } cases[] = {
        {"property float y\nproperty float z\nproperty float w\n", "no property x"},
        {"property float x\nproperty float z\nproperty float w\n", "no property y"},
        {"property float x\r\nproperty float y\r\nproperty float w\r\n", "no property z"},
    };
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_text text = {0};
        struct aob_error error;
        aob_text_add(&text,
                     "ply\nformat ascii 1.0\nelement vertex 3\n%selement face 1\nproperty list uchar int "
                     "vertex_indices\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
                     "0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0 0 0\n",
                     cases[i].properties);
        refuse_text("ply", text.data, &error);
        assert_contains(error.text, cases[i].why);
        aob_text_finish(&text);
    }
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

/* A box of 1 x 2 x 3 as COLLADA, below a node of this matrix. */
static void mirrors_turn_the_winding_in_other_formats(void **state)
{
    static const char *const matrices[] = {"1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1",
                                           "-1 0 0 4 0 1 0 0 0 0 1 0 0 0 0 1",
                                           "0 1 0 0 1 0 0 0 0 0 1 0 0 0 0 1"};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(matrices); i++) {
        struct aob_text text = {0};
        struct aob_mesh mesh;
        aob_text_add(
            &text,
            "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
            "version='1.4.1'><asset><up_axis>Y_UP</up_axis></asset><library_geometries><geometry id='g'>"
            "<mesh><source id='p'><float_array id='a' count='24'>");
        for (int k = 0; k < 8; k++) {
            float corner[3];
            box_corner(k, corner);
            for (int c = 0; c < 3; c++)
                aob_text_add(&text, "%g ", (double)corner[c]);
        }
        aob_text_add(&text,
                     "</float_array><technique_common><accessor source='#a' count='8' stride='3'><param "
                     "name='X' type='float'/><param name='Y' type='float'/><param name='Z' type='float'/>"
                     "</accessor></technique_common></source><vertices id='v'><input semantic='POSITION' "
                     "source='#p'/></vertices><triangles count='12'><input semantic='VERTEX' source='#v' "
                     "offset='0'/><p>");
        for (int k = 0; k < 36; k++)
            aob_text_add(&text, "%d ", box_indices[k]);
        aob_text_add(&text,
                     "</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>"
                     "<visual_scene id='s'><node><matrix>%s</matrix><instance_geometry url='#g'/></node>"
                     "</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene>"
                     "</COLLADA>",
                     matrices[i]);
        load_text(&mesh, "dae", text.data);
        assert_int_equal(mesh.triangle_count, 12);
        assert_true(fabs(mesh_volume(&mesh) - 6) < 1e-6);
        assert_normals_outside(&mesh);
        aob_mesh_finish(&mesh);
        aob_text_finish(&text);
    }
}

enum { CELLS = 10, GRID = (CELLS + 1) * (CELLS + 1) };
static const int notched[6][2] = {{0, -1}, {0, -3}, {2, -3}, {2, -2}, {1, -2}, {1, -1}}; /* 3 cells large */

static void add_place(struct aob_text *text, const char *before, double cell, int i)
{
    int x = i < GRID ? i % (CELLS + 1) : notched[i - GRID][0],
        y = i < GRID ? i / (CELLS + 1) : notched[i - GRID][1];
    aob_text_add(text, "%s%.9g %.9g 0\n", before, x * cell, y * cell);
}

static void add_faces(struct aob_text *text, const char *before[2], int first)
{
    for (int y = 0; y < CELLS; y++)
        for (int x = 0; x < CELLS; x++) {
            int at = first + y * (CELLS + 1) + x;
            aob_text_add(text, "%s%d %d %d %d\n", before[0], at, at + 1, at + CELLS + 2, at + CELLS + 1);
        }
    aob_text_add(text, "%s", before[1]);
    for (int k = 0; k < 6; k++)
        aob_text_add(text, "%d%s", first + GRID + k, k < 5 ? " " : "\n");
}

/* A grid, and a hexagon with a notch: nothing is joined that is apart, no triangle is taken for a line, and the area is
 * whole, whatever the unit. */
static void tiny_and_large_units_lose_nothing(void **state)
{
    static const double cells[] = {1e-12, 1e-7, 1, 1e9};
    (void)state;
    for (size_t i = 0; i < 2 * AOB_COUNT(cells); i++) {
        double cell = cells[i / 2], area = 0;
        bool obj = i % 2;
        struct aob_text text = {0};
        struct aob_mesh mesh;
        if (!obj)
            aob_text_add(
                &text,
                "ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
                "property float z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n",
                GRID + 6, CELLS * CELLS + 1);
        for (int k = 0; k < GRID + 6; k++)
            add_place(&text, obj ? "v " : "", cell, k);
        add_faces(&text, obj ? (const char *[]){"f ", "f "} : (const char *[]){"4 ", "6 "}, obj);
        load_text(&mesh, obj ? "obj" : "ply", text.data);
        assert_int_equal(mesh.triangle_count, 2 * CELLS * CELLS + 4);
        assert_int_equal(mesh.vertex_count, GRID + 6);
        for (size_t t = 0; t < mesh.triangle_count; t++) {
            const uint32_t *c = mesh.triangles[t];
            area += aob_vec_cross(aob_vec_sub(mesh.positions[c[1]], mesh.positions[c[0]]),
                                  aob_vec_sub(mesh.positions[c[2]], mesh.positions[c[0]]))
                        .z /
                    2;
        }
        assert_true(fabs(area / (cell * cell) - (CELLS * CELLS + 3)) < 1e-4);
        aob_mesh_finish(&mesh);
        aob_text_finish(&text);
    }
}

/* Two quads that meet at `degrees`: over 60 degrees their edge is sharp; each end of it is then two vertices. */
static void normals_are_made_within_60_degrees(void **state)
{
    static const struct {
        double degrees;
        size_t vertices;
    } cases[] = {{0, 6}, {30, 6}, {59, 6}, {61, 8}, {90, 8}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_text text = {0};
        struct aob_mesh mesh;
        double turn = cases[i].degrees * (M_PI / 180);
        aob_text_add(&text, "v -1 0 0\nv 0 0 0\nv 0 1 0\nv -1 1 0\nv %.9f 0 %.9f\nv %.9f 1 %.9f\n", cos(turn),
                     -sin(turn), cos(turn), -sin(turn));
        aob_text_add(&text, "f 1 2 3 4\nf 2 5 6 3\n");
        load_text(&mesh, "obj", text.data);
        assert_int_equal(mesh.vertex_count, cases[i].vertices);
        for (size_t v = 0; v < mesh.vertex_count; v++) {
            struct aob_vec3 p = mesh.positions[v], n = mesh.normals[v];
            double lean = atan2(n.x, n.z), of_turned = p.y == 0 ? 2 : 1; /* triangles there, of three */
            if (p.x == 0 && cases[i].vertices == 6)
                assert_true(fabs(lean - atan2(of_turned * sin(turn), 3 - of_turned + of_turned * cos(turn))) <
                            1e-6);
            else
                assert_true(fabs(lean) < 1e-6 || fabs(lean - turn) < 1e-6);
        }
        aob_mesh_finish(&mesh);
        aob_text_finish(&text);
    }
}

/* Of two packaged files the first is a cage of subdivision patches. */
static void what_is_left_out_is_said(void **state)
{
    static const struct {
        const char *file, *said;
    } cases[] = {{"/usr/share/assimp/models/LWO/LWO2/Subdivision.lwo", "subdivision is not applied"},
                 {"/usr/share/assimp/models/FBX/animation_with_skeleton.fbx", "bones are not applied"},
                 {"/usr/share/assimp/models/FBX/box.fbx", NULL}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct paths paths;
        struct aob_mesh mesh;
        struct aob_error lines[AOB_MESH_WARNINGS];
        make_paths(&paths, "obj");
        assert_int_equal(load(cases[i].file, paths.flat), LOADED); /* ./dev installs these */
        assert_true(aob_mesh_restore(&mesh, paths.flat, NULL));
        assert_int_equal(aob_mesh_suspect(&mesh, "mesh", lines), cases[i].said != NULL);
        if (cases[i].said)
            assert_non_null(strstr(lines[0].text, cases[i].said));
        aob_mesh_finish(&mesh);
        unlink(paths.flat);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bunny_is_as_published),
        cmocka_unit_test(packaged_meshes_have_the_triangles_of_their_titles),
        cmocka_unit_test(obj_polygons_become_triangles),
        cmocka_unit_test(ply_is_read),
        cmocka_unit_test(wrong_faces_are_told),
        cmocka_unit_test(a_ply_has_three_axes),
        cmocka_unit_test(bad_files_are_refused_with_one_line),
        cmocka_unit_test(truncated_files_are_sound_or_refused),
        cmocka_unit_test(mirrors_turn_the_winding_in_other_formats),
        cmocka_unit_test(what_is_left_out_is_said),
        cmocka_unit_test(tiny_and_large_units_lose_nothing),
        cmocka_unit_test(normals_are_made_within_60_degrees),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
