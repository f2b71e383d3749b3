#include "named.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/json_keep.h"
#include "base/member.h"
#include "base/memory.h"
#include "base/text.h"

bool aob_merge_named_has(const json_t *names, const json_t *name)
{
    const json_t *other;
    size_t at;
    json_array_foreach(names, at, other)
    {
        if (json_equal(other, name))
            return true;
    }
    return false;
}

static void add(json_t *names, const json_t *name)
{
    if (json_is_string(name) && !aob_merge_named_has(names, name))
        json_array_append(names, (json_t *)(uintptr_t)name);
}

static void add_graph(json_t *names, const json_t *record)
{
    struct aob_text name = {0};
    if (!*aob_member_text(record, "graph"))
        return;
    aob_text_add(&name, "graphs/%s.dot", aob_member_text(record, "graph"));
    json_array_append_new(names, json_string(name.data));
    aob_text_finish(&name);
}

json_t *aob_merge_named(const struct aob_piece *line)
{
    static const char *const paths[] = {"image", "graph", "errors.truth", "error.truth", "time.rounds_file",
                                        NULL};
    char *cut = aob_alloc(line->size + 1, 1);
    json_t *record = json_loadb(cut, aob_json_keep(line->bytes, line->size, paths, cut), 0, NULL),
           *names = json_array(), *entry;
    size_t at;
    add(names, json_object_get(record, "image"));
    json_array_foreach(json_object_get(record, "errors"), at, entry)
    {
        add(names, json_object_get(entry, "truth"));
    }
    add(names, json_object_get(json_object_get(record, "error"), "truth"));
    add(names, json_object_get(json_object_get(record, "time"), "rounds_file"));
    add_graph(names, record);
    json_decref(record);
    free(cut);
    return names;
}

static bool is_in(const char *name, const char *folder)
{
    size_t size = strlen(folder);
    return strncmp(name, folder, size) == 0 && name[size] == '/' && name[size + 1] && name[size + 1] != '.' &&
           !strchr(name + size + 1, '/');
}

bool aob_merge_named_is_graph(const char *name)
{
    return is_in(name, "graphs");
}

bool aob_merge_named_is_safe(const char *name)
{
    return is_in(name, "images") || is_in(name, "truths") || is_in(name, "rounds") || is_in(name, "graphs");
}

void aob_merge_named_change(const struct aob_piece *line, const char *from, const char *to)
{
    char *at = (char *)(uintptr_t)line->bytes, *end = at + line->size;
    size_t size = strlen(from);
    while ((at = memmem(at, (size_t)(end - at), from, size))) {
        if (at[-1] == '"' && at[size] == '"') /* a whole text; a name is never at the line's end */
            memcpy(at, to, size);
        at += size;
    }
}
