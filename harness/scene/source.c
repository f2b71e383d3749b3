#include "source.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"
#include "gltf_file.h"

/* Digests a file that the mesh file names. If it is missing, the importer complains of it. */
static void add_file(const char *path, struct aob_text *text)
{
    char key[AOB_KEY_SIZE];
    if (aob_hash_file(path, key, NULL))
        aob_text_add(text, " %s", key);
}

static void add_library(const char *file, const char *name, struct aob_text *text)
{
    const char *slash = strrchr(file, '/');
    struct aob_text path = {0};
    aob_text_add(&path, "%.*s%s", slash ? (int)(slash - file) + 1 : 0, file, name);
    add_file(path.data, text);
    aob_text_finish(&path);
}

/* Digests the material libraries of an OBJ, which are named by lines `mtllib NAME`. */
static void add_libraries(const char *file, struct aob_text *text)
{
    FILE *in = fopen(file, "r");
    char *line = NULL;
    size_t room = 0;
    while (in && getline(&line, &room, in) > 0) {
        char *name = line + strspn(line, " \t");
        if (strncmp(name, "mtllib", 6) != 0 || !strchr(" \t", name[6]))
            continue;
        name += 6 + strspn(name + 6, " \t");
        for (size_t size = strlen(name); size && strchr(" \t\r\n", name[size - 1]); size--)
            name[size - 1] = '\0';
        if (*name)
            add_library(file, name, text);
    }
    free(line);
    if (in)
        fclose(in);
}

static void add_buffer(const char *file, const json_t *buffer, struct aob_text *text)
{
    const char *uri = json_string_value(json_object_get(buffer, "uri"));
    if (!uri || aob_gltf_uri_is_data(uri))
        return;
    char *path = aob_gltf_uri_path(file, uri);
    add_file(path, text);
    free(path);
}

/* They are an array in glTF 2.0, and the members of an object in 1.0. */
static void add_buffers(const char *file, struct aob_text *text)
{
    struct aob_gltf_file document;
    const char *name;
    json_t *buffer;
    size_t at;
    if (!aob_gltf_file_read(&document, file, NULL))
        return;
    json_t *buffers = json_object_get(document.root, "buffers");
    json_array_foreach(buffers, at, buffer) add_buffer(file, buffer, text);
    json_object_foreach(buffers, name, buffer) add_buffer(file, buffer, text);
    aob_gltf_file_finish(&document);
}

static bool digest_file(const char *file, char key[AOB_KEY_SIZE], struct aob_error *error)
{
    struct aob_text text = {0};
    const char *ending = strrchr(file, '.');
    if (!aob_hash_file(file, key, error))
        return false;
    aob_text_add(&text, "%s %s", key, ending ? ending : "");
    if (aob_gltf_named(file))
        add_buffers(file, &text);
    if (ending && strcasecmp(ending, ".obj") == 0)
        add_libraries(file, &text);
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

void aob_source_import_digest(const char *file, const char geometry[AOB_KEY_SIZE], char key[AOB_KEY_SIZE])
{
    struct aob_text text = {0};
    aob_text_add(&text, "%s %s", geometry, aob_mesh_importer_version);
    if (file)
        aob_hash_text(text.data, key);
    else
        memmove(key, geometry, AOB_KEY_SIZE);
    aob_text_finish(&text);
}
