/* Vertices and triangles of glTF 2.0 files are read in every form: numbers, strips, sparse and packed ones. */
#include "gltf_document.h"
#include <math.h>
#include <meshoptimizer.h>
#include <stdlib.h>
#include "check.h"
#include "draco_pack.h"

struct quantised {
    int component;
    bool normalised;
    double one, scale; /* the integer that stands for the length 1 in the file, and the node's scale */
};

static size_t put_component(const struct quantised *q, double length, unsigned char *into)
{
    int value = (int)lround(length * q->one);
    memcpy(into, &value, q->component == I8 || q->component == U8 ? 1 : 2); /* little-endian */
    return q->component == I8 || q->component == U8 ? 1 : 2;
}

/* KHR_mesh_quantization: a normalised integer is value / max. Lengths are shifted by -1 where the type has a sign, so
 * that negative numbers are read as well. */
static void quantised_positions_are_read(void **state)
{
    static const struct quantised forms[] = {
        {I8, true, 31, 127 / 31.0},       {U8, true, 60, 255 / 60.0},    {I16, true, 8000, 32767 / 8000.0},
        {U16, true, 16000, 65535 / 16e3}, {I8, false, 31, 1 / 31.0},     {U8, false, 60, 1 / 60.0},
        {I16, false, 8000, 1 / 8000.0},   {U16, false, 16000, 1 / 16e3},
    };
    (void)state;
    for (size_t f = 0; f < AOB_COUNT(forms); f++) {
        const struct quantised *q = &forms[f];
        double shift = q->component == I8 || q->component == I16 ? -1 : 0;
        struct document d = {0};
        struct aob_mesh mesh;
        unsigned char corners[8][8] = {{0}};
        char node[128];
        for (int i = 0; i < 8; i++) {
            float corner[3];
            size_t at = 0;
            box_corner(i, corner);
            for (int c = 0; c < 3; c++)
                at += put_component(q, (double)corner[c] + shift, corners[i] + at);
        }
        document_put(&d, corners, 8, 8, q->component, "VEC3", q->normalised ? ", 'normalized': true" : "");
        document_put(&d, box_indices, 2, 36, U16, "SCALAR", "");
        snprintf(node, sizeof node, ", 'scale': [%.17g, %.17g, %.17g]", q->scale, q->scale, q->scale);
        add_scene(&d, node, BOX, ", 'extensionsRequired': ['KHR_mesh_quantization']");
        document_load(&d, &mesh);
        assert_box(&mesh, 12, aob_vec(shift, shift, shift), aob_vec(1 + shift, 2 + shift, 3 + shift), 1e-9);
        assert_near(mesh_volume(&mesh), 6, 1e-9);
        aob_mesh_finish(&mesh);
    }
}

