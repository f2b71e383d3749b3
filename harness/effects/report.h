/* A plan of effects as a document, and as lines for people. */
#ifndef AOB_EFFECTS_REPORT_H
#define AOB_EFFECTS_REPORT_H
#include "effects.h"

/* docs/design.md, Effects. A new object. */
json_t *aob_effects_to_json(const struct aob_effects *effects);

/* The rows with their sentences, the sets that no other one beats in both error and time, and what was chosen. */
void aob_effects_print(const struct aob_effects *effects, struct aob_text *out);

/* Adds a config that draws the chosen set, ready for `run`. `scene`: its entry of the list of scenes, in braces. */
void aob_effects_write_config(const struct aob_effects *effects, const char *scene, struct aob_text *text);
#endif
