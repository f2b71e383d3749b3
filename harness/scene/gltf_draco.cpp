#include "gltf_draco.h"
#include <cstdio>
#include <draco/compression/decode.h>
#include <memory>
#include <new>

struct aob_draco {
    std::unique_ptr<draco::Mesh> mesh;
};

struct aob_draco *aob_draco_create(const void *bytes, size_t size, char *why, size_t why_size)
{
    try {
        draco::DecoderBuffer buffer;
        draco::Decoder decoder;
        buffer.Init(static_cast<const char *>(bytes), size);
        auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
        if (decoded.ok())
            return new aob_draco{std::move(decoded).value()};
        std::snprintf(why, why_size, "%s", decoded.status().error_msg());
    } catch (const std::bad_alloc &) {
        std::snprintf(why, why_size, "it asks for more memory than there is");
    }
    return nullptr;
}

void aob_draco_destroy(struct aob_draco *draco)
{
    delete draco;
}

size_t aob_draco_vertex_count(const struct aob_draco *draco)
{
    return draco->mesh->num_points();
}

size_t aob_draco_triangle_count(const struct aob_draco *draco)
{
    return draco->mesh->num_faces();
}

void aob_draco_triangles(const struct aob_draco *draco, uint32_t (*triangles)[3])
{
    for (uint32_t i = 0; i < draco->mesh->num_faces(); i++)
        for (int k = 0; k < 3; k++)
            triangles[i][k] = draco->mesh->face(draco::FaceIndex(i))[static_cast<size_t>(k)].value();
}

int aob_draco_components(const struct aob_draco *draco, uint32_t id)
{
    const draco::PointAttribute *attribute = draco->mesh->GetAttributeByUniqueId(id);
    return attribute ? attribute->num_components() : 0;
}

bool aob_draco_numbers(const struct aob_draco *draco, uint32_t id, double *values)
{
    const draco::PointAttribute *attribute = draco->mesh->GetAttributeByUniqueId(id);
    int8_t components = static_cast<int8_t>(attribute->num_components());
    for (uint32_t i = 0; i < draco->mesh->num_points(); i++) {
        draco::AttributeValueIndex at = attribute->mapped_index(draco::PointIndex(i));
        if (!attribute->ConvertValue<double>(at, components, values + static_cast<size_t>(i) * components))
            return false;
    }
    return true;
}
