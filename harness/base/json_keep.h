/* Leaves of a JSON text what a reader looks at, before it is parsed: parsing takes far longer than copying. */
#ifndef AOB_BASE_JSON_KEEP_H
#define AOB_BASE_JSON_KEEP_H
#include <stddef.h>

/* Copies of one JSON value of `size` bytes the members that `paths` name, with all that is in them, and returns how many
 * bytes that are; `out` has room for `size`, and may be `text`. A path has the names of objects within each other, with a dot
 * between: "time.cpu_ms", "cache.*.modelled", where * is any one name; arrays do not count, so "errors.rmse" is that of each
 * entry. A name that has a dot, or that the text writes with an escape, is named by * alone. An object of which no member is
 * named is empty, and what is no object is kept where a path goes on. The list ends with NULL. What is no JSON stays none,
 * unless its fault lies within what is left out. */
size_t aob_json_keep(const char *text, size_t size, const char *const *paths, char *out);
#endif
