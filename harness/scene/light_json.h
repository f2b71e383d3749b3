/* A light as JSON, as it stands in `list lights` and in messages between processes: nine arrays of R, G, B in the order of
 * struct aob_light. */
#ifndef AOB_SCENE_LIGHT_JSON_H
#define AOB_SCENE_LIGHT_JSON_H
#include <jansson.h>
#include <stdbool.h>
#include "light.h"

json_t *aob_light_to_json(const struct aob_light *light);               /* a new array */
bool aob_light_from_json(const json_t *array, struct aob_light *light); /* false: of another form */
#endif
