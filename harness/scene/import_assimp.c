#include "import_assimp.h"
#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "base/child.h"
#include "base/file.h"
#include "base/memory.h"
#include "import_material.h"
#include "mesh_part.h"
#include "ply_head.h"

enum { FILE_LIMIT_BITS = 32 };

/* assimp places nodes without a look at mirrors, and joins vertices and makes normals by distances in file units; so
 * these three are done by mesh_part.h. */
static const int dropped = aiComponent_TEXCOORDS | aiComponent_TANGENTS_AND_BITANGENTS |
                           aiComponent_ANIMATIONS | aiComponent_TEXTURES | aiComponent_LIGHTS |
                           aiComponent_CAMERAS;
static const unsigned steps = aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_SortByPType |
                              aiProcess_ValidateDataStructure;

enum { SAID = 100 };

/* Where a face is wrong assimp drops it, or puts a vertex of its own choice into it, and says so in its log alone. The
 * first line of that kind; most of what it calls errors is of materials and animations. */
static void take_log(const char *line, char *said)
{
    static const char *const of_shape[] = {"face", "ertex", "olygon", "riangulat"};
    const char *text = strncmp(line, "Error", 5) == 0 ? strstr(line, ": ") : NULL;
    for (size_t i = 0; text && !*said && i < AOB_COUNT(of_shape); i++)
        if (strstr(text, of_shape[i]))
            snprintf(said, SAID, "%.*s", (int)strcspn(text + 2, "\n"), text + 2);
}

