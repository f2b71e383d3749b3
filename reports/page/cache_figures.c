#include "cache_figures.h"
#include <string.h>
#include "base/memory.h"
#include "places.h"

static const json_t *levels_of(const struct aob_row *row, const char *profile)
{
    const json_t *figures = json_object_get(json_object_get(row->json, "cache"), profile);
    return json_object_get(json_object_get(figures, "frame"), "levels");
}

const json_t *aob_row_cache_level(const struct aob_row *row, const char *profile, int level)
{
    const json_t *levels = levels_of(row, profile);
    size_t count = json_array_size(levels);
    return json_array_get(levels, level < 0 ? count - 1 : (size_t)level);
}

struct columns {
    struct aob_cache_column *list;
    size_t count, capacity;
};

static void add_level(struct columns *columns, const char *profile, const json_t *level, int place)
{
    static const char *const flights[] = {"one", "most"};
    static const char *const names[] = {"miss_ratio", "fills_per_pixel", "bytes_per_pixel"};
    for (size_t n = 0; n < AOB_COUNT(names); n++)
        for (size_t f = 0; f < AOB_COUNT(flights); f++)
            *AOB_PUSH(columns->list, columns->count, columns->capacity) = (struct aob_cache_column){
                profile, aob_member_text(level, "name"), flights[f], names[n], place};
}

static void add_row(struct columns *columns, json_t *met, const struct aob_row *row)
{
    const char *profile;
    json_t *figures, *level;
    size_t i;
    json_object_foreach(json_object_get(row->json, "cache"), profile, figures)
    {
        json_t *levels = (json_t *)(uintptr_t)levels_of(row, profile);
        json_array_foreach(levels, i, level)
        {
            size_t known = json_object_size(met);
            if (aob_place(met, json_pack("[s, s]", profile, aob_member_text(level, "name"))) == known)
                add_level(columns, profile, level, (int)i);
        }
    }
}

struct aob_cache_column *aob_cache_columns(const struct aob_rows *rows, size_t *count)
{
    struct columns columns = {0};
    json_t *met = json_object();
    for (size_t i = 0; i < rows->count; i++)
        add_row(&columns, met, &rows->list[i]);
    json_decref(met);
    *count = columns.count;
    return columns.list;
}

double aob_cache_column_value(const struct aob_cache_column *column, const struct aob_row *row)
{
    const json_t *level = aob_row_cache_level(row, column->profile, column->place);
    bool same = strcmp(aob_member_text(level, "name"), column->level) == 0;
    return aob_member_number(same ? json_object_get(level, column->flight) : NULL, column->name);
}

json_t *aob_section_profiles(const struct aob_rows *rows, size_t section)
{
    json_t *names = json_object();
    for (size_t i = 0; i < rows->sections[section].count; i++) {
        const struct aob_row *row = &rows->list[rows->sections[section].rows[i]];
        const char *profile;
        json_t *figures;
        json_object_foreach(json_object_get(row->json, "cache"), profile,
                            figures) if (aob_row_cache_level(row, profile, 0))
            json_object_set_new(names, profile, json_true());
    }
    return names;
}
