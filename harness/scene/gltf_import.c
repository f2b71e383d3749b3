#include "gltf_import.h"
#include <stdlib.h>
#include "base/memory.h"
#include "gltf_deform.h"
#include "gltf_extension.h"
#include "gltf_form.h"
#include "gltf_material.h"
#include "mesh_part.h"

struct import {
    struct aob_gltf gltf;
    struct aob_gltf_nodes nodes;
    struct aob_mesh *mesh;
};

/* Where a node puts its mesh: once, or by each instance. */
struct places {
    struct aob_affine *map;
    size_t count;
};

static struct aob_vec3 *to_vectors(const struct aob_numbers *numbers)
{
    if (!numbers->values)
        return NULL;
    struct aob_vec3 *vectors = AOB_NEW_ARRAY(struct aob_vec3, numbers->count + 1);
    for (size_t i = 0; i < numbers->count; i++)
        vectors[i] = aob_vec(numbers->values[3 * i], numbers->values[3 * i + 1], numbers->values[3 * i + 2]);
    return vectors;
}

static bool read_vectors(const struct aob_gltf_primitive *primitive, const char *name,
                         struct aob_vec3 **vectors, struct aob_error *error)
{
    struct aob_numbers numbers;
    if (!aob_gltf_attribute(primitive, name, 3, &numbers, error))
        return false;
    *vectors = to_vectors(&numbers);
    free(numbers.values);
    return true;
}

/* RGB or RGBA. */
static bool read_colours(const struct aob_gltf_primitive *primitive, struct aob_mesh_part *part,
                         struct aob_error *error)
{
    struct aob_numbers numbers;
    if (!aob_gltf_attribute(primitive, "COLOR_0", 0, &numbers, error))
        return false;
    if (numbers.values && numbers.components >= 3) {
        part->colours = aob_alloc(numbers.count + 1, sizeof *part->colours);
        for (size_t i = 0; i < numbers.count; i++)
            for (int c = 0; c < 3; c++)
                part->colours[i][c] = (float)numbers.values[i * (size_t)numbers.components + (size_t)c];
    }
    free(numbers.values);
    return true;
}

static bool read_part(const struct import *import, struct aob_gltf_primitive *primitive,
                      struct aob_mesh_part *part, struct aob_error *error)
{
    part->vertex_count = primitive->vertex_count;
    part->triangles = primitive->triangles;
    part->triangle_count = primitive->triangle_count;
    primitive->triangles = NULL;
    return read_vectors(primitive, "POSITION", &part->positions, error) &&
           read_vectors(primitive, "NORMAL", &part->normals, error) && read_colours(primitive, part, error) &&
           aob_gltf_material(&import->gltf, primitive->element, &part->material, &part->painted, error);
}

/* Deforms and places. A skin says where its vertices are in the scene, whatever the node's own place. */
static bool add_part(struct import *import, const json_t *node, const json_t *mesh,
                     const struct aob_gltf_primitive *primitive, const struct places *places,
                     struct aob_mesh_part *part, struct aob_error *error)
{
    const struct aob_affine identity = aob_affine_identity();
    const char *path = import->gltf.file->path;
    bool skinned = false;
    size_t skin;
    if (!aob_gltf_morph(primitive, node, mesh, part, error) ||
        !aob_gltf_whole(&import->gltf, node, "a node", "skin", aob_gltf_none, &skin, error) ||
        (skin != aob_gltf_none && !aob_gltf_skin(primitive, skin, &import->nodes, part, &skinned, error)))
        return false;
    if (skin != aob_gltf_none && !skinned)
        aob_mesh_note(
            import->mesh,
            "a primitive of a skinned node has no joints or weights: it is placed without the skin");
    if (skinned && places->count > 1)
        aob_mesh_note(import->mesh, "a skinned mesh is placed once: its instances are not applied");
    if (skinned)
        return aob_mesh_part_add(part, &identity, import->mesh, path, error);
    for (size_t i = 0; i < places->count; i++)
        if (!aob_mesh_part_add(part, &places->map[i], import->mesh, path, error))
            return false;
    return true;
}

static bool add_primitive(struct import *import, const json_t *node, const json_t *mesh,
                          const json_t *element, const struct places *places, struct aob_error *error)
{
    struct aob_gltf_primitive primitive;
    struct aob_mesh_part part = {0};
    aob_gltf_note_unknown(element, "primitives", import->mesh);
    bool ok = aob_gltf_primitive_init(&primitive, &import->gltf, element, error);
    if (ok && primitive.triangle_count)
        ok = read_part(import, &primitive, &part, error) &&
             add_part(import, node, mesh, &primitive, places, &part, error);
    aob_mesh_part_finish(&part);
    aob_gltf_primitive_finish(&primitive);
    return ok;
}