/* The most negative integer is -1 too. */
static void normals_of_bytes_are_read(void **state)
{
    static const float corners[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    static const int8_t normals[3][4] = {{-128, 0, 0, 0}, {0, 127, 0, 0}, {73, 0, 73, 0}};
    const double half = sqrt(0.5);
    const struct aob_vec3 wanted[3] = {{-1, 0, 0}, {0, 1, 0}, {half, 0, half}};
    (void)state;
    struct document d = {0};
    struct aob_mesh mesh;
    document_put(&d, corners, 12, 3, F32, "VEC3", "");
    document_put(&d, normals, 4, 3, I8, "VEC3", ", 'normalized': true");
    add_scene(&d, "", "'attributes': {'POSITION': 0, 'NORMAL': 1}",
              ", 'extensionsUsed': ['KHR_mesh_quantization']");
    document_load(&d, &mesh);
    assert_int_equal(mesh.triangle_count, 1);
    for (int k = 0; k < 3; k++)
        assert_true(aob_vec_length(aob_vec_sub(mesh.normals[mesh.triangles[0][k]], wanted[k])) < 1e-9);
    aob_mesh_finish(&mesh);
}

static void strips_and_fans_are_triangles(void **state)
{
    static const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    static const uint8_t fan[4] = {0, 1, 3, 2};
    static const struct {
        const char *primitive;
        size_t triangles;
    } cases[] = {{"'attributes': {'POSITION': 0}, 'mode': 5", 2},
                 {"'attributes': {'POSITION': 0}, 'indices': 1, 'mode': 6", 2},
                 {"'attributes': {'POSITION': 0}, 'indices': 2", 1}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct document d = {0};
        struct aob_mesh mesh;
        document_put(&d, corners, 12, 4, F32, "VEC3", "");
        document_put(&d, fan, 1, 4, U8, "SCALAR", "");
        document_put(&d, fan, 1, 3, U8, "SCALAR", "");
        add_scene(&d, "", cases[i].primitive, "");
        document_load(&d, &mesh);
        assert_int_equal(mesh.triangle_count, cases[i].triangles);
        for (size_t k = 0; k < mesh.vertex_count; k++)
            assert_near(mesh.normals[k].z, 1, 1e-12); /* every triangle faces +z */
        aob_mesh_finish(&mesh);
    }
}

static void sparse_accessors_are_read(void **state)
{
    static const uint16_t indices[2] = {1, 3};
    static const float values[2][3] = {{4, 0, 0}, {4, 5, 0}};
    static const uint16_t quad[6] = {0, 1, 3, 0, 3, 2};
    (void)state;
    struct document d = {0};
    struct aob_mesh mesh;
    document_put(&d, indices, 2, 2, U16, "SCALAR", "");
    document_put(&d, values, 12, 2, F32, "VEC3", "");
    document_put(&d, quad, 2, 6, U16, "SCALAR", "");
    aob_text_add(&d.accessors,
                 ", {'componentType': 5126, 'count': 4, 'type': 'VEC3', 'sparse': {'count': 2, 'indices': "
                 "{'bufferView': 0, 'componentType': 5123}, 'values': {'bufferView': 1}}}");
    add_scene(&d, "", "'attributes': {'POSITION': 3}, 'indices': 2", "");
    document_load(&d, &mesh);
    assert_box(&mesh, 1, origin, aob_vec(4, 5, 0),
               0); /* the other triangle is degenerate: two corners are 0 */
    aob_mesh_finish(&mesh);
}

/* A view that EXT_meshopt_compression stands for. */
static void add_packed_view(struct document *d, const void *bytes, size_t size, size_t count, size_t stride,
                            const char *mode)
{
    aob_text_add(&d->views,
                 "%s{'buffer': 0, 'byteLength': %zu, 'extensions': {'EXT_meshopt_compression': {'buffer': 0, "
                 "'byteOffset': %zu, 'byteLength': %zu, 'count': %zu, 'byteStride': %zu, 'mode': '%s'}}}",
                 d->count++ ? ", " : "", count * stride, d->bytes.size, size, count, stride, mode);
    aob_text_add_bytes(&d->bytes, bytes, size);
}

static void meshopt_is_read(void **state)
{
    (void)state;
    struct document d = {0};
    struct aob_mesh mesh;
    float corners[8][3];
    unsigned indices[36];
    unsigned char packed[1024];
    for (int i = 0; i < 36; i++)
        indices[i] = box_indices[i];
    for (int i = 0; i < 8; i++)
        box_corner(i, corners[i]);
    size_t size = meshopt_encodeVertexBuffer(packed, sizeof packed, corners, 8, 12);
    add_packed_view(&d, packed, size, 8, 12, "ATTRIBUTES");
    size = meshopt_encodeIndexBuffer(packed, sizeof packed, indices, 36);
    add_packed_view(&d, packed, size, 36, 2, "TRIANGLES");
    aob_text_add(&d.accessors,
                 "{'bufferView': 0, 'componentType': 5126, 'count': 8, 'type': 'VEC3'}, {'bufferView': 1, "
                 "'componentType': 5123, 'count': 36, 'type': 'SCALAR'}");
    add_scene(&d, "", BOX, ", 'extensionsRequired': ['EXT_meshopt_compression']");
    document_load(&d, &mesh);
    assert_box(&mesh, 12, origin, far_corner, 0);
    assert_near(mesh_volume(&mesh), 6, 1e-12);
    aob_mesh_finish(&mesh);
}

/* 256 x 257 corners are more than 16 bits count. */
enum { ACROSS = 256, DOWN = 257 };

static size_t pack_grid(struct aob_text *bytes)
{
    uint32_t count = 0;
    float(*corners)[3] = aob_alloc(ACROSS * DOWN, sizeof *corners);
    uint32_t(*triangles)[3] = aob_alloc(2 * ACROSS * DOWN, sizeof *triangles);
    for (uint32_t i = 0; i < ACROSS * DOWN; i++) {
        corners[i][0] = (float)(i % ACROSS);
        corners[i][1] = (float)(i / ACROSS);
        if (i % ACROSS + 1 == ACROSS || i / ACROSS + 1 == DOWN)
            continue;
        const uint32_t two[2][3] = {{i, i + 1, i + ACROSS}, {i + 1, i + 1 + ACROSS, i + ACROSS}};
        memcpy(triangles[count], two, sizeof two);
        count += 2;
    }
    size_t room = (size_t)1 << 24;
    char *packed = aob_alloc(room, 1);
    size_t size = draco_pack((const float(*)[3])corners, ACROSS * DOWN, (const uint32_t(*)[3])triangles,
                             count, packed, room);
    assert_true(size > 0);
    aob_text_add_bytes(bytes, packed, size);
    free(packed);
    free(corners);
    free(triangles);
    return count;
}

static void draco_is_read(void **state)
{
    (void)state;
    struct document d = {0};
    struct aob_mesh mesh;
    struct aob_error error;
    double area = 0;
    size_t triangles = pack_grid(&d.bytes);
    aob_text_add(&d.views, "{'buffer': 0, 'byteLength': %zu}", d.bytes.size);
    aob_text_add(&d.accessors,
                 "{'componentType': 5126, 'count': %d, 'type': 'VEC3'}, {'componentType': 5125, "
                 "'count': %zu, 'type': 'SCALAR'}",
                 ACROSS * DOWN, 3 * triangles);
    const char *primitive = BOX
        ", 'extensions': {'KHR_draco_mesh_compression': {'bufferView': 0, 'attributes': {'POSITION': 0}}}";
    add_scene(&d, ", 'translation': [0, 0, 5]", primitive,
              ", 'extensionsRequired': ['KHR_draco_mesh_compression']");
    char *json = document_json(&d, NULL);
    load_text(&mesh, "gltf", json);
    free(json);
    assert_box(&mesh, triangles, aob_vec(0, 0, 5), aob_vec(ACROSS - 1, DOWN - 1, 5), 0);
    assert_int_equal(mesh.vertex_count, ACROSS * DOWN);
    for (size_t i = 0; i < mesh.triangle_count; i++) {
        const uint32_t *t = mesh.triangles[i];
        area += aob_vec_cross(aob_vec_sub(mesh.positions[t[1]], mesh.positions[t[0]]),
                              aob_vec_sub(mesh.positions[t[2]], mesh.positions[t[0]]))
                    .z /
                2;
    }
    assert_near(area, (ACROSS - 1) * (DOWN - 1), 1e-6);
    aob_mesh_finish(&mesh);
    memset(d.bytes.data + 20, 0, 2000);
    document_refuse(&d, &error);
    assert_contains(error.text, "Draco");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(quantised_positions_are_read),
        cmocka_unit_test(normals_of_bytes_are_read),
        cmocka_unit_test(strips_and_fans_are_triangles),
        cmocka_unit_test(sparse_accessors_are_read),
        cmocka_unit_test(meshopt_is_read),
        cmocka_unit_test(draco_is_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
