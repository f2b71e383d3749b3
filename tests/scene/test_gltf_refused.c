/* Documents that the format forbids are refused in one line that names the member. */
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
        {", 'children': 5", BOX, "", ": node 0: its children is no array"},
        {"", BOX, ", 'extensionsRequired': {}", ": its extensionsRequired is no array"},
        {"", BOX, ", 'extensionsRequired': [1]", ": its extensionsRequired holds what is no name"},
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

static void indices_of_floats_are_named(void **state)
{
    static const float indices[3] = {0, 1, 3};
    struct document d = {0};
    struct aob_error error;
    (void)state;
    document_put_box(&d);
    document_put(&d, indices, 4, 3, F32, "SCALAR", "");
    add_scene(&d, "", "'attributes': {'POSITION': 0}, 'indices': 2", "");
    document_refuse(&d, &error);
    assert_contains(error.text, "accessor 2: indices are of componentType 5126");
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
        cmocka_unit_test(wrong_members_are_named),
        cmocka_unit_test(short_strides_are_named),
        cmocka_unit_test(indices_of_floats_are_named),
        cmocka_unit_test(wrong_uris_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
