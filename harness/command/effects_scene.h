/* For effects.c: the view that its flags name, as an entry of a config's list of scenes. */
#ifndef AOB_COMMAND_EFFECTS_SCENE_H
#define AOB_COMMAND_EFFECTS_SCENE_H
#include "base/text.h"
#include "single.h"

/* Adds "{name: gallery, view: hall}", with absolute paths. The flags have been read without an error (aob_single_config). A view that
 * they give no motion stands still for so many frames; 0: it is a picture. */
void aob_effects_scene_print(const struct aob_single_flags *flags, int still_frames, struct aob_text *text);
#endif
