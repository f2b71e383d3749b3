#include "light_json.h"
#include "base/json.h"

enum { ROWS = sizeof(struct aob_light) / sizeof((struct aob_light *)0)->sh[0] };

json_t *aob_light_to_json(const struct aob_light *light)
{
    json_t *array = json_array();
    for (int i = 0; i < ROWS; i++)
        json_array_append_new(array, aob_json_vector(light->sh[i], 3));
    return array;
}

bool aob_light_from_json(const json_t *array, struct aob_light *light)
{
    bool ok = json_array_size(array) == ROWS;
    for (size_t i = 0; ok && i < ROWS; i++)
        ok = aob_json_to_vector(json_array_get(array, i), light->sh[i], 3);
    return ok;
}