/* One of an instance's three vectors; `fallback` where the attribute is missing. */
static void take(const struct aob_numbers *numbers, size_t at, const double *fallback, int count,
                 double *into)
{
    for (int c = 0; c < count; c++)
        into[c] = numbers->values ? numbers->values[at * (size_t)count + (size_t)c] : fallback[c];
}

static bool fill_instances(const struct import *import, const struct aob_affine *node,
                           const struct aob_numbers attributes[3], struct places *places,
                           struct aob_error *error)
{
    static const double none[3] = {0}, still[4] = {0, 0, 0, 1}, same[3] = {1, 1, 1};
    double move[3], turn[4], scale[3];
    places->count = aob_gltf_none;
    for (int a = 0; a < 3; a++) {
        if (attributes[a].values && places->count != aob_gltf_none && places->count != attributes[a].count)
            return aob_fail(error,
                            "%s: the attributes of its instances differ in number: the file is damaged",
                            import->gltf.file->path);
        if (attributes[a].values)
            places->count = attributes[a].count;
    }
    if (places->count == aob_gltf_none)
        return aob_fail(error, "%s: its instances have no TRANSLATION, ROTATION or SCALE: export it without",
                        import->gltf.file->path);
    places->map = AOB_NEW_ARRAY(struct aob_affine, places->count + 1);
    for (size_t i = 0; i < places->count; i++) {
        take(&attributes[0], i, none, 3, move);
        take(&attributes[1], i, still, 4, turn);
        take(&attributes[2], i, same, 3, scale);
        if (!aob_gltf_is_turn(turn))
            return aob_fail(error,
                            "%s: the rotation of instance %zu is no unit quaternion: the file is damaged",
                            import->gltf.file->path, i);
        struct aob_affine own = aob_gltf_trs(move, turn, scale);
        places->map[i] = aob_affine_multiply(node, &own);
    }
    return true;
}

static bool read_places(struct import *import, size_t node, const json_t *element, struct places *places,
                        struct aob_error *error)
{
    const json_t *instancing = aob_gltf_extension(element, "EXT_mesh_gpu_instancing");
    const json_t *list = json_object_get(instancing, "attributes");
    struct aob_numbers attributes[3] = {{0}};
    *places = (struct places){0};
    if (!instancing) {
        places->map = AOB_NEW(struct aob_affine);
        places->map[places->count++] = import->nodes.place[node];
        return true;
    }
    bool ok = aob_gltf_attribute_of(&import->gltf, list, "TRANSLATION", 3, &attributes[0], error) &&
              aob_gltf_attribute_of(&import->gltf, list, "ROTATION", 4, &attributes[1], error) &&
              aob_gltf_attribute_of(&import->gltf, list, "SCALE", 3, &attributes[2], error) &&
              fill_instances(import, &import->nodes.place[node], attributes, places, error);
    for (int a = 0; a < 3; a++)
        free(attributes[a].values);
    return ok;
}

static bool add_node(struct import *import, size_t node, struct aob_error *error)
{
    const json_t *element = aob_gltf_element(&import->gltf, "nodes", node, error), *primitive;
    struct places places = {0};
    size_t index, at;
    aob_gltf_note_unknown(element, "nodes", import->mesh);
    if (!aob_gltf_whole(&import->gltf, element, "a node", "mesh", aob_gltf_none, &index, error))
        return false;
    if (index == aob_gltf_none)
        return true;
    const json_t *mesh = aob_gltf_element(&import->gltf, "meshes", index, error);
    aob_gltf_note_unknown(mesh, "meshes", import->mesh);
    bool ok = mesh && read_places(import, node, element, &places, error);
    json_array_foreach(json_object_get(mesh, "primitives"), at, primitive)
    {
        ok = ok && add_primitive(import, element, mesh, primitive, &places, error);
    }
    free(places.map);
    return ok;
}

bool aob_gltf_import(struct aob_mesh *mesh, const struct aob_gltf_file *file, struct aob_error *error)
{
    struct import import = {.mesh = mesh};
    if (!aob_gltf_form_check(file, error) || !aob_gltf_check_required(file, error))
        return false;
    aob_gltf_init(&import.gltf, file);
    bool ok = aob_gltf_nodes_init(&import.nodes, &import.gltf, error);
    for (size_t i = 0; ok && i < import.nodes.count; i++)
        ok = add_node(&import, import.nodes.order[i], error);
    aob_gltf_nodes_finish(&import.nodes);
    aob_gltf_finish(&import.gltf);
    return ok;
}
