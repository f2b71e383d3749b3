/* A table of texts, each with a number, most often its place in an array of the caller's. All calls take the same time
 * however many texts there are. A zeroed struct is an empty table. Threads: one at a time for a table that changes. */
#ifndef AOB_BASE_TABLE_H
#define AOB_BASE_TABLE_H
#include <stdbool.h>
#include <stddef.h>

struct aob_table {
    struct aob_table_entry *entries; /* private, like the rest */
    size_t count, room;              /* room: entries allocated, 0 or a power of two */
};

/* The number that `text` has, or gets now: the first one that was put stays. So a caller that puts its next free place
 * has met a new text if it gets that place back. The text is copied. */
size_t aob_table_put(struct aob_table *table, const char *text, size_t number);

/* False, and *number left alone, where the text was never put. `number` may be NULL. */
bool aob_table_find(const struct aob_table *table, const char *text, size_t *number);

void aob_table_finish(struct aob_table *table); /* frees; the table is empty again */
#endif
