/* What a plan of effects says of a capture. */
#ifndef AOB_EFFECTS_CAPTURE_WORDS_H
#define AOB_EFFECTS_CAPTURE_WORDS_H
#include "answer.h"

/* Adds what the lit image is compared with: "against 8 rays a pixel", or of a capture "in its own materials, against its own of full size with
 * visibility + multi_bounce, which no truth has judged". */
void aob_effect_against(const struct aob_effect_answer *answer, int spp, struct aob_text *text);

/* Adds a sentence: which channel the file lacks that the effect depends on. */
void aob_effect_explain_lack(enum aob_effect_id id, struct aob_text *text);
#endif
