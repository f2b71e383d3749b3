#include "gltf_primitive.h"
#include <stdlib.h>
#include "base/memory.h"
#include "gltf_type.h"

/* Modes of triangles (glTF 2.0, 5.24.4). */
enum { MODE_TRIANGLES = 4, MODE_STRIP = 5, MODE_FAN = 6 };

bool aob_gltf_attribute_of(struct aob_gltf *gltf, const json_t *attributes, const char *name, int components,
                           struct aob_numbers *numbers, struct aob_error *error)
{
    size_t accessor;
    *numbers = (struct aob_numbers){0};
    if (!aob_gltf_whole(gltf, attributes, "a set of attributes", name, aob_gltf_none, &accessor, error))
        return false;
    return accessor == aob_gltf_none || (aob_gltf_type_check(gltf, accessor, name, error) &&
                                         aob_gltf_numbers(gltf, accessor, components, numbers, error));
}

static bool read_compressed(const struct aob_gltf_primitive *primitive, size_t id, const char *name,
                            int components, struct aob_numbers *numbers, struct aob_error *error)
{
    int has = id <= UINT32_MAX ? aob_draco_components(primitive->draco, (uint32_t)id) : 0;
    if (has < 1 || has > 4 || (components && has != components))
        return aob_fail(error, "%s: its Draco data have no attribute %s of %d numbers: the file is damaged",
                        primitive->gltf->file->path, name, components);
    *numbers = (struct aob_numbers){.count = primitive->vertex_count, .components = has};
    numbers->values = AOB_NEW_ARRAY(double, numbers->count *(size_t)has + 1);
    if (aob_draco_numbers(primitive->draco, (uint32_t)id, numbers->values))
        return true;
    free(numbers->values);
    *numbers = (struct aob_numbers){0};
    return aob_fail(error, "%s: attribute %s of its Draco data cannot be read", primitive->gltf->file->path,
                    name);
}

bool aob_gltf_attribute(const struct aob_gltf_primitive *primitive, const char *name, int components,
                        struct aob_numbers *numbers, struct aob_error *error)
{
    struct aob_gltf *gltf = primitive->gltf;
    const json_t *draco = aob_gltf_extension(primitive->element, "KHR_draco_mesh_compression");
    size_t id = aob_gltf_none;
    *numbers = (struct aob_numbers){0};
    if (primitive->draco && !aob_gltf_whole(gltf, json_object_get(draco, "attributes"), "its Draco data",
                                            name, aob_gltf_none, &id, error))
        return false;
    if (id != aob_gltf_none)
        return read_compressed(primitive, id, name, components, numbers, error);
    if (!aob_gltf_attribute_of(gltf, json_object_get(primitive->element, "attributes"), name, components,
                               numbers, error))
        return false;
    if (!numbers->values || numbers->count == primitive->vertex_count)
        return true;
    aob_fail(error, "%s: a primitive has %zu values of %s for %zu vertices: the file is damaged",
             gltf->file->path, numbers->count, name, primitive->vertex_count);
    free(numbers->values);
    *numbers = (struct aob_numbers){0};
    return false;
}

static bool open_draco(struct aob_gltf_primitive *primitive, const json_t *extension, struct aob_error *error)
{
    char why[200] = "";
    size_t view, stride;
    struct aob_gltf_bytes bytes;
    if (!aob_gltf_whole(primitive->gltf, extension, "its Draco data", "bufferView", aob_gltf_none, &view,
                        error) ||
        !aob_gltf_view(primitive->gltf, view, &bytes, &stride, error))
        return false;
    primitive->draco = aob_draco_create(bytes.bytes, bytes.size, why, sizeof why);
    return primitive->draco ||
           aob_fail(error, "%s: its Draco data cannot be decoded: %s", primitive->gltf->file->path, why);
}

/* The corners of triangle i of a list, a strip or a fan, in places of the list of indices. */
static void corners_of(size_t mode, size_t i, size_t corners[3])
{
    size_t odd = mode == MODE_STRIP ? i % 2 : 0, first = mode == MODE_TRIANGLES ? 3 * i : i;
    corners[0] = mode == MODE_FAN ? 0 : first;
    corners[1] = first + 1 + odd;
    corners[2] = first + 2 - odd;
}

/* The format allows no other number (glTF 2.0, 3.7.2.1): what makes no whole triangle is left of a list that was cut. A
 * list of none draws nothing and loses nothing. */
