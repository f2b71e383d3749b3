#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "gltf.h"

enum { BUFFER_LIMIT_BITS = 36 };

/* Whether a URI can name a file here. */
static bool check_uri(const char *path, size_t index, const char *uri, struct aob_error *error)
{
    if (strstr(uri, "://"))
        return aob_fail(error,
                        "%s: buffer %zu: its URI has a scheme, which is not read: name a file beside it",
                        path, index);
    return !strstr(uri, "%00") ||
           aob_fail(error, "%s: buffer %zu: its URI has a zero byte: the file is damaged", path, index);
}

/* Fills buffer->bytes from a data URI, a file beside the document, or the chunk of a .glb. */
static bool read_buffer(struct aob_gltf *gltf, size_t index, const json_t *element,
                        struct aob_gltf_bytes *buffer, struct aob_error *error)
{
    const char *path = gltf->file->path, *uri = json_string_value(json_object_get(element, "uri"));
    if (!uri) {
        *buffer = (struct aob_gltf_bytes){.bytes = index ? NULL : gltf->file->chunk,
                                          .size = gltf->file->chunk_size};
        return buffer->bytes ||
               aob_fail(error, "%s: buffer %zu has no uri and no binary chunk: the file is damaged", path,
                        index);
    }
    if (aob_gltf_uri_is_data(uri)) {
        buffer->owned = aob_gltf_uri_data(uri, &buffer->size);
        if (!buffer->owned)
            return aob_fail(error, "%s: buffer %zu: its data URI is no base64: the file is damaged", path,
                            index);
    } else if (!check_uri(path, index, uri, error)) {
        return false;
    } else {
        char *file = aob_gltf_uri_path(path, uri);
        if (aob_file_is_special(file))
            aob_fail(error, "%s: cannot read: it is no regular file", file);
        else
            buffer->owned = aob_file_read(file, (size_t)1 << BUFFER_LIMIT_BITS, &buffer->size, error);
        free(file);
        if (!buffer->owned)
            return aob_fail_in(error, "%s: buffer %zu", path, index);
    }
    buffer->bytes = buffer->owned;
    return true;
}

static bool load_buffer(struct aob_gltf *gltf, size_t index, struct aob_error *error)
{
    const json_t *element = aob_gltf_element(gltf, "buffers", index, error);
    struct aob_gltf_label label = aob_gltf_label("buffer", index);
    size_t said;
    if (!element || !aob_gltf_whole(gltf, element, label.text, "byteLength", 0, &said, error))
        return false;
    struct aob_gltf_bytes *buffer = &gltf->buffers[index];
    if (!buffer->bytes && !read_buffer(gltf, index, element, buffer, error))
        return false;
    return buffer->size >= said ||
           aob_fail(error, "%s: %s has %zu bytes of the %zu that are said: it is cut off", gltf->file->path,
                    label.text, buffer->size, said);
}

bool aob_gltf_buffer_part(struct aob_gltf *gltf, const json_t *owner, const char *label,
                          struct aob_gltf_bytes *part, struct aob_error *error)
{
    size_t buffer, offset, length;
    if (!aob_gltf_whole(gltf, owner, label, "buffer", aob_gltf_none, &buffer, error) ||
        !aob_gltf_whole(gltf, owner, label, "byteOffset", 0, &offset, error) ||
        !aob_gltf_whole(gltf, owner, label, "byteLength", 0, &length, error) ||
        !load_buffer(gltf, buffer, error))
        return false;
    const struct aob_gltf_bytes *whole = &gltf->buffers[buffer];
    if (offset > whole->size || length > whole->size - offset)
        return aob_fail(error, "%s: %s ends behind buffer %zu: the file is damaged", gltf->file->path, label,
                        buffer);
    *part = (struct aob_gltf_bytes){.bytes = whole->bytes + offset, .size = length};
    return true;
}

bool aob_gltf_view(struct aob_gltf *gltf, size_t index, struct aob_gltf_bytes *bytes, size_t *stride,
                   struct aob_error *error)
{
    const json_t *element = aob_gltf_element(gltf, "bufferViews", index, error);
    struct aob_gltf_label label = aob_gltf_label("buffer view", index);
    if (!element || !aob_gltf_whole(gltf, element, label.text, "byteStride", 0, stride, error))
        return false;
    const json_t *meshopt = aob_gltf_extension(element, "EXT_meshopt_compression");
    struct aob_gltf_bytes *kept = &gltf->views[index];
    if (!meshopt)
        return aob_gltf_buffer_part(gltf, element, label.text, bytes, error);
    if (!kept->bytes && !aob_gltf_meshopt(gltf, meshopt, label.text, kept, error))
        return false;
    *bytes = *kept;
    return true;
}
