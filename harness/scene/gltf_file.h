/* A glTF file (.gltf, or .glb in its binary form) as it lies on disk: its JSON, and the chunk of bytes behind it. */
#ifndef AOB_SCENE_GLTF_FILE_H
#define AOB_SCENE_GLTF_FILE_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"

struct aob_gltf_file {
    const char *path; /* the caller's */
    json_t *root;
    int version;                /* 1 or 2: the first digit of the asset's version */
    char *bytes;                /* owned */
    const unsigned char *chunk; /* the binary chunk of a .glb, within `bytes`; NULL: none */
    size_t chunk_size;
};

/* By the file's ending. */
bool aob_gltf_named(const char *path);

/* False after one line that begins with the path if the file is cut off, or its JSON is none. */
bool aob_gltf_file_read(struct aob_gltf_file *file, const char *path, struct aob_error *error);
void aob_gltf_file_finish(struct aob_gltf_file *file);

/* The path of a file that a URI in the one at `path` names, relative to its folder; free() it. Bytes written as %XX are
 * decoded; a file that has the URI itself as its name is taken too, since some exporters do not encode. */
char *aob_gltf_uri_path(const char *path, const char *uri);

/* The bytes of a data URI ("data:...;base64,..." or percent-encoded); free() them. NULL if it is none, or if its text
 * is no base64. */
unsigned char *aob_gltf_uri_data(const char *uri, size_t *size);
bool aob_gltf_uri_is_data(const char *uri);
#endif
