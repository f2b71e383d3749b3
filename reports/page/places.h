/* Finding equal things without comparing each with each. */
#ifndef AOB_REPORTS_PAGE_PLACES_H
#define AOB_REPORTS_PAGE_PLACES_H
#include <jansson.h>
#include <stddef.h>

/* The place of `key` among the keys that were asked for before; a new one gets the next place, so it is new where the
 * answer is what json_object_size(places) was. `places` is a JSON object, empty at first and the caller's; `key`, an
 * array, is taken over. */
size_t aob_place(json_t *places, json_t *key);
#endif
