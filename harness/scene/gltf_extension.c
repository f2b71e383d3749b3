#include "gltf_extension.h"
#include <string.h>

static const char *const applied[] = {"KHR_mesh_quantization",   "KHR_draco_mesh_compression",
                                      "EXT_meshopt_compression", "EXT_mesh_gpu_instancing",
                                      "KHR_node_visibility",     NULL};

/* The beginnings of names whose extensions change no triangle: looks, lights, and what is said about a file. MSFT_lod
 * adds coarser forms of a node, which itself is the finest. */
static const char *const of_no_shape[] = {"KHR_materials_",   "KHR_texture_",  "EXT_texture_",
                                          "MSFT_texture_",    "KHR_lights_",   "EXT_lights_",
                                          "KHR_xmp",          "KHR_technique", "KHR_animation_pointer",
                                          "ADOBE_materials_", "MSFT_lod",      NULL};

static bool is_known(const char *name)
{
    for (const char *const *a = applied; *a; a++)
        if (strcmp(*a, name) == 0)
            return true;
    for (const char *const *a = of_no_shape; *a; a++)
        if (strncmp(*a, name, strlen(*a)) == 0)
            return true;
    return false;
}

bool aob_gltf_check_required(const struct aob_gltf_file *file, struct aob_error *error)
{
    const json_t *entry;
    size_t at;
    json_array_foreach(json_object_get(file->root, "extensionsRequired"), at, entry)
    {
        const char *name = json_string_value(entry);
        if (!is_known(name))
            return aob_fail(error, "%s: it requires the extension %s, which is not read: export it without",
                            file->path, name);
    }
    return true;
}

void aob_gltf_note_unknown(const json_t *element, const char *what, struct aob_mesh *mesh)
{
    json_t *extensions = json_object_get(element, "extensions"), *extension;
    const char *name;
    json_object_foreach(extensions, name, extension)
    {
        if (!is_known(name))
            aob_mesh_note(mesh, "the extension %s of its %s is not applied", name, what);
    }
}
