#include <meshoptimizer.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "gltf.h"

/* What the extension says of the data. */
struct stream {
    struct aob_gltf_bytes packed;
    size_t count, stride;
    const char *mode, *filter;
};

static bool is(const char *a, const char *b)
{
    return strcmp(a, b) == 0;
}

/* The decoders demand these of their callers. */
static bool fits(const struct stream *s)
{
    if (s->count > (size_t)1 << 40)
        return false;
    if (is(s->mode, "TRIANGLES") || is(s->mode, "INDICES"))
        return (s->stride == 2 || s->stride == 4) && is(s->filter, "NONE") &&
               (is(s->mode, "INDICES") || s->count % 3 == 0);
    if (!is(s->mode, "ATTRIBUTES") || s->stride == 0 || s->stride % 4 || s->stride > 256)
        return false;
    return is(s->filter, "NONE") || is(s->filter, "EXPONENTIAL") ||
           (is(s->filter, "OCTAHEDRAL") && (s->stride == 4 || s->stride == 8)) ||
           (is(s->filter, "QUATERNION") && s->stride == 8);
}

static bool decode(const struct stream *s, void *into)
{
    const unsigned char *bytes = s->packed.bytes;
    size_t size = s->packed.size;
    if (is(s->mode, "TRIANGLES"))
        return meshopt_decodeIndexBuffer(into, s->count, s->stride, bytes, size) == 0;
    if (is(s->mode, "INDICES"))
        return meshopt_decodeIndexSequence(into, s->count, s->stride, bytes, size) == 0;
    if (meshopt_decodeVertexBuffer(into, s->count, s->stride, bytes, size) != 0)
        return false;
    if (is(s->filter, "OCTAHEDRAL"))
        meshopt_decodeFilterOct(into, s->count, s->stride);
    else if (is(s->filter, "QUATERNION"))
        meshopt_decodeFilterQuat(into, s->count, s->stride);
    else if (is(s->filter, "EXPONENTIAL"))
        meshopt_decodeFilterExp(into, s->count, s->stride);
    return true;
}

static const char *word(const json_t *extension, const char *key, const char *fallback)
{
    const char *text = json_string_value(json_object_get(extension, key));
    return text ? text : fallback;
}

bool aob_gltf_meshopt(struct aob_gltf *gltf, const json_t *extension, const char *label,
                      struct aob_gltf_bytes *part, struct aob_error *error)
{
    struct stream s = {.mode = word(extension, "mode", ""), .filter = word(extension, "filter", "NONE")};
    if (!aob_gltf_buffer_part(gltf, extension, label, &s.packed, error) ||
        !aob_gltf_whole(gltf, extension, label, "count", 0, &s.count, error) ||
        !aob_gltf_whole(gltf, extension, label, "byteStride", 0, &s.stride, error))
        return false;
    if (!fits(&s))
        return aob_fail(error,
                        "%s: %s: EXT_meshopt_compression of mode '%s', filter '%s' and stride %zu is none "
                        "that is known",
                        gltf->file->path, label, s.mode, s.filter, s.stride);
    void *bytes = aob_alloc(s.count * s.stride + 1, 1);
    if (!decode(&s, bytes)) {
        free(bytes);
        return aob_fail(
            error,
            "%s: %s: its EXT_meshopt_compression cannot be decoded: the file is damaged, or of a newer form",
            gltf->file->path, label);
    }
    *part = (struct aob_gltf_bytes){.bytes = bytes, .size = s.count * s.stride, .owned = bytes};
    return true;
}