static bool check_count(const struct aob_gltf *gltf, size_t mode, size_t count, struct aob_error *error)
{
    if (mode == MODE_TRIANGLES)
        return count % 3 == 0 ||
               aob_fail(error,
                        "%s: a primitive of triangles has %zu corners, which is no multiple of 3: the "
                        "file is damaged",
                        gltf->file->path, count);
    return count == 0 || count >= 3 ||
           aob_fail(error, "%s: a strip or fan of triangles has %zu corners: the file is damaged",
                    gltf->file->path, count);
}

static bool fill_triangles(struct aob_gltf_primitive *primitive, size_t mode,
                           const struct aob_numbers *indices, struct aob_error *error)
{
    size_t count = indices->values ? indices->count : primitive->vertex_count, corners[3];
    if (!check_count(primitive->gltf, mode, count, error))
        return false;
    primitive->triangle_count = mode == MODE_TRIANGLES ? count / 3 : count < 3 ? 0 : count - 2;
    primitive->triangles = aob_alloc(primitive->triangle_count + 1, sizeof *primitive->triangles);
    for (size_t i = 0; i < primitive->triangle_count; i++) {
        corners_of(mode, i, corners);
        for (int k = 0; k < 3; k++) {
            double vertex = indices->values ? indices->values[corners[k]] : (double)corners[k];
            if (!(vertex >= 0 && vertex < (double)primitive->vertex_count))
                return aob_fail(error, "%s: a triangle names vertex %g of %zu: the file is damaged",
                                primitive->gltf->file->path, vertex, primitive->vertex_count);
            primitive->triangles[i][k] = (uint32_t)vertex;
        }
    }
    return true;
}

static bool read_plain(struct aob_gltf_primitive *primitive, size_t mode, struct aob_error *error)
{
    struct aob_gltf *gltf = primitive->gltf;
    struct aob_numbers indices = {0};
    bool ok = aob_gltf_attribute_of(gltf, primitive->element, "indices", 1, &indices, error) &&
              fill_triangles(primitive, mode, &indices, error);
    free(indices.values);
    return ok;
}

/* A strip may be compressed too; what is decoded is a list all the same. */
static bool read_draco_triangles(struct aob_gltf_primitive *primitive, struct aob_error *error)
{
    primitive->vertex_count = aob_draco_vertex_count(primitive->draco);
    primitive->triangle_count = aob_draco_triangle_count(primitive->draco);
    primitive->triangles = aob_alloc(primitive->triangle_count + 1, sizeof *primitive->triangles);
    aob_draco_triangles(primitive->draco, primitive->triangles);
    for (size_t i = 0; i < primitive->triangle_count; i++)
        for (int k = 0; k < 3; k++)
            if (primitive->triangles[i][k] >= primitive->vertex_count)
                return aob_fail(error, "%s: a triangle names vertex %u of %zu: the file is damaged",
                                primitive->gltf->file->path, primitive->triangles[i][k],
                                primitive->vertex_count);
    return true;
}

/* Of an accessor that is not read: what it says. */
static bool count_vertices(struct aob_gltf_primitive *primitive, size_t accessor, struct aob_error *error)
{
    const json_t *element = aob_gltf_element(primitive->gltf, "accessors", accessor, error);
    struct aob_gltf_label label = aob_gltf_label("accessor", accessor);
    return element &&
           aob_gltf_whole(primitive->gltf, element, label.text, "count", 0, &primitive->vertex_count, error);
}

bool aob_gltf_primitive_init(struct aob_gltf_primitive *primitive, struct aob_gltf *gltf,
                             const json_t *element, struct aob_error *error)
{
    const json_t *draco = aob_gltf_extension(element, "KHR_draco_mesh_compression");
    size_t mode, positions;
    *primitive = (struct aob_gltf_primitive){.gltf = gltf, .element = element};
    if (!aob_gltf_whole(gltf, element, "a primitive", "mode", MODE_TRIANGLES, &mode, error) ||
        !aob_gltf_whole(gltf, json_object_get(element, "attributes"), "a primitive", "POSITION",
                        aob_gltf_none, &positions, error))
        return false;
    if (mode > MODE_FAN)
        return aob_fail(error, "%s: a primitive has mode %zu: the file is damaged", gltf->file->path, mode);
    if (mode < MODE_TRIANGLES || positions == aob_gltf_none)
        return true;
    if (!draco)
        return count_vertices(primitive, positions, error) && read_plain(primitive, mode, error);
    return open_draco(primitive, draco, error) && read_draco_triangles(primitive, error);
}

void aob_gltf_primitive_finish(struct aob_gltf_primitive *primitive)
{
    aob_draco_destroy(primitive->draco);
    free(primitive->triangles);
    *primitive = (struct aob_gltf_primitive){0};
}
