/* Documents that the format forbids are refused in one line that names the member. */
#include <stdlib.h>
#include "check.h"
#include "scene/gltf_document.h"

struct refusal {
    const char *node, *primitive, *more, *why;
};

static void refuse_each(const struct refusal *cases, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        struct document d = {0};
        struct aob_error error;
        document_put_box(&d);
        add_scene(&d, cases[i].node, cases[i].primitive, cases[i].more);
        document_refuse(&d, &error);
        assert_contains(error.text, cases[i].why);
    }
}

static void wrong_members_are_named(void **state)
{
    static const struct refusal cases[] = {
        {", 'scale': [2, 2]", BOX, "", ": node 0: its scale is not 3 numbers"},
        {", 'rotation': [0, 0, 0.7]", BOX, "", ": node 0: its rotation is not 4 numbers"},
        {", 'translation': ['1', 2, 3]", BOX, "", ": node 0: its translation is not 3 numbers"},
        {", 'matrix': [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0]", BOX, "",
         ": node 0: its matrix is not 16 numbers"},
        {", 'matrix': [1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]", BOX, "",
         ": node 0: the last row of its matrix is not 0 0 0 1"},
        {"", BOX ", 'material': 0", ", 'materials': [{'pbrMetallicRoughness': {'baseColorFactor': [1]}}]",
         ": a material: its baseColorFactor is not 4 numbers"},
        {", 'scale': [1e300, 1, 1]", BOX, "", "is not finite or exceeds a float"},
        {", 'extensions': {'EXT_mesh_gpu_instancing': {'attributes': {'_ID': 0}}}", BOX, "",
         ": its instances have no TRANSLATION, ROTATION or SCALE"},
    };
    (void)state;
    refuse_each(cases, AOB_COUNT(cases));
}

static void short_strides_are_named(void **state)
{
    struct document d = {0};
    struct aob_error error;
    (void)state;
    document_put_box(&d);
    char *at = strstr(d.views.data, "'byteStride': 12");
    assert_non_null(at);
    memcpy(at, "'byteStride':  8", 16);
    add_scene(&d, "", BOX, "");
    document_refuse(&d, &error);
    assert_contains(error.text, "accessor 0: its byteStride 8 is less than its 12 bytes");
}

/* What is of another kind of JSON than the format says would be read as if it were not there. */
static void wrong_kinds_are_named(void **state)
{
    static const struct refusal cases[] = {
        {", 'children': 5", BOX, "", ": nodes[0].children is no array"},
        {", 'weights': ['1']", BOX, "", ": nodes[0].weights[0] is no number"},
        {", 'weights': 1", BOX, "", ": nodes[0].weights is no array"},
        {", 'extensions': []", BOX, "", ": nodes[0].extensions is no object"},
        {", 'extensions': {'EXT_mesh_gpu_instancing': {}}", BOX, "",
         ": nodes[0].extensions.EXT_mesh_gpu_instancing.attributes is missing"},
        {", 'extensions': {'KHR_node_visibility': {'visible': 0}}", BOX, "",
         ": nodes[0].extensions.KHR_node_visibility.visible is neither true nor false"},
        {"", "'attributes': [0], 'indices': 1", "", ": meshes[0].primitives[0].attributes is no object"},
        {"", "'indices': 1", "", ": meshes[0].primitives[0].attributes is missing"},
        {"", BOX ", 'targets': {'POSITION': 0}", "", ": meshes[0].primitives[0].targets is no array"},
        {"", BOX ", 'targets': [0]", "", ": meshes[0].primitives[0].targets[0] is no object"},
        {"", BOX, ", 'extensionsRequired': {}", ": extensionsRequired is no array"},
        {"", BOX, ", 'extensionsRequired': [1]", ": extensionsRequired[0] is no text"},
        {"", BOX, ", 'materials': {}", ": materials is no array"},
        {"", BOX, ", 'materials': [{}, {'pbrMetallicRoughness': {'roughnessFactor': '1'}}]",
         ": materials[1].pbrMetallicRoughness.roughnessFactor is no number"},
        {"", BOX, ", 'skins': [[]]", ": skins[0] is no object"},
        {"", BOX, ", 'skins': [{'joints': 0}]", ": skins[0].joints is no array"},
    };
    (void)state;
    refuse_each(cases, AOB_COUNT(cases));
}

