/* What glTF 2.0 files say is what is read: numbers of every form, places, deformations, extensions. */
#include "gltf_document.h"
#include <math.h>
#include <meshoptimizer.h>
#include <stdlib.h>
#include "check.h"
#include "draco_pack.h"
#include "scene/source.h"

static const struct aob_vec3 origin = {0, 0, 0}, far_corner = {1, 2, 3};

/* A scene of one node with the mesh of one primitive. */
static void add_scene(struct document *d, const char *node, const char *primitive, const char *more)
{
    aob_text_add(
        &d->rest,
        "'scene': 0, 'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0%s}], 'meshes': [{'primitives': [{"
        "%s}]}]%s",
        node, primitive, more);
}

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
    add_scene(&d, "", "'attributes': {'POSITION': 0, 'NORMAL': 1}", "");
    document_load(&d, &mesh);
    assert_int_equal(mesh.triangle_count, 1);
    for (int k = 0; k < 3; k++)
        assert_true(aob_vec_length(aob_vec_sub(mesh.normals[mesh.triangles[0][k]], wanted[k])) < 1e-9);
    aob_mesh_finish(&mesh);
}

static void load_box(struct aob_mesh *mesh, const char *rest)
{
    struct document d = {0};
    document_put_box(&d);
    aob_text_add(&d.rest, "%s", rest);
    document_load(&d, mesh);
}

#define MESH "'meshes': [{'primitives': [{" BOX "}]}]"

static void mirrors_turn_the_winding(void **state)
{
    static const struct {
        const char *nodes;
        struct aob_vec3 low, high;
        double volume;
    } cases[] = {
        {"{'mesh': 0, 'scale': [-1, 1, 1]}", {-1, 0, 0}, {0, 2, 3}, 6},
        {"{'mesh': 0, 'scale': [-2, -1, -1]}", {-2, -2, -3}, {0, 0, 0}, 12},
        {"{'mesh': 0, 'scale': [-1, -1, 1]}", {-1, -2, 0}, {0, 0, 3}, 6},
        {"{'mesh': 0, 'matrix': [0,1,0,0, 1,0,0,0, 0,0,1,0, 5,0,0,1]}", {5, 0, 0}, {7, 1, 3}, 6},
        {"{'children': [1], 'scale': [1, 1, -1]}, {'mesh': 0, 'scale': [1, -1, 1]}",
         {0, -2, -3},
         {1, 0, 0},
         6},
        {"{'children': [1], 'scale': [1, 1, -1]}, {'mesh': 0, 'translation': [0, 0, 1]}",
         {0, 0, -4},
         {1, 2, -1},
         6},
    };
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_mesh mesh;
        char rest[400];
        snprintf(rest, sizeof rest, "'scenes': [{'nodes': [0]}], 'nodes': [%s], " MESH, cases[i].nodes);
        load_box(&mesh, rest);
        assert_box(&mesh, 12, cases[i].low, cases[i].high, 1e-12);
        assert_near(mesh_volume(&mesh), cases[i].volume, 1e-12);
        assert_normals_outside(&mesh);
        aob_mesh_finish(&mesh);
    }
}

/* Normals that the file has are mirrored with the faces; under an uneven scale they stay normal to them. */
static void normals_follow_their_nodes(void **state)
{
    static const float corners[3][3] = {{0, 0, 0}, {1, 0, 1}, {0, 1, 0}}; /* in the plane x = z */
    static const float normals[3][3] = {{-1, 0, 1}, {-1, 0, 1}, {-1, 0, 1}};
    static const char *const nodes[] = {"", ", 'scale': [-1, 1, 1]", ", 'scale': [3, 1, 1]",
                                        ", 'scale': [3, 1, -2], 'rotation': [0.6, 0, 0, 0.8]"};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(nodes); i++) {
        struct document d = {0};
        struct aob_mesh mesh;
        document_put(&d, corners, 12, 3, F32, "VEC3", "");
        document_put(&d, normals, 12, 3, F32, "VEC3", "");
        add_scene(&d, nodes[i], "'attributes': {'POSITION': 0, 'NORMAL': 1}", "");
        document_load(&d, &mesh);
        const uint32_t *t = mesh.triangles[0];
        struct aob_vec3 a = mesh.positions[t[0]];
        struct aob_vec3 n = aob_vec_normalize(
            aob_vec_cross(aob_vec_sub(mesh.positions[t[1]], a), aob_vec_sub(mesh.positions[t[2]], a)));
        for (int k = 0; k < 3; k++)
            assert_true(aob_vec_length(aob_vec_sub(mesh.normals[t[k]], n)) < 1e-6);
        aob_mesh_finish(&mesh);
    }
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
                 {"'attributes': {'POSITION': 0}", 1}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct document d = {0};
        struct aob_mesh mesh;
        document_put(&d, corners, 12, 4, F32, "VEC3", "");
        document_put(&d, fan, 1, 4, U8, "SCALAR", "");
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

