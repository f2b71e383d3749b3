/* Documents and buffers of glTF 2.0 files: where they are found, and what is refused in one line. */
#include "gltf_document.h"
#include <stdlib.h>
#include "check.h"
#include "scene/source.h"

static void unknown_extensions_are_named(void **state)
{
    (void)state;
    struct document d = {0};
    struct aob_error error, lines[AOB_MESH_WARNINGS];
    struct aob_mesh mesh;
    document_put_box(&d);
    add_scene(&d, "", BOX, ", 'extensionsRequired': ['KHR_mesh_quantization', 'EXT_round_corners']");
    document_refuse(&d, &error);
    assert_contains(error.text, "EXT_round_corners");
    document_put_box(&d);
    add_scene(&d, "", BOX ", 'extensions': {'EXT_round_corners': {}, 'KHR_materials_variants': {}}", "");
    document_load(&d, &mesh);
    assert_int_equal(aob_mesh_suspect(&mesh, "box", lines), 1);
    assert_contains(lines[0].text, "box: the extension EXT_round_corners of its primitives is not applied");
    aob_mesh_finish(&mesh);
    document_put_box(&d);
    add_scene(&d, ", 'extensions': {'KHR_lights_punctual': {'light': 0}}", BOX,
              ", 'extensionsUsed': ['KHR_lights_punctual', 'EXT_round_corners']");
    document_load(&d, &mesh);
    assert_int_equal(aob_mesh_suspect(&mesh, "box", lines), 0);
    aob_mesh_finish(&mesh);
}

/* It is placed as its node says. */
static void a_skin_without_joints_is_named(void **state)
{
    (void)state;
    struct document d = {0};
    struct aob_error lines[AOB_MESH_WARNINGS];
    struct aob_mesh mesh;
    document_put_box(&d);
    add_scene(&d, ", 'skin': 0, 'translation': [5, 0, 0]", BOX, ", 'skins': [{'joints': [0]}]");
    document_load(&d, &mesh);
    assert_int_equal(aob_mesh_suspect(&mesh, "box", lines), 1);
    assert_contains(lines[0].text, "box: a primitive of a skinned node has no joints or weights");
    for (size_t i = 0; i < mesh.vertex_count; i++)
        assert_true(mesh.positions[i].x >= 5 && mesh.positions[i].x <= 6);
    aob_mesh_finish(&mesh);
}

static void broken_documents_are_refused(void **state)
{
    static const struct {
        const char *node, *primitive, *more, *why;
    } cases[] = {
        {"", "'attributes': {'POSITION': 7}, 'indices': 1", "", "number 7 of its 2 accessors"},
        {"", "'attributes': {'POSITION': 0.5}, 'indices': 1", "", "no whole number"},
        {", 'extensions': {'EXT_mesh_gpu_instancing': {'attributes': {'ROTATION': 0}}}", BOX, "",
         "accessor 0 has 3 numbers an element in place of 4"},
        {"", BOX ", 'mode': 9", "", "mode 9"},
        {", 'children': [0]", BOX, "", "below itself"},
        {", 'skin': 3", BOX, "", "3 of its 0 skins"},
        {", 'rotation': [0.6, 0, 1, 0.8]", BOX, "", "no unit quaternion"},
        {"", BOX ", 'material': 2", "", "2 of its 0 materials"},
    };
    struct aob_error error;
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct document d = {0};
        document_put_box(&d);
        add_scene(&d, cases[i].node, cases[i].primitive, cases[i].more);
        document_refuse(&d, &error);
        assert_contains(error.text, cases[i].why);
    }
    struct document twice = {0};
    document_put_box(&twice);
    aob_text_add(&twice.rest, "'scenes': [{'nodes': [0, 0]}], 'nodes': [{'mesh': 0}], " MESH);
    document_refuse(&twice, &error);
    assert_contains(error.text, "node 0 is twice");
    refuse_text("gltf", "{\"asset\": {\"version\": \"3.0\"}}", &error);
    assert_contains(error.text, "3.0");
    refuse_text("glb", "glTF", &error);
    assert_contains(error.text, "cut off");
}

/* What is cached of a document is made anew when its buffer changes. */
static void assert_digest_knows(const char *json, const char *buffer)
{
    struct paths paths;
    char keys[2][AOB_KEY_SIZE];
    make_paths(&paths, "gltf");
    assert_true(aob_file_write(paths.source, json, strlen(json), NULL));
    assert_true(aob_source_digest(NULL, paths.source, keys[0], NULL));
    assert_true(aob_file_write(buffer, "other", 5, NULL));
    assert_true(aob_source_digest(NULL, paths.source, keys[1], NULL));
    assert_string_not_equal(keys[0], keys[1]);
    unlink(paths.source);
}

/* Where the buffer lies: beside the document, under a name that a URI has to encode, encoded or not; in a .glb. */
static void buffers_are_found(void **state)
{
    static const char *const uris[] = {"aob%20test%C3%A9%20buffer.bin", "aob test\xc3\xa9 buffer.bin"};
    static const char file[] = "/tmp/aob test\xc3\xa9 buffer.bin";
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(uris); i++) {
        struct document d = {0};
        struct aob_mesh mesh;
        document_put_box(&d);
        add_scene(&d, "", BOX, "");
        char *json = document_json(&d, uris[i]);
        assert_true(aob_file_write(file, d.bytes.data, d.bytes.size, NULL));
        assert_digest_knows(json, file);
        assert_true(aob_file_write(file, d.bytes.data, d.bytes.size, NULL));
        load_text(&mesh, "gltf", json);
        assert_box(&mesh, 12, origin, far_corner, 0);
        aob_mesh_finish(&mesh);
        unlink(file);
        free(json);
        document_finish(&d);
    }
}

static void binary_files_are_read(void **state)
{
    (void)state;
    struct document d = {0};
    struct aob_text glb = {0};
    struct paths paths;
    struct aob_mesh mesh;
    struct aob_error error;
    document_put_box(&d);
    add_scene(&d, "", BOX, "");
    document_binary(&d, &glb);
    document_finish(&d);
    make_paths(&paths, "glb");
    assert_true(aob_file_write(paths.source, glb.data, glb.size, NULL));
    assert_int_equal(load(paths.source, paths.flat), LOADED);
    assert_true(aob_mesh_restore(&mesh, paths.flat, NULL));
    assert_box(&mesh, 12, origin, far_corner, 0);
    aob_mesh_finish(&mesh);
    for (size_t cut = 0; cut < glb.size; cut += 1 + cut / 8) {
        assert_true(aob_file_write(paths.source, glb.data, cut, NULL));
        refuse_file(paths.source, &error);
    }
    unlink(paths.source);
    unlink(paths.flat);
    aob_text_finish(&glb);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unknown_extensions_are_named), cmocka_unit_test(a_skin_without_joints_is_named),
        cmocka_unit_test(broken_documents_are_refused), cmocka_unit_test(buffers_are_found),
        cmocka_unit_test(binary_files_are_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