/* Documents of which add_scene would make whole ones. */
static void wrong_lists_are_named(void **state)
{
    static const char *const cases[][2] = {
        {"'scenes': [{'nodes': [0]}], 'nodes': {'0': {'mesh': 0}}, " MESH, ": nodes is no array"},
        {"'scenes': [{'nodes': [0]}], 'nodes': [[0]], " MESH, ": nodes[0] is no object"},
        {"'scenes': [{'nodes': 0}], 'nodes': [{'mesh': 0}], " MESH, ": scenes[0].nodes is no array"},
        {"'scenes': {}, 'nodes': [{'mesh': 0}], " MESH, ": scenes is no array"},
        {"'nodes': [{'mesh': 0}], 'meshes': {}", ": meshes is no array"},
        {"'nodes': [{'mesh': 0}], 'meshes': [7]", ": meshes[0] is no object"},
        {"'nodes': [{'mesh': 0}], 'meshes': [{}]", ": meshes[0].primitives is missing"},
        {"'nodes': [{'mesh': 0}], 'meshes': [{'primitives': [null]}]",
         ": meshes[0].primitives[0] is no object"},
        {"'nodes': [{'mesh': 0}], 'meshes': [{'weights': [0, null], 'primitives': [{" BOX "}]}]",
         ": meshes[0].weights[1] is no number"},
        {"'nodes': [{'mesh': 0}], 'meshes': [{'weights': [1], 'primitives': [{" BOX
         ", 'targets': [{'POSITION': 0}, {'POSITION': 0}]}]}]",
         ": a mesh has 1 weights for 2 morph targets"},
    };
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct document d = {0};
        struct aob_error error;
        document_put_box(&d);
        aob_text_add(&d.rest, "%s", cases[i][0]);
        document_refuse(&d, &error);
        assert_contains(error.text, cases[i][1]);
    }
}

/* Members of the arrays that the document of these tests writes by itself: FROM becomes TO. */
static void wrong_accessors_are_named(void **state)
{
    static const char *const cases[][3] = {
        {"\"accessors\": [", "\"accessors\": [0, ", ": accessors[0] is no object"},
        {"\"bufferViews\": [", "\"bufferViews\": [\"\", ", ": bufferViews[0] is no object"},
        {"\"buffers\": [{", "\"buffers\": [{\"uri\": 1}, {", ": buffers[0].uri is no text"},
        {"\"type\": \"VEC3\"", "\"type\": 3", ": accessors[0].type is no text"},
        {"\"type\": \"VEC3\"", "\"type\": \"VEC3\", \"normalized\": 1",
         ": accessors[0].normalized is neither true nor false"},
        {"\"type\": \"VEC3\"", "\"type\": \"VEC3\", \"sparse\": 0", ": accessors[0].sparse is no object"},
        {"\"type\": \"VEC3\"", "\"type\": \"VEC3\", \"sparse\": {\"indices\": {}, \"values\": {}}",
         ": accessors[0].sparse.count is missing"},
        {"\"count\": 8", "\"counts\": 8", ": accessors[0].count is missing"},
    };
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct document d = {0};
        struct aob_text text = {0};
        struct aob_error error;
        document_put_box(&d);
        add_scene(&d, "", BOX, "");
        char *json = document_json(&d, NULL), *at = strstr(json, cases[i][0]);
        assert_non_null(at);
        aob_text_add(&text, "%.*s%s%s", (int)(at - json), json, cases[i][1], at + strlen(cases[i][0]));
        refuse_text("gltf", text.data, &error);
        assert_contains(error.text, cases[i][2]);
        aob_text_finish(&text);
        document_finish(&d);
        free(json);
    }
}

/* Of 8 elements; what they hold is as right as the type. */
static void refuse_type(int component, const char *type, const char *extra, const char *primitive,
                        const char *why)
{
    static const unsigned char zeros[8 * 64] = "";
    struct document d = {0};
    struct aob_error error;
    document_put_box(&d);
    document_put(&d, zeros, strcmp(type, "SCALAR") == 0 ? 4 : 16, 8, component, type, extra);
    add_scene(&d, "", primitive, "");
    document_refuse(&d, &error);
    assert_contains(error.text, why);
}

