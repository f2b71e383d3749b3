#include "gltf_accessor.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

/* Components as they lie in a file, which is little-endian like the machines that this program is for. */
static double read_i8(const unsigned char *b)
{
    return (int8_t)*b;
}
static double read_u8(const unsigned char *b)
{
    return *b;
}
static double read_i16(const unsigned char *b)
{
    int16_t v;
    memcpy(&v, b, sizeof v);
    return v;
}
static double read_u16(const unsigned char *b)
{
    uint16_t v;
    memcpy(&v, b, sizeof v);
    return v;
}
static double read_u32(const unsigned char *b)
{
    uint32_t v;
    memcpy(&v, b, sizeof v);
    return v;
}
static double read_f32(const unsigned char *b)
{
    float v;
    memcpy(&v, b, sizeof v);
    return (double)v;
}

static const struct component {
    size_t type, size;
    double most; /* what 1 is, normalised; 0: never normalised */
    double (*read)(const unsigned char *bytes);
} component_types[] = {{5120, 1, 127, read_i8},    {5121, 1, 255, read_u8}, {5122, 2, 32767, read_i16},
                       {5123, 2, 65535, read_u16}, {5125, 4, 0, read_u32},  {5126, 4, 0, read_f32}};

static const struct shape {
    const char *name;
    int components;
} shapes[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};

/* Where elements lie, and what they are. */
struct layout {
    const unsigned char *bytes; /* NULL: all are 0 */
    size_t stride, count;
    int components;
    const struct component *component;
    bool normalised;
};

static const struct component *find_component(size_t type)
{
    for (size_t i = 0; i < AOB_COUNT(component_types); i++)
        if (component_types[i].type == type)
            return &component_types[i];
    return NULL;
}

static int find_shape(const json_t *element)
{
    const char *name = json_string_value(json_object_get(element, "type"));
    for (size_t i = 0; name && i < AOB_COUNT(shapes); i++)
        if (strcmp(shapes[i].name, name) == 0)
            return shapes[i].components;
    return 0;
}

/* Puts the layout on the bytes of the view that `owner` names, from its byteOffset on. */
static bool place_layout(struct aob_gltf *gltf, const json_t *owner, const char *label, struct layout *layout,
                         struct aob_error *error)
{
    size_t view, offset, size = layout->component->size * (size_t)layout->components;
    struct aob_gltf_bytes bytes;
    if (!aob_gltf_whole(gltf, owner, label, "bufferView", aob_gltf_none, &view, error) ||
        !aob_gltf_whole(gltf, owner, label, "byteOffset", 0, &offset, error) ||
        !aob_gltf_view(gltf, view, &bytes, &layout->stride, error))
        return false;
    if (!layout->stride)
        layout->stride = size;
    if (layout->stride < size)
        return aob_fail(error, "%s: %s: its byteStride %zu is less than its %zu bytes: the file is damaged",
                        gltf->file->path, label, layout->stride, size);
    bool fits = offset <= bytes.size && (!layout->count || bytes.size - offset >= size) &&
                (layout->count < 2 || (bytes.size - offset - size) / layout->stride >= layout->count - 1);
    if (!fits)
        return aob_fail(error, "%s: %s ends behind buffer view %zu: the file is damaged", gltf->file->path,
                        label, view);
    layout->bytes = bytes.bytes + offset;
    return true;
}

static bool read_layout(struct aob_gltf *gltf, const json_t *element, const char *label, int components,
                        struct layout *layout, struct aob_error *error)
{
    size_t type, view;
    *layout = (struct layout){.components = find_shape(element),
                              .normalised = json_is_true(json_object_get(element, "normalized"))};
    if (!aob_gltf_whole(gltf, element, label, "componentType", 0, &type, error) ||
        !aob_gltf_whole(gltf, element, label, "count", 0, &layout->count, error) ||
        !aob_gltf_whole(gltf, element, label, "bufferView", aob_gltf_none, &view, error))
        return false;
    layout->component = find_component(type);
    if (!layout->component || !layout->components)
        return aob_fail(error, "%s: %s has no type or componentType of glTF 2.0: the file is damaged",
                        gltf->file->path, label);
    if (components && layout->components != components)
        return aob_fail(error, "%s: %s has %d numbers an element in place of %d: the file is damaged",
                        gltf->file->path, label, layout->components, components);
    return view == aob_gltf_none || place_layout(gltf, element, label, layout, error);
}

static void read_element(const struct layout *layout, size_t index, double *values)
{
    const unsigned char *bytes = layout->bytes + index * layout->stride;
    double most = layout->normalised ? layout->component->most : 0;
    for (int c = 0; c < layout->components; c++) {
        double value = layout->component->read(bytes + (size_t)c * layout->component->size);
        values[c] = most > 0 ? fmax(value / most, -1) : value;
    }
}

/* Puts the sparse elements over those that were read (glTF 2.0, 3.6.2.3). */
static bool read_sparse(struct aob_gltf *gltf, const json_t *sparse, const char *label,
                        const struct layout *whole, double *values, struct aob_error *error)
{
    struct layout at = {.components = 1}, put = *whole;
    size_t type;
    if (!aob_gltf_whole(gltf, sparse, label, "count", 0, &put.count, error) ||
        !aob_gltf_whole(gltf, json_object_get(sparse, "indices"), label, "componentType", 0, &type, error))
        return false;
    at.count = put.count;
    at.component = find_component(type);
    if (!at.component)
        return aob_fail(error, "%s: %s: its sparse indices have no componentType: the file is damaged",
                        gltf->file->path, label);
    if (!place_layout(gltf, json_object_get(sparse, "indices"), label, &at, error) ||
        !place_layout(gltf, json_object_get(sparse, "values"), label, &put, error))
        return false;
    for (size_t i = 0; i < put.count; i++) {
        double index;
        read_element(&at, i, &index);
        if (!(index >= 0 && index < (double)whole->count))
            return aob_fail(error, "%s: %s: a sparse index is %g of %zu: the file is damaged",
                            gltf->file->path, label, index, whole->count);
        read_element(&put, i, values + (size_t)index * (size_t)whole->components);
    }
    return true;
}

bool aob_gltf_numbers(struct aob_gltf *gltf, size_t accessor, int components, struct aob_numbers *numbers,
                      struct aob_error *error)
{
    const json_t *element = aob_gltf_element(gltf, "accessors", accessor, error);
    struct aob_gltf_label label = aob_gltf_label("accessor", accessor);
    struct layout layout;
    *numbers = (struct aob_numbers){0};
    if (!element || !read_layout(gltf, element, label.text, components, &layout, error))
        return false;
    *numbers = (struct aob_numbers){.count = layout.count, .components = layout.components};
    numbers->values = aob_alloc(layout.count + 1, (size_t)layout.components * sizeof(double));
    for (size_t i = 0; layout.bytes && i < layout.count; i++)
        read_element(&layout, i, numbers->values + i * (size_t)layout.components);
    const json_t *sparse = json_object_get(element, "sparse");
    if (!sparse || read_sparse(gltf, sparse, label.text, &layout, numbers->values, error))
        return true;
    free(numbers->values);
    *numbers = (struct aob_numbers){0};
    return false;
}
