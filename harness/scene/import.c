#include <string.h>
#include <strings.h>
#include "base/file.h"
#include "base/memory.h"
#include "gltf_import.h"
#include "import_assimp.h"
#include "mesh_part.h"

const char aob_mesh_importer_version[] = "4";

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

/* glTF 1.0, an older format of the same ending, is assimp's. */
static bool import_gltf(struct aob_mesh *mesh, const char *path, struct aob_error *error)
{
    struct aob_gltf_file file;
    if (!aob_gltf_file_read(&file, path, error))
        return false;
    bool ok = file.version == 1 ? aob_assimp_import(mesh, path, error) : aob_gltf_import(mesh, &file, error);
    aob_gltf_file_finish(&file);
    return ok;
}

bool aob_mesh_import(struct aob_mesh *mesh, const char *path, struct aob_error *error)
{
    *mesh = (struct aob_mesh){0};
    bool ok = aob_gltf_named(path) ? import_gltf(mesh, path, error) : aob_assimp_import(mesh, path, error);
    if (ok)
        aob_mesh_tidy(mesh);
    if (!ok || !aob_mesh_check(mesh, path, error)) {
        aob_mesh_finish(mesh);
        return false;
    }
    mesh->source_bytes = telling_size(path);
    return true;
}
