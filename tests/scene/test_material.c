/* Materials of files, and node transforms: every file here is written by the test. */
#include "scene/load.h"
#include <math.h>
#include <stdlib.h>
#include "base/hash.h"
#include "base/memory.h"
#include "scene/scene.h"
#include "scene/source.h"

/* One triangle (0,0,0), (1,0,0), (0,1,0): three vectors of floats and three short indices. */
#define BUFFER                                                                                               \
    "'buffers': [{'byteLength': 42, 'uri': 'data:application/octet-stream;base64,"                           \
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA'}],"                                           \
    "'bufferViews': [{'buffer': 0, 'byteLength': 36}, {'buffer': 0, 'byteOffset': 36, 'byteLength': 6}],"    \
    "'accessors': [{'bufferView': 0, 'componentType': 5126, 'count': 3, 'type': 'VEC3', 'min': [0, 0, 0],"   \
    " 'max': [1, 1, 0]}, {'bufferView': 1, 'componentType': 5123, 'count': 3, 'type': 'SCALAR'}]"
#define TRIANGLE "'attributes': {'POSITION': 0}, 'indices': 1"

static void load_gltf(struct aob_mesh *mesh, const char *text)
{
    char *json = strdup(text);
    for (char *c = json; *c; c++)
        if (*c == '\'')
            *c = '"';
    load_text(mesh, "gltf", json);
    free(json);
}

static void assert_material(const struct aob_material *m, double r, double g, double b, double roughness,
                            double metalness)
{
    const double wanted[5] = {r, g, b, roughness, metalness};
    const float got[5] = {m->base_colour[0], m->base_colour[1], m->base_colour[2], m->roughness,
                          m->metalness};
    for (int i = 0; i < 5; i++)
        if (!(fabs((double)got[i] - wanted[i]) < 1e-6))
            fail_msg("number %d of the material is %g, not %g", i, (double)got[i], wanted[i]);
}

/* The triangle whose first corner lies at x. */
static const struct aob_material *material_at(const struct aob_mesh *mesh, double x)
{
    for (uint32_t i = 0; i < mesh->triangle_count; i++)
        if (fabs(mesh->positions[mesh->triangles[i][0]].x - x) < 1e-6)
            return aob_mesh_material(mesh, i);
    fail_msg("no triangle at %g", x);
    return NULL;
}

static const char many[] =
    "{'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0, 1, 2, 3]}], 'nodes': [{'mesh': 0},"
    "{'mesh': 1, 'translation': [5, 0, 0]}, {'mesh': 2, 'translation': [7, 0, 0]},"
    "{'mesh': 3, 'translation': [9, 0, 0]}],"
    "'meshes': [{'primitives': [{" TRIANGLE ", 'material': 0}]}, {'primitives': [{" TRIANGLE
    ", 'material': 1}]}, {'primitives': [{" TRIANGLE ", 'material': 2}]}, {'primitives': [{" TRIANGLE "}]}],"
    "'materials': [{'pbrMetallicRoughness': {'baseColorFactor': [0.1, 0.2, 0.3, 1], 'metallicFactor': 0.25,"
    "'roughnessFactor': 0.75}}, {'pbrMetallicRoughness': {'baseColorFactor': [1.5, -0.5, 0.5, 1],"
    "'metallicFactor': 7, 'roughnessFactor': -1}}, {'name': 'bare'}]," BUFFER "}";

static void gltf_factors_are_read(void **state)
{
    (void)state;
    struct aob_mesh mesh;
    load_gltf(&mesh, many);
    assert_int_equal(mesh.triangle_count, 4);
    assert_material(material_at(&mesh, 0), 0.1, 0.2, 0.3, 0.75, 0.25);
    assert_material(material_at(&mesh, 5), 1, 0, 0.5, 0, 1);
    assert_int_equal(mesh.note_count, 1); /* once, of however many numbers */
    assert_string_equal(mesh.notes[0].text,
                        "a material's base colour, roughness or metalness is not within 0..1: such "
                        "numbers are clamped to that");
    assert_material(material_at(&mesh, 7), 1, 1, 1, 1, 1); /* the defaults of glTF 2.0 */
    assert_material(material_at(&mesh, 9), 0.8, 0.8, 0.8, 1, 0);
    aob_mesh_finish(&mesh);
}

/* Scaled by 2, 3, 4, turned by 90 degrees about y (x to -z), moved by 10 along x; each by a node of its own. */
static void nested_transforms_are_applied(void **state)
{
    (void)state;
    static const struct aob_vec3 wanted[3] = {{10, 0, 0}, {10, 0, -2}, {10, 3, 0}};
    struct aob_mesh mesh;
    load_gltf(&mesh,
              "{'asset': {'version': '2.0'}, 'scene': 0, 'scenes': [{'nodes': [0]}], 'nodes': ["
              "{'translation': [10, 0, 0], 'children': [1]},"
              "{'rotation': [0, 0.70710678118654752, 0, 0.70710678118654752], 'children': [2]},"
              "{'scale': [2, 3, 4], 'mesh': 0}], 'meshes': [{'primitives': [{" TRIANGLE "}]}]," BUFFER "}");
    assert_int_equal(mesh.triangle_count, 1);
    for (int k = 0; k < 3; k++)
        assert_true(aob_vec_length(aob_vec_sub(mesh.positions[mesh.triangles[0][k]], wanted[k])) < 1e-5);
    assert_null(mesh.materials);
    aob_mesh_finish(&mesh);
}

