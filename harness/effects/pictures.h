/* The pictures of a plan of effects: what was taken, and what each effect adds to it or takes from it. */
#ifndef AOB_EFFECTS_PICTURES_H
#define AOB_EFFECTS_PICTURES_H
#include "effects.h"

/* Writes FOLDER/images/SET.exr of the set taken and of each that an effect makes of it, and puts its name into the members
 * `chosen` and `effects[].otherwise` of the document (report.h), as `image`, and the exposure into the document. False after a line. */
bool aob_effects_draw(const struct aob_effects *effects, const char *folder, json_t *document,
                      struct aob_error *error);
#endif
