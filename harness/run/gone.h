/* Scenes whose geometry cannot be had any more: they leave a config that is planned again. */
#ifndef AOB_RUN_GONE_H
#define AOB_RUN_GONE_H
#include "base/error.h"
#include "config/config.h"

/* Of one view of a scene that goes: `scene` is what records call it, `why` one line that names it. */
typedef void (*aob_gone_fn)(void *user, const char *scene, const char *why);

/* Takes out the scenes whose file cannot be read: a mesh or capture by its path, one of the folder AOBUDGET_SCENES by its
 * name, a packaged one; or that name a file which cannot. A capture is looked for only. */
void aob_gone_leave(struct aob_config *config, aob_gone_fn tell, void *user);
#endif
