/* glTF documents that a test writes: bytes go into buffer 0, and each piece of them gets a buffer view and an accessor
 * of the same number. The rest of the JSON is the test's, with ' for ". */
#ifndef AOB_TESTS_SCENE_GLTF_DOCUMENT_H
#define AOB_TESTS_SCENE_GLTF_DOCUMENT_H
#include <stdlib.h>
#include "base/memory.h"
#include "base/text.h"
#include "scene/load.h"

enum { I8 = 5120, U8, I16, U16, U32 = 5125, F32 };

struct document {
    struct aob_text bytes, views, accessors, rest;
    size_t count;
};

/* Adds `count` elements of `size` bytes. `type` such as "VEC3"; `extra`: more members of the accessor, "" or such as
 * ", 'normalized': true". Returns the accessor. */
static inline size_t document_put(struct document *d, const void *bytes, size_t size, size_t count,
                                  int component, const char *type, const char *extra)
{
    static const char zeros[4] = "";
    aob_text_add(&d->views, "%s{'buffer': 0, 'byteOffset': %zu, 'byteLength': %zu%s", d->count ? ", " : "",
                 d->bytes.size, size * count, "");
    if (size % 4 == 0 && size < 64 && strcmp(type, "SCALAR") != 0)
        aob_text_add(&d->views, ", 'byteStride': %zu", size);
    aob_text_add(&d->views, "}");
    aob_text_add(&d->accessors, "%s{'bufferView': %zu, 'componentType': %d, 'count': %zu, 'type': '%s'%s}",
                 d->count ? ", " : "", d->count, component, count, type, extra);
    aob_text_add_bytes(&d->bytes, bytes, size * count);
    aob_text_add_bytes(&d->bytes, zeros, (4 - size * count % 4) % 4);
    return d->count++;
}

static inline void document_base64(const struct aob_text *bytes, struct aob_text *out)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < bytes->size; i += 3) {
        size_t left = bytes->size - i < 3 ? bytes->size - i : 3;
        uint32_t group = 0;
        for (size_t k = 0; k < 3; k++)
            group = group << 8 | (k < left ? (unsigned char)bytes->data[i + k] : 0);
        char four[5] = {digits[group >> 18], digits[group >> 12 & 63],
                        left > 1 ? digits[group >> 6 & 63] : '=', left > 2 ? digits[group & 63] : '=', 0};
        aob_text_add(out, "%s", four);
    }
}

/* The JSON with the buffer at `uri`; NULL: within it. */
static inline char *document_json(const struct document *d, const char *uri)
{
    struct aob_text json = {0};
    aob_text_add(
        &json, "{'asset': {'version': '2.0'}, 'bufferViews': [%s], 'accessors': [%s], %s, 'buffers': [{",
        d->views.data ? d->views.data : "", d->accessors.data ? d->accessors.data : "", d->rest.data);
    if (uri && *uri)
        aob_text_add(&json, "'uri': '%s', ", uri);
    if (!uri) {
        aob_text_add(&json, "'uri': 'data:application/octet-stream;base64,");
        document_base64(&d->bytes, &json);
        aob_text_add(&json, "', ");
    }
    aob_text_add(&json, "'byteLength': %zu}]}", d->bytes.size);
    for (char *c = json.data; *c; c++)
        if (*c == '\'')
            *c = '"';
    return json.data;
}

static inline void document_finish(struct document *d)
{
    aob_text_finish(&d->bytes);
    aob_text_finish(&d->views);
    aob_text_finish(&d->accessors);
    aob_text_finish(&d->rest);
    d->count = 0;
}

static inline void document_put_u32(struct aob_text *text, size_t value)
{
    uint32_t number = (uint32_t)value;
    aob_text_add_bytes(text, (const char *)&number, 4);
}

