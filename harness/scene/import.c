#include "mesh.h"
#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "base/file.h"
#include "base/memory.h"
#include "import_material.h"
#include "ply_pad.h"

const char aob_mesh_importer_version[] = "2";

static const int dropped = aiComponent_TEXCOORDS | aiComponent_TANGENTS_AND_BITANGENTS |
                           aiComponent_BONEWEIGHTS | aiComponent_ANIMATIONS | aiComponent_TEXTURES |
                           aiComponent_LIGHTS | aiComponent_CAMERAS;
static const unsigned steps = aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType |
                              aiProcess_PreTransformVertices | aiProcess_JoinIdenticalVertices |
                              aiProcess_GenSmoothNormals | aiProcess_FindDegenerates |
                              aiProcess_ValidateDataStructure;

static const struct aiScene *import_scene(const char *path)
{
    struct aiPropertyStore *options = aiCreatePropertyStore();
    aiSetImportPropertyInteger(options, AI_CONFIG_PP_SBP_REMOVE,
                               aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    aiSetImportPropertyInteger(options, AI_CONFIG_PP_RVC_FLAGS, dropped);
    aiSetImportPropertyFloat(options, AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, 60);
    size_t size;
    char *padded = aob_ply_pad(path, &size);
    const struct aiScene *scene =
        padded ? aiImportFileFromMemoryWithProperties(padded, (unsigned)size, steps, "ply", options)
               : aiImportFileExWithProperties(path, steps, NULL, options);
    free(padded);
    aiReleasePropertyStore(options);
    return scene;
}

static struct aob_vec3 from_assimp(struct aiVector3D v)
{
    return aob_vec(v.x, v.y, v.z);
}

/* If the file has a normal of zero or NAN, up is as good as any other, and the mesh stays usable. */
static struct aob_vec3 unit_normal(struct aiVector3D v)
{
    struct aob_vec3 n = aob_vec_normalize(from_assimp(v));
    return aob_vec_length(n) > 0.5 ? n : aob_vec(0, 1, 0);
}

static void append_part(struct aob_mesh *mesh, const struct aiScene *scene, const struct aiMesh *part)
{
    const struct aiMaterial *material =
        part->mMaterialIndex < scene->mNumMaterials ? scene->mMaterials[part->mMaterialIndex] : NULL;
    size_t first = mesh->vertex_count;
    for (unsigned i = 0; i < part->mNumVertices; i++) {
        mesh->positions[first + i] = from_assimp(part->mVertices[i]);
        if (mesh->normals)
            mesh->normals[first + i] = unit_normal(part->mNormals[i]);
    }
    mesh->vertex_count += part->mNumVertices;
    aob_mesh_paint(mesh, aob_import_material(material, part, NULL));
    for (unsigned i = 0; i < part->mNumFaces; i++) {
        const struct aiFace *face = &part->mFaces[i];
        if (face->mNumIndices != 3)
            continue;
        if (part->mColors[0])
            aob_mesh_paint(mesh, aob_import_material(material, part, face));
        aob_mesh_add_triangle(mesh, (uint32_t)(first + face->mIndices[0]),
                              (uint32_t)(first + face->mIndices[1]), (uint32_t)(first + face->mIndices[2]));
    }
}

static void gather(struct aob_mesh *mesh, const struct aiScene *scene)
{
    bool normals = true;
    for (unsigned i = 0; i < scene->mNumMeshes; i++) {
        mesh->vertex_capacity += scene->mMeshes[i]->mNumVertices;
        mesh->triangle_capacity += scene->mMeshes[i]->mNumFaces;
        normals &= scene->mMeshes[i]->mNormals != NULL;
    }
    mesh->positions = aob_alloc(mesh->vertex_capacity, sizeof *mesh->positions);
    mesh->normals = normals ? aob_alloc(mesh->vertex_capacity, sizeof *mesh->normals) : NULL;
    mesh->triangles = aob_alloc(mesh->triangle_capacity, sizeof *mesh->triangles);
    for (unsigned i = 0; i < scene->mNumMeshes; i++)
        append_part(mesh, scene, scene->mMeshes[i]);
}

/* If assimp does not understand a triangle strip, it silently keeps one triangle. So we compare the triangle count
 * with the file size. Formats that carry pictures or animations along say nothing by their size. */
static size_t telling_size(const char *path)
{
    static const char *const plain[] = {".obj", ".ply", ".stl", ".off", ".3ds"};
    const char *ending = strrchr(path, '.');
    for (size_t i = 0; ending && i < AOB_COUNT(plain); i++)
        if (strcasecmp(ending, plain[i]) == 0)
            return aob_file_size(path);
    return 0;
}

bool aob_mesh_import(struct aob_mesh *mesh, const char *path, struct aob_error *error)
{
    *mesh = (struct aob_mesh){0};
    const struct aiScene *scene = import_scene(path);
    if (!scene)
        return aob_fail(error, "%s: cannot load: %s", path, aiGetErrorString());
    gather(mesh, scene);
    aiReleaseImport(scene);
    if (!aob_mesh_check(mesh, path, error)) {
        aob_mesh_finish(mesh);
        return false;
    }
    mesh->source_bytes = telling_size(path);
    return true;
}