/* Weights of the mesh, and of the node in their place. */
static void morph_targets_are_applied(void **state)
{
    static const struct {
        const char *node, *mesh;
        double up;
    } cases[] = {{"", ", 'weights': [1, 0]", 10},
                 {", 'weights': [0.5, 0]", ", 'weights': [1, 0]", 5},
                 {", 'weights': [0.25, 2]", "", 8.5},
                 {"", "", 0}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct document d = {0};
        struct aob_mesh mesh;
        float up[2][8][3] = {{{0}}};
        for (int k = 0; k < 8; k++) {
            up[0][k][1] = 10;
            up[1][k][1] = 3;
        }
        document_put_box(&d);
        document_put(&d, up[0], 12, 8, F32, "VEC3", "");
        document_put(&d, up[1], 12, 8, F32, "VEC3", "");
        aob_text_add(&d.rest,
                     "'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0%s}], 'meshes': [{'primitives': [{" BOX
                     ", 'targets': [{'POSITION': 2}, {'POSITION': 3}]}]%s}]",
                     cases[i].node, cases[i].mesh);
        document_load(&d, &mesh);
        assert_box(&mesh, 12, aob_vec(0, cases[i].up, 0), aob_vec(1, 2 + cases[i].up, 3), 1e-12);
        aob_mesh_finish(&mesh);
    }
}

/* The first joint is bound at y = 5 and stands at 7 and what `joints` adds to it. Vertices have the weights of the two. */
static void load_skin(struct aob_mesh *mesh, const float weights[2], const char *node, const char *joints)
{
    struct document d = {0};
    uint8_t joint[8][4] = {{0}};
    float weight[8][4] = {{0}}, bound[2][16] = {{0}};
    for (int k = 0; k < 8; k++) {
        joint[k][1] = 1;
        memcpy(weight[k], weights, 2 * sizeof(float));
    }
    for (int j = 0; j < 2; j++)
        for (int k = 0; k < 4; k++)
            bound[j][5 * k] = 1;
    bound[0][13] = -5; /* bound at y = 5 */
    document_put_box(&d);
    document_put(&d, joint, 4, 8, U8, "VEC4", "");
    document_put(&d, weight, 16, 8, F32, "VEC4", "");
    document_put(&d, bound, 64, 2, F32, "MAT4", "");
    aob_text_add(
        &d.rest,
        "'scenes': [{'nodes': [0, 1]}], 'nodes': [{'mesh': 0, 'skin': 0%s}, {'translation': [0, 7, 0], "
        "'children': [2]}, %s], 'skins': [{'joints': [2, 3], 'inverseBindMatrices': 4}], 'meshes': "
        "[{'primitives': [{'attributes': {'POSITION': 0, 'JOINTS_0': 2, 'WEIGHTS_0': 3}, 'indices': 1}]}]",
        node, joints);
    document_load(&d, mesh);
}

static void skins_are_applied(void **state)
{
    static const char joints[] = "{'translation': [0, 8, 0]}, {'rotation': [0, 0, 1, 0]}";
    static const char still[] = "{'translation': [0, 8, 0]}, {}";
    static const char turned[] = "{'translation': [0, 8, 0], 'rotation': [0, 0, 1, 0]}, {}";
    static const char mirror[] = "{'translation': [0, 8, 0], 'scale': [-1, 1, 1]}, {}";
    static const float first[2] = {1, 0}, second[2] = {0, 1}, both[2] = {0.5f, 0.5f}, twice[2] = {2, 2},
                       none[2] = {0, 0};
    static const struct {
        const float *weights;
        const char *node, *joints;
        struct aob_vec3 low, high;
        double volume;
    } cases[] = {{first, "", joints, {0, 10, 0}, {1, 12, 3}, 6},
                 {first, ", 'translation': [100, 0, 0]", joints, {0, 10, 0}, {1, 12, 3}, 6},
                 {second, "", joints, {-1, -2, 0}, {0, 0, 3}, 6},
                 {both, "", still, {0, 5, 0}, {1, 7, 3}, 6},
                 {twice, "", still, {0, 5, 0}, {1, 7, 3}, 6},
                 {none, "", joints, {0, 10, 0}, {1, 12, 3}, 6},
                 {first, "", mirror, {-1, 10, 0}, {0, 12, 3}, 6},
                 {first, "", turned, {-1, 18, 0}, {0, 20, 3}, 6}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_mesh mesh;
        load_skin(&mesh, cases[i].weights, cases[i].node, cases[i].joints);
        assert_box(&mesh, 12, cases[i].low, cases[i].high, 1e-9);
        assert_near(mesh_volume(&mesh), cases[i].volume, 1e-9);
        aob_mesh_finish(&mesh);
    }
}

