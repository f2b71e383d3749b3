#include "pack.h"
#include <stdlib.h>
#include <zstd.h>
#include "base/memory.h"

char *aob_pack(const char *what, const void *bytes, size_t *size, struct aob_error *error)
{
    size_t bound = ZSTD_compressBound(*size);
    char *packed = aob_alloc(bound, 1);
    size_t written = ZSTD_compress(packed, bound, bytes, *size, 3);
    if (!ZSTD_isError(written)) {
        *size = written;
        return packed;
    }
    aob_fail(error, "%s: cannot be compressed: %s", what, ZSTD_getErrorName(written));
    free(packed);
    return NULL;
}

char *aob_unpack(const char *what, const void *packed, size_t size, size_t whole, struct aob_error *error)
{
    bool sound = ZSTD_getFrameContentSize(packed, size) == whole; /* before as much memory is asked for */
    char *bytes = sound ? aob_alloc(whole + 1, 1) : NULL;
    if (sound && ZSTD_decompress(bytes, whole, packed, size) == whole)
        return bytes;
    free(bytes);
    aob_fail(error, "%s: is damaged in the history", what);
    return NULL;
}
