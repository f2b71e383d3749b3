#include "source.h"
#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"

/* Buffers that lie beside a .gltf; one that is missing is the importer's to complain of. */
static void add_buffers(const char *file, struct aob_text *text)
{
    json_t *document = json_load_file(file, 0, NULL), *buffer;
    const char *slash = strrchr(file, '/');
    size_t at;
    json_array_foreach(json_object_get(document, "buffers"), at, buffer)
    {
        const char *uri = json_string_value(json_object_get(buffer, "uri"));
        char key[AOB_KEY_SIZE];
        struct aob_text path = {0};
        if (!uri || strncmp(uri, "data:", 5) == 0)
            continue;
        aob_text_add(&path, "%.*s%s", slash ? (int)(slash - file) + 1 : 0, file, uri);
        if (aob_hash_file(path.data, key, NULL))
            aob_text_add(text, " %s", key);
        aob_text_finish(&path);
    }
    json_decref(document);
}

static bool digest_file(const char *file, char key[AOB_KEY_SIZE], struct aob_error *error)
{
    struct aob_text text = {0};
    const char *ending = strrchr(file, '.');
    if (!aob_hash_file(file, key, error))
        return false;
    aob_text_add(&text, "%s %s %s", key, ending ? ending : "", aob_mesh_importer_version);
    if (ending && strcmp(ending, ".gltf") == 0)
        add_buffers(file, &text);
    aob_hash_text(text.data, key);
    aob_text_finish(&text);
    return true;
}

bool aob_source_digest(const struct aob_scene_info *info, const char *file, char key[AOB_KEY_SIZE],
                       struct aob_error *error)
{
    struct aob_mesh mesh = {0};
    if (file)
        return digest_file(file, key, error);
    info->build(&mesh);
    aob_mesh_digest(&mesh, key);
    aob_mesh_finish(&mesh);
    return true;
}