static void instances_are_placed(void **state)
{
    static const float moves[3][3] = {{0, 0, 0}, {20, 0, 0}, {0, 0, -40}};
    static const float scales[3][3] = {{1, 1, 1}, {2, 2, 2}, {-1, 1, 1}};
    static const int8_t turns[3][4] = {{0, 0, 0, 127}, {0, 127, 0, 0}, {0, 0, 0, 127}};
    (void)state;
    struct document d = {0};
    struct aob_mesh mesh;
    document_put_box(&d);
    document_put(&d, moves, 12, 3, F32, "VEC3", "");
    document_put(&d, scales, 12, 3, F32, "VEC3", "");
    document_put(&d, turns, 4, 3, I8, "VEC4", ", 'normalized': true");
    add_scene(&d,
              ", 'translation': [0, 100, 0], 'extensions': {'EXT_mesh_gpu_instancing': {'attributes': "
              "{'TRANSLATION': 2, 'SCALE': 3, 'ROTATION': 4}}}",
              BOX, ", 'extensionsRequired': ['EXT_mesh_gpu_instancing']");
    document_load(&d, &mesh);
    /* The second is turned by 180 degrees about y, so it lies at 18..20, -6..0. */
    assert_box(&mesh, 36, aob_vec(-1, 100, -40), aob_vec(20, 104, 3), 1e-9);
    assert_near(mesh_volume(&mesh), 6 + 48 + 6, 1e-9);
    aob_mesh_finish(&mesh);
}

static void the_scene_says_what_is_seen(void **state)
{
    static const struct {
        const char *rest;
        size_t triangles;
    } cases[] = {
        {"'scene': 1, 'scenes': [{'nodes': [0, 1]}, {'nodes': [1]}], 'nodes': [{'mesh': 0}, {'mesh': 0}], ",
         12},
        {"'scenes': [{'nodes': [0, 1]}, {'nodes': [1]}], 'nodes': [{'mesh': 0}, {'mesh': 0}], ", 24},
        {"'nodes': [{'mesh': 0}, {'mesh': 0, 'children': [2]}, {'mesh': 0}], ", 36},
        {"'nodes': [{'mesh': 0}, {'mesh': 0, 'children': [2], 'extensions': {'KHR_node_visibility': "
         "{'visible': false}}}, {'mesh': 0}], ",
         12}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        struct aob_mesh mesh;
        char rest[400];
        snprintf(rest, sizeof rest, "%s" MESH, cases[i].rest);
        load_box(&mesh, rest);
        assert_int_equal(mesh.triangle_count, cases[i].triangles);
        aob_mesh_finish(&mesh);
    }
}

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

static void broken_documents_are_refused(void **state)
{
    static const struct {
        const char *node, *primitive, *more, *why;
    } cases[] = {
        {"", "'attributes': {'POSITION': 7}, 'indices': 1", "", "number 7 of its 2 accessors"},
        {"", "'attributes': {'POSITION': 0.5}, 'indices': 1", "", "no whole number"},
        {"", "'attributes': {'POSITION': 1}, 'indices': 0", "", "numbers an element"},
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
        cmocka_unit_test(mirrors_turn_the_winding),
        cmocka_unit_test(normals_follow_their_nodes),
        cmocka_unit_test(strips_and_fans_are_triangles),
        cmocka_unit_test(sparse_accessors_are_read),
        cmocka_unit_test(morph_targets_are_applied),
        cmocka_unit_test(skins_are_applied),
        cmocka_unit_test(instances_are_placed),
        cmocka_unit_test(the_scene_says_what_is_seen),
        cmocka_unit_test(unknown_extensions_are_named),
        cmocka_unit_test(broken_documents_are_refused),
        cmocka_unit_test(buffers_are_found),
        cmocka_unit_test(binary_files_are_read),
        cmocka_unit_test(meshopt_is_read),
        cmocka_unit_test(draco_is_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
