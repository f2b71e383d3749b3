/* The files that a comparison keeps in the folder `maps`, by a list beside them: the next comparison discards those of the
 * last, which would pass for its own, and nothing that it did not make. */
#ifndef AOB_COMPARE_MAP_LIST_H
#define AOB_COMPARE_MAP_LIST_H
#include <stdbool.h>
#include "base/error.h"

/* Removes what is listed in FOLDER/maps, and the list. Without a list nothing. */
void aob_map_list_discard(const char *folder);

/* Lists a file below FOLDER ("maps/0001-corner-far-gtao", without its ending) before it is made, and makes FOLDER/maps. */
bool aob_map_list_add(const char *folder, const char *name, struct aob_error *error);
#endif
