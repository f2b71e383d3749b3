/* The part of `list` that belongs to scenes: their geometry, and their lights. */
#ifndef AOB_COMMAND_LIST_SCENE_H
#define AOB_COMMAND_LIST_SCENE_H
#include "command.h"

/* False after a line if the folder of the user's scenes, or the document, cannot be had. */
bool aob_list_scenes(struct aob_common *common, struct aob_error *error);
bool aob_list_lights(struct aob_common *common, struct aob_error *error);
#endif
