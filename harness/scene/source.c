#include "source.h"
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/text.h"

/* Digests a file that lies beside the mesh. If it is missing, the importer complains of it. */
static void add_neighbour(const char *file, const char *name, struct aob_text *text)
{
    const char *slash = strrchr(file, '/');
    char key[AOB_KEY_SIZE];
    struct aob_text path = {0};
    aob_text_add(&path, "%.*s%s", slash ? (int)(slash - file) + 1 : 0, file, name);
    if (aob_hash_file(path.data, key, NULL))
        aob_text_add(text, " %s", key);
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
            add_neighbour(file, name, text);
    }
    free(line);
    if (in)
        fclose(in);
}

static void add_buffers(const char *file, struct aob_text *text)
{
    json_t *document = json_load_file(file, 0, NULL), *buffer;
    size_t at;
    json_array_foreach(json_object_get(document, "buffers"), at, buffer)
    {
        const char *uri = json_string_value(json_object_get(buffer, "uri"));
        if (uri && strncmp(uri, "data:", 5) != 0)
            add_neighbour(file, uri, text);
    }
    json_decref(document);
}

static bool digest_file(const char *file, char key[AOB_KEY_SIZE], struct aob_error *error)
{
    struct aob_text text = {0};
    const char *ending = strrchr(file, '.');
    if (!aob_hash_file(file, key, error))
        return false;
    aob_text_add(&text, "%s %s", key, ending ? ending : "");
    if (ending && strcmp(ending, ".gltf") == 0)
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
