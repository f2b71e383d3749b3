/* For effects.c: a plan of effects under way, and its steps. Each step that can fail returns false after a line. */
#ifndef AOB_EFFECTS_PLANNER_H
#define AOB_EFFECTS_PLANNER_H
#include "cost.h"
#include "effects.h"

struct aob_effect_planner {
    const struct aob_effects_desc *desc;
    struct aob_effects *effects;
    struct aob_effect_costs costs;
};

/* Tells who asks what is done next. */
void aob_effect_planner_say(const struct aob_effect_planner *p, const char *work);

struct aob_effect_frames_desc aob_effect_planner_frames(const struct aob_effect_planner *p,
                                                        const unsigned *sets, size_t count);

/* From the image of the first record of a measurement, which showed this sweep. */
bool aob_effect_planner_see(struct aob_effect_planner *p, const json_t *records,
                            const struct aob_sweep *sweep, struct aob_error *error);

/* Draws sets at the first turn (0) or the second, where nothing moves as the last of so many frames (0: one), and reads each image into
 * its place; the first time also what is seen, where that is not known. */
struct aob_effect_turn {
    int turn, still_frames;
    const unsigned *sets;
    size_t count;
};
bool aob_effect_planner_draw(struct aob_effect_planner *p, const struct aob_effect_turn *turn,
                             struct aob_error *error);

/* Draws all that is open (look.c): each size of occlusion, of one frame and of the mean over frames, and measures the flicker of a
 * sequence. Takes the mean out of what is open where nothing moves and it gains too little. */
bool aob_effect_planner_look(struct aob_effect_planner *p, struct aob_error *error);

/* The flicker of a set; NAN where the view is no sequence. */
double aob_effect_planner_flicker(const struct aob_effect_planner *p, unsigned set);

/* Times sets, at the first turn (0) or the second. */
bool aob_effect_planner_time(struct aob_effect_planner *p, int turn, const unsigned *sets, size_t count,
                             struct aob_error *error);

/* Errors and costs of all sets that are open, and the choice. */
bool aob_effect_planner_judge(struct aob_effect_planner *p, struct aob_error *error);

/* Draws and looks at a capture (capture.c), which has no truth, and some materials or none: bits AOB_MATERIAL_BIT. Its own image of full size
 * with all that is open stands for the truth. */
bool aob_effect_planner_capture(struct aob_effect_planner *p, unsigned materials, struct aob_error *error);
#endif