static const struct aiScene *import_scene(const char *path, char said[SAID])
{
    const struct aiLogStream log = {take_log, said};
    struct aiPropertyStore *options = aiCreatePropertyStore();
    aiSetImportPropertyInteger(options, AI_CONFIG_PP_SBP_REMOVE,
                               aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    aiSetImportPropertyInteger(options, AI_CONFIG_PP_RVC_FLAGS, dropped);
    aiSetImportPropertyInteger(options, AI_CONFIG_IMPORT_NO_SKELETON_MESHES,
                               1); /* made up where there are none */
    size_t size;
    char *padded = aob_ply_pad(path, &size);
    aiAttachLogStream(&log);
    const struct aiScene *scene =
        padded ? aiImportFileFromMemoryWithProperties(padded, (unsigned)size, steps, "ply", options)
               : aiImportFileExWithProperties(path, steps, NULL, options);
    aiDetachLogStream(&log);
    free(padded);
    aiReleasePropertyStore(options);
    return scene;
}

static struct aob_vec3 from_assimp(struct aiVector3D v)
{
    return aob_vec((double)v.x, (double)v.y, (double)v.z);
}

static struct aob_affine node_map(const struct aiMatrix4x4 *m)
{
    return (struct aob_affine){{{(double)m->a1, (double)m->a2, (double)m->a3, (double)m->a4},
                                {(double)m->b1, (double)m->b2, (double)m->b3, (double)m->b4},
                                {(double)m->c1, (double)m->c2, (double)m->c3, (double)m->c4}}};
}

static void read_vertices(const struct aiMesh *mesh, struct aob_mesh_part *part)
{
    part->vertex_count = mesh->mNumVertices;
    part->positions = AOB_NEW_ARRAY(struct aob_vec3, part->vertex_count + 1);
    part->normals = mesh->mNormals ? AOB_NEW_ARRAY(struct aob_vec3, part->vertex_count + 1) : NULL;
    part->colours = mesh->mColors[0] ? aob_alloc(part->vertex_count + 1, sizeof *part->colours) : NULL;
    for (size_t i = 0; i < part->vertex_count; i++) {
        part->positions[i] = from_assimp(mesh->mVertices[i]);
        if (part->normals)
            part->normals[i] = from_assimp(mesh->mNormals[i]);
        if (!part->colours)
            continue;
        part->colours[i][0] = mesh->mColors[0][i].r;
        part->colours[i][1] = mesh->mColors[0][i].g;
        part->colours[i][2] = mesh->mColors[0][i].b;
    }
}

static void read_part(const struct aiScene *scene, const struct aiMesh *mesh, struct aob_mesh_part *part)
{
    *part = (struct aob_mesh_part){0};
    read_vertices(mesh, part);
    if (mesh->mMaterialIndex < scene->mNumMaterials)
        part->painted = aob_import_material(scene->mMaterials[mesh->mMaterialIndex], &part->material);
    part->triangles = aob_alloc(mesh->mNumFaces + 1, sizeof *part->triangles);
    for (unsigned i = 0; i < mesh->mNumFaces; i++) {
        const struct aiFace *face = &mesh->mFaces[i];
        if (face->mNumIndices != 3)
            continue;
        for (int k = 0; k < 3; k++)
            part->triangles[part->triangle_count][k] = face->mIndices[k];
        part->triangle_count++;
    }
}

static const struct aiNode *find_node(const struct aiNode *node, const char *name)
{
    const struct aiNode *found = strcmp(node->mName.data, name) == 0 ? node : NULL;
    for (unsigned i = 0; !found && i < node->mNumChildren; i++)
        found = find_node(node->mChildren[i], name);
    return found;
}

/* Whether a bone would put the mesh elsewhere than its node does. Most files are saved in their bind pose, where it
 * would not. */
static bool moves(const struct aiScene *scene, const struct aiBone *bone, const struct aob_affine *place)
{
    const struct aiNode *node = find_node(scene->mRootNode, bone->mName.data);
    struct aob_affine map = node_map(&bone->mOffsetMatrix);
    double size = 0, apart = 0;
    for (; node; node = node->mParent) {
        struct aob_affine own = node_map(&node->mTransformation);
        map = aob_affine_multiply(&own, &map);
    }
    for (int i = 0; i < 12; i++) {
        size = fmax(size, fabs(place->m[i / 4][i % 4]));
        apart = fmax(apart, fabs(place->m[i / 4][i % 4] - map.m[i / 4][i % 4]));
    }
    return apart > 1e-3 * size;
}

static void note_what_is_left_out(const struct aiScene *scene, const struct aiMesh *part,
                                  const struct aob_affine *place, struct aob_mesh *mesh)
{
    bool moved = false;
    for (unsigned i = 0; !moved && i < part->mNumBones; i++)
        moved = part->mBones[i]->mNumWeights && moves(scene, part->mBones[i], place);
    if (moved)
        aob_mesh_note(mesh, "bones are not applied in this format: meshes are as before they were posed");
    if (part->mNumAnimMeshes)
        aob_mesh_note(mesh, "morph targets are not applied in this format");
}

/* What says in a file that a mesh is the cage of a subdivision surface: polygons of LightWave, and what Blender and Maya
 * write into FBX, as binary and as text. assimp takes the cage for the mesh. */
static const struct mark {
    const char *ending, *bytes;
    size_t size;
} marks[] = {
    {".lwo", "PTCH", 4},           {".lwo", "SUBD", 4},           {".fbx", "SmoothnessI\1", 12},
    {".fbx", "SmoothnessI\2", 12}, {".fbx", "Smoothness: 1", 13}, {".fbx", "Smoothness: 2", 13},
};

static void note_subdivision(const char *path, struct aob_mesh *mesh)
{
    const char *ending = strrchr(path, '.');
    for (size_t i = 0; ending && i < AOB_COUNT(marks); i++) {
        size_t size = 0;
        if (strcasecmp(ending, marks[i].ending) != 0)
            continue;
        char *bytes = aob_file_read(path, (size_t)1 << FILE_LIMIT_BITS, &size, NULL);
        if (bytes && memmem(bytes, size, marks[i].bytes, marks[i].size))
            aob_mesh_note(mesh, "subdivision is not applied in this format: the mesh is its cage");
        free(bytes);
    }
}

/* A node of the file with all below it. */
static bool add_node(const struct aiScene *scene, const struct aiNode *node, const struct aob_affine *above,
                     struct aob_mesh *mesh, const char *path, struct aob_error *error)
{
    struct aob_affine own = node_map(&node->mTransformation), place = aob_affine_multiply(above, &own);
    bool ok = true;
    for (unsigned i = 0; ok && i < node->mNumMeshes; i++) {
        struct aob_mesh_part part;
        read_part(scene, scene->mMeshes[node->mMeshes[i]], &part);
        note_what_is_left_out(scene, scene->mMeshes[node->mMeshes[i]], &place, mesh);
        ok = aob_mesh_part_add(&part, &place, mesh, path, error);
        aob_mesh_part_finish(&part);
    }
    for (unsigned i = 0; ok && i < node->mNumChildren; i++)
        ok = add_node(scene, node->mChildren[i], &place, mesh, path, error);
    return ok;
}

/* assimp catches what memory lacks, and says it in C++'s words. */
static bool fail_to_load(const char *path, const char *said, struct aob_error *error)
{
    char cause[300], limit[64] = "";
    if (strstr(said, "contains no faces")) /* a cloud of points is a right file, and no mesh */
        return aob_fail(error, "%s: it has no triangles: there is nothing to render", path);
    size_t memory = aob_child_memory(0);
    if (memory)
        snprintf(limit, sizeof limit, " (its limit is %zu MiB)", memory >> 20);
    snprintf(cause, sizeof cause, "not enough memory%s: %s", limit, said);
    return aob_file_fail(path, strstr(said, "bad_alloc") ? cause : said, error);
}

bool aob_assimp_import(struct aob_mesh *mesh, const char *path, struct aob_error *error)
{
    if (!aob_ply_check(path, error))
        return false;
    const struct aob_affine identity = aob_affine_identity();
    char said[SAID] = "";
    const struct aiScene *scene = import_scene(path, said);
    if (!scene)
        return fail_to_load(path, aiGetErrorString(), error);
    bool ok = add_node(scene, scene->mRootNode, &identity, mesh, path, error);
    note_subdivision(path, mesh);
    if (*said)
        aob_mesh_note(mesh, "its shape lacks something, or is wrong: %s", said);
    aiReleaseImport(scene);
    return ok;
}