static void wrong_types_are_named(void **state)
{
    static const char undeclared[] = "need KHR_mesh_quantization, which the file does not declare";
    static const struct {
        int component;
        const char *type, *extra, *primitive, *what, *why;
    } cases[] = {
        {F32, "SCALAR", "", "'attributes': {'POSITION': 0}, 'indices': 2",
         "indices are of componentType 5126", "the file is damaged"},
        {I8, "VEC3", ", 'normalized': true", "'attributes': {'POSITION': 2}, 'indices': 1",
         "POSITION of componentType 5120", undeclared},
        {U16, "VEC3", "", "'attributes': {'POSITION': 2}, 'indices': 1", "POSITION of componentType 5123",
         undeclared},
        {I8, "VEC3", ", 'normalized': true", "'attributes': {'POSITION': 0, 'NORMAL': 2}, 'indices': 1",
         "NORMAL of componentType 5120", undeclared},
        {U8, "VEC3", "", "'attributes': {'POSITION': 0, 'NORMAL': 2}, 'indices': 1",
         "NORMAL are of componentType 5121", "the file is damaged"},
        {U32, "VEC3", "", "'attributes': {'POSITION': 2}, 'indices': 1", "POSITION are of componentType 5125",
         "the file is damaged"},
        {U8, "VEC4", "", "'attributes': {'POSITION': 0, 'COLOR_0': 2}, 'indices': 1",
         "COLOR_0 of componentType 5121 are not normalized", "the file is damaged"},
    };
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        refuse_type(cases[i].component, cases[i].type, cases[i].extra, cases[i].primitive, cases[i].what);
        refuse_type(cases[i].component, cases[i].type, cases[i].extra, cases[i].primitive, cases[i].why);
    }
}

/* Corners that make no whole triangle: "it MUST be divisible by 3" (glTF 2.0, 3.7.2.1). */
static void cut_lists_are_named(void **state)
{
    static const struct {
        size_t count;
        const char *primitive, *why;
    } cases[] = {
        {35, BOX, ": a primitive of triangles has 35 corners, which is no multiple of 3"},
        {36, "'attributes': {'POSITION': 0}", ": a primitive of triangles has 8 corners"},
        {2, BOX ", 'mode': 5", ": a strip or fan of triangles has 2 corners"},
    };
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct document d = {0};
        struct aob_error error;
        float corners[8][3];
        for (int k = 0; k < 8; k++)
            box_corner(k, corners[k]);
        document_put(&d, corners, 12, 8, F32, "VEC3", "");
        document_put(&d, box_indices, 2, cases[i].count, U16, "SCALAR", "");
        add_scene(&d, "", cases[i].primitive, "");
        document_refuse(&d, &error);
        assert_contains(error.text, cases[i].why);
    }
}

/* A buffer that is elsewhere, or never ends. */
static void wrong_uris_are_named(void **state)
{
    static const char *const cases[][2] = {
        {"/dev/zero", ": buffer 0: /dev/zero: cannot read: it is no regular file"},
        {"http://localhost/box.bin", ": buffer 0: its URI has a scheme"},
        {"box%00.bin", ": buffer 0: its URI has a zero byte"},
    };
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct document d = {0};
        struct aob_error error;
        document_put_box(&d);
        add_scene(&d, "", BOX, "");
        char *json = document_json(&d, cases[i][0]);
        refuse_text("gltf", json, &error);
        assert_contains(error.text, cases[i][1]);
        free(json);
        document_finish(&d);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wrong_members_are_named),   cmocka_unit_test(short_strides_are_named),
        cmocka_unit_test(wrong_kinds_are_named),     cmocka_unit_test(wrong_lists_are_named),
        cmocka_unit_test(wrong_accessors_are_named), cmocka_unit_test(wrong_types_are_named),
        cmocka_unit_test(cut_lists_are_named),       cmocka_unit_test(wrong_uris_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
