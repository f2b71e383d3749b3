/* Which views of a config are held out of a fit. */
#ifndef AOB_TUNE_HELD_H
#define AOB_TUNE_HELD_H
#include "config/config.h"

/* Marks the views that `names`, "scene,scene/view", mean: all of a scene, or one view of it, by the names that records have. What the config
 * has not is added to it, to be scored as well: a listed scene, or one of the user's folder. `held` gets an entry for each scene of the
 * config, which may be more than before; free() it. False after a line: a name is empty, or no view is left to fit. */
bool aob_tune_held_mark(struct aob_config *config, const char *names, bool **held, struct aob_error *error);
#endif
