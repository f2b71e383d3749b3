/* What sets of effects cost, from the passes of a few frames: passes add up. */
#ifndef AOB_EFFECTS_COST_H
#define AOB_EFFECTS_COST_H
#include <jansson.h>
#include "effect_row.h"

enum { AOB_EFFECT_FRAMES = 4 };

struct aob_effect_frame {
    unsigned set;
    const json_t *record; /* borrowed: of the journal's form, with times */
};
struct aob_effect_costs {
    struct aob_effect_frame frames[AOB_EFFECT_FRAMES];
    size_t count;
    bool unlit;          /* the frames have no lit image */
    const char *profile; /* times modelled on it count, not measured ones; NULL: measured ones */
};

/* Which frames are timed to know the cost of all sets that can be made of the effects in `open`: nothing, and where visibility is open also,
 * at half size, visibility with bounces and all that is open. Returns how many. Sets of full size are reckoned by the pixels then; a frame of plain
 * visibility beside these tells them exactly. */
size_t aob_effect_frames_choose(unsigned open, unsigned sets[AOB_EFFECT_FRAMES]);

/* Milliseconds of a frame with this set: those of the frame where it is one of the measured; else the sum of its passes, each from a frame that has
 * it. NAN where a pass has no time. */
double aob_effect_cost(const struct aob_effect_costs *costs, unsigned set);

/* The milliseconds of a whole frame by its record; NAN without. */
double aob_effect_frame_ms(const json_t *record, const char *profile);
#endif
