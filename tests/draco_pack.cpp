#include "draco_pack.h"
#include <cstring>
#include <draco/compression/encode.h>

size_t draco_pack(const float (*positions)[3], uint32_t vertex_count, const uint32_t (*triangles)[3],
                  uint32_t triangle_count, char *bytes, size_t room)
{
    draco::Mesh mesh;
    draco::GeometryAttribute kind;
    mesh.set_num_points(vertex_count);
    mesh.SetNumFaces(triangle_count);
    kind.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
    int id = mesh.AddAttribute(kind, true, vertex_count);
    for (uint32_t i = 0; i < vertex_count; i++)
        mesh.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i), positions[i]);
    for (uint32_t i = 0; i < triangle_count; i++)
        mesh.SetFace(draco::FaceIndex(i),
                     {draco::PointIndex(triangles[i][0]), draco::PointIndex(triangles[i][1]),
                      draco::PointIndex(triangles[i][2])});
    draco::Encoder encoder;
    draco::EncoderBuffer buffer;
    if (!encoder.EncodeMeshToBuffer(mesh, &buffer).ok() || buffer.size() > room)
        return 0;
    std::memcpy(bytes, buffer.data(), buffer.size());
    return buffer.size();
}