static char library[64];

static void write_library(const char *text)
{
    snprintf(library, sizeof library, "/tmp/aob_test_material_%ld.mtl", (long)getpid());
    assert_true(aob_file_write(library, text, strlen(text), NULL));
}

static char *obj_text(const char *rest)
{
    struct aob_text text = {0};
    aob_text_add(&text,
                 "mtllib aob_test_material_%ld.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\n"
                 "v 5 1 0\nv 7 0 0\nv 8 0 0\nv 7 1 0\n%s",
                 (long)getpid(), rest);
    return text.data;
}

static const char painted[] = "usemtl grey\nf 1 2 3\nusemtl red\nf 4 5 6\nusemtl metal\nf 7 8 9\n";
static const char paints[] =
    "newmtl grey\nKd 0.6 0.6 0.6\nnewmtl red\nKd 0.9 0.1 0.05\nnewmtl metal\nKd 0.5 0.5 2\nPr 0.3\nPm 1\n";

static void obj_materials_are_read(void **state)
{
    (void)state;
    struct aob_mesh mesh;
    char *text = obj_text(painted);
    write_library(paints);
    load_text(&mesh, "obj", text);
    assert_int_equal(mesh.triangle_count, 3);
    assert_material(material_at(&mesh, 0), 0.6, 0.6, 0.6, 1, 0);
    assert_material(material_at(&mesh, 5), 0.9, 0.1, 0.05, 1, 0);
    assert_material(material_at(&mesh, 7), 0.5, 0.5, 1, 0.3, 1);
    aob_mesh_finish(&mesh);
    unlink(library); /* without it: a mesh all the same */
    load_text(&mesh, "obj", text);
    assert_int_equal(mesh.triangle_count, 3);
    assert_material(material_at(&mesh, 5), 0.6, 0.6, 0.6, 1,
                    0); /* the importer's, for a name without values */
    aob_mesh_finish(&mesh);
    load_text(&mesh, "obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_null(mesh.materials);
    aob_mesh_finish(&mesh);
    free(text);
}

static void a_colour_that_is_no_number_is_refused(void **state)
{
    (void)state;
    struct paths paths;
    char *text = obj_text(painted);
    make_paths(&paths, "obj");
    write_library("newmtl red\nKd nan 0 0\n");
    assert_true(aob_file_write(paths.source, text, strlen(text), NULL));
    assert_int_equal(load(paths.source, paths.flat), REFUSED);
    unlink(paths.source);
    unlink(library);
    free(text);
}

/* What is cached of an OBJ holds its colours. */
static void the_digest_knows_the_library(void **state)
{
    (void)state;
    struct paths paths;
    char keys[3][AOB_KEY_SIZE], *text = obj_text(painted);
    make_paths(&paths, "obj");
    assert_true(aob_file_write(paths.source, text, strlen(text), NULL));
    for (int i = 0; i < 3; i++) {
        write_library(i == 1 ? "newmtl red\nKd 0 1 0\n" : paints);
        assert_true(aob_source_digest(NULL, paths.source, keys[i], NULL));
    }
    assert_string_not_equal(keys[0], keys[1]);
    assert_string_equal(keys[0], keys[2]);
    unlink(paths.source);
    unlink(library);
    free(text);
}

static void ply_colours_are_averaged(void **state)
{
    (void)state;
    struct aob_mesh mesh;
    load_text(
        &mesh, "ply",
        "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 255 0 51\n1 0 0 0 255 51\n0 1 0 0 0 51\n"
        "5 0 0 102 0 0\n6 0 0 102 0 0\n5 1 0 102 0 0\n3 0 1 2\n3 3 4 5\n");
    assert_int_equal(mesh.triangle_count, 2);
    assert_material(material_at(&mesh, 0), 1 / 3.0, 1 / 3.0, 0.2, 1, 0);
    assert_material(material_at(&mesh, 5), 0.4, 0, 0, 1, 0);
    aob_mesh_finish(&mesh);
    load_text(
        &mesh, "ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    assert_null(mesh.materials);
    aob_mesh_finish(&mesh);
}

static void what_has_a_light_and_cornell_are_painted(void **state)
{
    (void)state;
    size_t red = 0, green = 0;
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++) {
        struct aob_mesh mesh = {0};
        if (!(*s)->build)
            continue;
        (*s)->build(&mesh);
        assert_int_equal(mesh.materials != NULL, (*s)->light || strcmp((*s)->name, "cornell") == 0);
        for (uint32_t i = 0; !(*s)->light && mesh.materials && i < mesh.triangle_count; i++) {
            const struct aob_material *m = aob_mesh_material(&mesh, i);
            double x = mesh.positions[mesh.triangles[i][1]].x;
            assert_true(fabs(x) <= 1);
            if (m->base_colour[0] > 4 * m->base_colour[1]) {
                assert_true(x == -1);
                red++;
            } else if (m->base_colour[1] > 2 * m->base_colour[0]) {
                assert_true(x == 1);
                green++;
            } else
                assert_material(m, 0.725, 0.71, 0.68, 1, 0);
        }
        aob_mesh_finish(&mesh);
    }
    assert_true(red == 2 && green == 2);
}

/* The bounds of all triangles' materials, and how many triangles are of metal. */
static size_t range_of(const char *scene, struct aob_material *low, struct aob_material *high)
{
    struct aob_mesh mesh = {0};
    size_t metal = 0;
    aob_scene_find(scene)->build(&mesh);
    *low = *high = *aob_mesh_material(&mesh, 0);
    for (uint32_t i = 0; i < mesh.triangle_count; i++) {
        const struct aob_material *m = aob_mesh_material(&mesh, i);
        for (int c = 0; c < 3; c++) {
            low->base_colour[c] = fminf(low->base_colour[c], m->base_colour[c]);
            high->base_colour[c] = fmaxf(high->base_colour[c], m->base_colour[c]);
        }
        low->roughness = fminf(low->roughness, m->roughness);
        high->roughness = fmaxf(high->roughness, m->roughness);
        metal += m->metalness > 0;
    }
    aob_mesh_finish(&mesh);
    return metal;
}

static void lit_scenes_are_of_what_their_titles_say(void **state)
{
    (void)state;
    struct aob_material low, high;
    static const struct {
        const char *scene;
        double colour;
    } plain[] = {{"matte_white_room", 0.85}, {"matte_dark_room", 0.05}, {"window_room", 0.7}};
    for (size_t i = 0; i < AOB_COUNT(plain); i++) {
        double c = plain[i].colour;
        assert_int_equal(range_of(plain[i].scene, &low, &high), 0);
        assert_material(&low, c, c, c, 1, 0);
        assert_material(&high, c, c, c, 1, 0);
    }
    assert_int_equal(range_of("rocks", &low, &high), 0);
    assert_material(&low, 0.35, 0.33, 0.3, 1, 0);
    assert_material(&high, 0.35, 0.33, 0.3, 1, 0);
    range_of("coloured_walls", &low, &high);
    assert_material(&low, 0.05, 0.05, 0.04, 1, 0);
    assert_material(&high, 0.8, 0.8, 0.8, 1, 0);
    assert_int_equal(range_of("gallery", &low, &high), 96 * 94); /* the ball */
    assert_true(low.roughness == 0.2f && high.roughness == 0.9f);
    assert_int_equal(range_of("thicket", &low, &high), 0);
    assert_true(low.roughness == 0.7f && high.roughness == 1);
}

static void paint_begins_where_it_is_called(void **state)
{
    (void)state;
    struct aob_mesh mesh = {0};
    struct aob_vec3 x = aob_vec(1, 0, 0), y = aob_vec(0, 1, 0);
    const struct aob_material blue = {.base_colour = {0, 0, 1}, .roughness = 0.5f};
    char plain[AOB_KEY_SIZE], coloured[AOB_KEY_SIZE];
    aob_mesh_add_quad(&mesh, aob_vec(0, 0, 0), x, y);
    aob_mesh_paint(&mesh, aob_material_default);
    assert_null(mesh.materials);
    aob_mesh_digest(&mesh, plain);
    aob_mesh_paint(&mesh, blue);
    aob_mesh_digest(&mesh, coloured);
    assert_string_not_equal(plain, coloured);
    for (int i = 0; i < 40; i++)
        aob_mesh_add_quad(&mesh, aob_vec(0, 0, i), x, y);
    aob_mesh_paint(&mesh, aob_material_default);
    aob_mesh_add_quad(&mesh, aob_vec(0, 0, 0), x, y);
    aob_mesh_paint(&mesh, blue);
    assert_int_equal(mesh.material_count, 2);
    for (uint32_t i = 0; i < mesh.triangle_count; i++)
        assert_int_equal(aob_mesh_material_index(&mesh, i), i >= 2 && i < 82);
    assert_true(aob_mesh_check(&mesh, "painted", NULL));
    mesh.material_of[5] = 2;
    assert_false(aob_mesh_check(&mesh, "painted", NULL));
    mesh.material_of[5] = 1;
    mesh.materials[1].roughness = NAN;
    assert_false(aob_mesh_check(&mesh, "painted", NULL));
    aob_mesh_finish(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gltf_factors_are_read),
        cmocka_unit_test(nested_transforms_are_applied),
        cmocka_unit_test(obj_materials_are_read),
        cmocka_unit_test(a_colour_that_is_no_number_is_refused),
        cmocka_unit_test(the_digest_knows_the_library),
        cmocka_unit_test(ply_colours_are_averaged),
        cmocka_unit_test(what_has_a_light_and_cornell_are_painted),
        cmocka_unit_test(lit_scenes_are_of_what_their_titles_say),
        cmocka_unit_test(paint_begins_where_it_is_called),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
