/* A glTF 2.0 document while it is read: its elements, and the bytes that they name. Every function that can fail writes
 * one line that begins with the file's path and names the element. */
#ifndef AOB_SCENE_GLTF_H
#define AOB_SCENE_GLTF_H
#include "gltf_file.h"

struct aob_gltf_bytes {
    const unsigned char *bytes; /* NULL: not read yet */
    size_t size;
    void *owned; /* what to free */
};
struct aob_gltf {
    const struct aob_gltf_file *file;
    struct aob_gltf_bytes *buffers, *views; /* as many as the document has; views: of compressed ones only */
    size_t buffer_count, view_count;
};

void aob_gltf_init(struct aob_gltf *gltf, const struct aob_gltf_file *file);
void aob_gltf_finish(struct aob_gltf *gltf);

/* An element of one of the document's arrays, such as ("accessors", 3). NULL after a line if there is none. */
const json_t *aob_gltf_element(const struct aob_gltf *gltf, const char *array, size_t index,
                               struct aob_error *error);
size_t aob_gltf_count(const struct aob_gltf *gltf, const char *array);

enum { AOB_GLTF_LABEL = 64 };
struct aob_gltf_label {
    char text[AOB_GLTF_LABEL]; /* "accessor 3" */
};
struct aob_gltf_label aob_gltf_label(const char *what, size_t index);

/* A whole number of an object, or `fallback` where it has none. False after a line if the member is something else.
 * `label` names the object. */
bool aob_gltf_whole(const struct aob_gltf *gltf, const json_t *object, const char *label, const char *key,
                    size_t fallback, size_t *value, struct aob_error *error);
enum { AOB_GLTF_MAX_WHOLE_BITS = 53 }; /* numbers are below 2^53 */
extern const size_t aob_gltf_none;     /* a fallback that no index is */

/* `count` numbers of an array in an object, at most 16; values are left alone where it has no such member. False after
 * a line if the member is something else. */
bool aob_gltf_vector(const struct aob_gltf *gltf, const json_t *object, const char *label, const char *key,
                     double *values, size_t count, struct aob_error *error);

/* The extension of an object; NULL: none. */
const json_t *aob_gltf_extension(const json_t *object, const char *name);

/* The bytes of a buffer view, decompressed where it is compressed; they belong to `gltf`. *stride is its byteStride, 0
 * where it has none. */
bool aob_gltf_view(struct aob_gltf *gltf, size_t index, struct aob_gltf_bytes *bytes, size_t *stride,
                   struct aob_error *error);

/* The part of a buffer, for views and what compresses them. `label` names who asks. */
bool aob_gltf_buffer_part(struct aob_gltf *gltf, const json_t *owner, const char *label,
                          struct aob_gltf_bytes *part, struct aob_error *error);

/* Decompresses a view by its EXT_meshopt_compression (`extension`); part->owned is to be freed. */
bool aob_gltf_meshopt(struct aob_gltf *gltf, const json_t *extension, const char *label,
                      struct aob_gltf_bytes *part, struct aob_error *error);
#endif
