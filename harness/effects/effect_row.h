/* The effects that a scene may call for, a row each, and sets of them. A set is what a frame draws: bits 1 << enum
 * aob_effect_id. The empty set is the lit image without any occlusion (technique `none`); every other one holds visibility, which
 * the rest are made of. Data is const. */
#ifndef AOB_EFFECTS_EFFECT_ROW_H
#define AOB_EFFECTS_EFFECT_ROW_H
#include <stdbool.h>
#include <stddef.h>
#include "base/text.h"

enum aob_effect_id {
    AOB_EFFECT_VISIBILITY,
    AOB_EFFECT_MULTI_BOUNCE,
    AOB_EFFECT_BENT_NORMAL,
    AOB_EFFECT_DIRECTIONAL,
    AOB_EFFECT_SPECULAR,
    AOB_EFFECT_TEMPORAL,
    AOB_EFFECT_HALF_SIZE,
    AOB_EFFECT_COUNT
};
#define AOB_EFFECT_BIT(id) (1u << (id))
#define AOB_EFFECT_ALL     (AOB_EFFECT_BIT(AOB_EFFECT_COUNT) - 1)

/* `temporal` is a mean over so many frames. A view that nothing moves in is judged by a sequence of that many frames. */
enum { AOB_EFFECT_HISTORY = 16 };

enum { AOB_EFFECT_PASSES = 5 };
struct aob_effect_row {
    const char *name;
    const char *is;     /* what it is, to stand in a sentence */
    const char *option; /* the run option that wants it; NULL: it is a choice of the technique */
    struct {
        const char *name, *off, *on;
    } param; /* of the technique, with its two values; name NULL: no parameter chooses it */
    const char *const passes[AOB_EFFECT_PASSES + 1]; /* of the technique, which nothing else needs */
};
extern const struct aob_effect_row aob_effect_rows[AOB_EFFECT_COUNT];

/* Whether this is a run option or a parameter that a plan chooses itself: those of the rows, and `lit`. */
bool aob_effect_is_choice(const char *name);

bool aob_effect_has(unsigned set, enum aob_effect_id id);

/* Whether visibility lies in one texture with a bent normal, because the set needs one. */
bool aob_effect_set_bends(unsigned set);

/* What a frame of the set keeps for others: one of four images holds every set (drawn.h), by size and by whether it is a mean over time. */
enum { AOB_EFFECT_IMAGES = 4 };
size_t aob_effect_image_of(unsigned set);

/* Lists each set that can be made of the effects in `open`, the empty one first. Directional light leaves nothing for the bent normal to do
 * in the lit image, so no set holds both. Returns how many there are. */
enum { AOB_EFFECT_SETS = 49 };
size_t aob_effect_sets(unsigned open, unsigned sets[AOB_EFFECT_SETS]);

/* Adds "visibility + multi_bounce + half_size", or "nothing". */
void aob_effect_set_print(unsigned set, struct aob_text *text);
#endif
