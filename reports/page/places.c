#include "places.h"
#include <stdlib.h>

size_t aob_place(json_t *places, json_t *key)
{
    char *text = json_dumps(key, JSON_COMPACT | JSON_SORT_KEYS);
    const char *name = text ? text : "";
    const json_t *known = json_object_get(places, name);
    size_t place = known ? (size_t)json_integer_value(known) : json_object_size(places);
    if (!known)
        json_object_set_new(places, name, json_integer((json_int_t)place));
    json_decref(key);
    free(text);
    return place;
}
