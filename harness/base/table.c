#include "table.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <xxhash.h>
#include "memory.h"

struct aob_table_entry {
    char *text; /* NULL: free */
    uint64_t hash;
    size_t number;
};

/* The entry of the text, or the free one where it belongs. There is always a free one: a table is at most half full. */
static struct aob_table_entry *seek(struct aob_table_entry *entries, size_t room, const char *text,
                                    uint64_t hash)
{
    size_t at = (size_t)hash & (room - 1);
    while (entries[at].text && (entries[at].hash != hash || strcmp(entries[at].text, text) != 0))
        at = (at + 1) & (room - 1);
    return &entries[at];
}

static void make_room(struct aob_table *table)
{
    size_t room = table->room ? table->room * 2 : 16;
    struct aob_table_entry *entries = AOB_NEW_ARRAY(struct aob_table_entry, room);
    for (size_t i = 0; i < table->room; i++) {
        const struct aob_table_entry *old = &table->entries[i];
        if (old->text)
            *seek(entries, room, old->text, old->hash) = *old;
    }
    free(table->entries);
    table->entries = entries;
    table->room = room;
}

size_t aob_table_put(struct aob_table *table, const char *text, size_t number)
{
    uint64_t hash = XXH3_64bits(text, strlen(text));
    if (2 * table->count >= table->room)
        make_room(table);
    struct aob_table_entry *entry = seek(table->entries, table->room, text, hash);
    if (!entry->text) {
        *entry = (struct aob_table_entry){aob_strdup(text), hash, number};
        table->count++;
    }
    return entry->number;
}

bool aob_table_find(const struct aob_table *table, const char *text, size_t *number)
{
    if (!table->count)
        return false;
    const struct aob_table_entry *entry =
        seek(table->entries, table->room, text, XXH3_64bits(text, strlen(text)));
    if (entry->text && number)
        *number = entry->number;
    return entry->text != NULL;
}

void aob_table_finish(struct aob_table *table)
{
    for (size_t i = 0; i < table->room; i++)
        free(table->entries[i].text);
    free(table->entries);
    *table = (struct aob_table){0};
}