/* The document as a .glb. */
static inline void document_binary(const struct document *d, struct aob_text *glb)
{
    char *json = document_json(d, "");
    size_t padded = (strlen(json) + 3) / 4 * 4;
    aob_text_add(glb, "glTF");
    document_put_u32(glb, 2);
    document_put_u32(glb, 12 + 8 + padded + 8 + d->bytes.size);
    document_put_u32(glb, padded);
    aob_text_add(glb, "JSON%s%.*s", json, (int)(padded - strlen(json)), "   ");
    document_put_u32(glb, d->bytes.size);
    aob_text_add_bytes(glb, "BIN", 4);
    aob_text_add_bytes(glb, d->bytes.data, d->bytes.size);
    free(json);
}

static inline void document_load(struct document *d, struct aob_mesh *mesh)
{
    char *json = document_json(d, NULL);
    load_text(mesh, "gltf", json);
    free(json);
    document_finish(d);
}

/* The line of the refusal. */
static inline void document_refuse(struct document *d, struct aob_error *error)
{
    char *json = document_json(d, NULL);
    refuse_text("gltf", json, error);
    free(json);
    document_finish(d);
}

/* Index and corners of a box 0..1 x 0..2 x 0..3: corner i has bits x, y, z at 4, 2, 1. */
static const uint16_t box_indices[36] = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                                         2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};

static inline void box_corner(int i, float corner[3])
{
    corner[0] = (float)(i >> 2 & 1);
    corner[1] = 2 * (float)(i >> 1 & 1);
    corner[2] = 3 * (float)(i & 1);
}

/* Accessors 0 and 1: positions and indices. */
static inline void document_put_box(struct document *d)
{
    float corners[8][3];
    for (int i = 0; i < 8; i++)
        box_corner(i, corners[i]);
    document_put(d, corners, sizeof corners[0], 8, F32, "VEC3", "");
    document_put(d, box_indices, 2, 36, U16, "SCALAR", "");
}
#define BOX  "'attributes': {'POSITION': 0}, 'indices': 1"
#define MESH "'meshes': [{'primitives': [{" BOX "}]}]"
static const struct aob_vec3 origin = {0, 0, 0}, far_corner = {1, 2, 3};

/* A scene of one node with the mesh of one primitive. */
static inline void add_scene(struct document *d, const char *node, const char *primitive, const char *more)
{
    aob_text_add(
        &d->rest,
        "'scene': 0, 'scenes': [{'nodes': [0]}], 'nodes': [{'mesh': 0%s}], 'meshes': [{'primitives': [{"
        "%s}]}]%s",
        node, primitive, more);
}

static inline void load_box(struct aob_mesh *mesh, const char *rest)
{
    struct document d = {0};
    document_put_box(&d);
    aob_text_add(&d.rest, "%s", rest);
    document_load(&d, mesh);
}

/* The volume within closed faces that look outwards; negative if they look inwards. */
static inline double mesh_volume(const struct aob_mesh *mesh)
{
    double volume = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *t = mesh->triangles[i];
        volume +=
            aob_vec_dot(mesh->positions[t[0]], aob_vec_cross(mesh->positions[t[1]], mesh->positions[t[2]])) /
            6;
    }
    return volume;
}

/* Shading normals lie on the fronts. */
static inline void assert_normals_outside(const struct aob_mesh *mesh)
{
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *t = mesh->triangles[i];
        struct aob_vec3 a = mesh->positions[t[0]];
        struct aob_vec3 n =
            aob_vec_cross(aob_vec_sub(mesh->positions[t[1]], a), aob_vec_sub(mesh->positions[t[2]], a));
        for (int k = 0; k < 3; k++)
            assert_true(aob_vec_dot(n, mesh->normals[t[k]]) > 0);
    }
}

static inline void assert_box(const struct aob_mesh *mesh, size_t triangles, struct aob_vec3 low,
                              struct aob_vec3 high, double tolerance)
{
    struct aob_vec3 l, h;
    aob_mesh_bounds(mesh, &l, &h);
    assert_int_equal(mesh->triangle_count, triangles);
    if (aob_vec_length(aob_vec_sub(l, low)) > tolerance || aob_vec_length(aob_vec_sub(h, high)) > tolerance)
        fail_msg("the box is %g %g %g to %g %g %g", l.x, l.y, l.z, h.x, h.y, h.z);
}
#endif
