/* Sources for tests of a merge: their records are written here, not measured. */
#ifndef AOB_TESTS_MERGE_LINES_H
#define AOB_TESTS_MERGE_LINES_H
#include <stdlib.h>
#include "base/memory.h"
#include "merge/source.h"

/* A source with these lines; `info` is run.json's text. aob_merge_source_close frees it. */
static inline struct aob_merge_source make_source(const char *path, const char *info,
                                                  const char *const *lines, size_t count)
{
    struct aob_merge_source source = {
        .path = path, .info = json_loads(info, 0, NULL), .records = json_array()};
    source.lines.items = AOB_NEW_ARRAY(struct aob_piece, count + 1);
    for (size_t i = 0; i < count; i++) {
        json_array_append_new(source.records, json_loads(lines[i], 0, NULL));
        source.lines.items[i] = (struct aob_piece){lines[i], strlen(lines[i])};
    }
    return source;
}
#endif
