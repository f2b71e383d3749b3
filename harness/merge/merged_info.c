#include "merged_info.h"
#include <stdbool.h>
#include "base/json.h"
#include "base/table.h"

/* The texts of a list in run.json that is not damaged; what is no text is passed over. */
static void gather_texts(const json_t *list, struct aob_table *has, json_t *into)
{
    json_t *text;
    size_t at;
    json_array_foreach(list, at, text)
    {
        size_t next = has->count;
        if (json_is_string(text) && aob_table_put(has, json_string_value(text), next) == next)
            json_array_append(into, text);
    }
}

/* Those of the first source come first, in its order: that of the plan. */
static json_t *unite_keys(const struct aob_merge_set *set)
{
    struct aob_table has = {0};
    json_t *keys = json_array();
    for (size_t i = 0; i < set->count; i++)
        gather_texts(json_object_get(set->sources[i]->info, "keys"), &has, keys);
    aob_table_finish(&has);
    return keys;
}

/* NULL: one source asked for all. */
static json_t *unite_asked(const struct aob_merge_set *set, const json_t *keys)
{
    struct aob_table has = {0};
    json_t *gathered = json_array(), *asked = json_array(), *key;
    size_t at;
    bool all = false;
    for (size_t i = 0; i < set->count; i++) {
        const json_t *list = json_object_get(set->sources[i]->info, "asked");
        all = all || !list;
        gather_texts(list, &has, gathered);
    }
    json_array_foreach(keys, at, key)
    {
        if (aob_table_find(&has, json_string_value(key), NULL))
            json_array_append(asked, key);
    }
    aob_table_finish(&has);
    json_decref(gathered);
    if (!all)
        return asked;
    json_decref(asked);
    return NULL;
}

static bool has_value(const json_t *list, const json_t *value)
{
    const json_t *other;
    size_t at;
    json_array_foreach(list, at, other)
    {
        if (json_equal(other, value))
            return true;
    }
    return false;
}

static json_t *unite_techniques(const struct aob_merge_set *set)
{
    json_t *all = json_array(), *technique;
    size_t at;
    for (size_t i = 0; i < set->count; i++)
        json_array_foreach(json_object_get(set->sources[i]->info, "techniques"), at, technique)
        {
            if (!has_value(all, technique))
                json_array_append(all, technique);
        }
    return all;
}

/* Where one of them has planned every view, so has the whole. */
static bool is_part(const struct aob_merge_set *set)
{
    bool part = true;
    for (size_t i = 0; i < set->count; i++)
        part = part && json_is_true(json_object_get(set->sources[i]->info, "part"));
    return part;
}

json_t *aob_merged_info_create(const struct aob_merge_set *set)
{
    json_t *info = json_deep_copy(set->sources[0]->info), *keys = unite_keys(set),
           *asked = unite_asked(set, keys), *merged = json_array();
    for (size_t i = 0; i < set->count; i++)
        json_array_append_new(merged, aob_json_path(set->sources[i]->path));
    json_object_del(info, "seconds");
    json_object_del(info, "asked");
    json_object_set_new(info, "cases", json_integer((json_int_t)json_array_size(keys)));
    json_object_set_new(info, "keys", keys);
    json_object_set_new(info, "part", json_boolean(is_part(set)));
    json_object_set_new(info, "techniques", unite_techniques(set));
    json_object_set(info, "devices", set->devices);
    if (asked)
        json_object_set_new(info, "asked", asked);
    json_object_set_new(info, "merged", merged);
    return info;
}
