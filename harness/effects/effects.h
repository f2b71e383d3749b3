/* `aobudget effects`: which effects of ambient occlusion the lit image of a view calls for.
 *
 * The truth is traced once at the view's own size with few rays, and its noise, which two halves tell, is taken out of the
 * errors; so nothing has to be scaled from a smaller frame. Rules take out what changes the image too little to count (bound.h). Of what is left a frame
 * at each size of occlusion holds every output; the lit image of each set is made of them (drawn.h). Four frames at most are timed, and
 * the cost of a set is the sum of its passes (cost.h).
 *
 * The mean over time is a frame at each size more, the last of the view's sequence, or of AOB_EFFECT_HISTORY frames that stand still. Where
 * something moves, the flicker of all four counts beside their errors. Where nothing does, a mean that gains too little is left out.
 *
 * A capture has no surfaces to trace: its own image of full size stands for the truth, with the effects that its materials allow. It is one
 * frame, so it has no mean over time. */
#ifndef AOB_EFFECTS_EFFECTS_H
#define AOB_EFFECTS_EFFECTS_H
#include "answer.h"
#include "frames.h"

struct aob_effects_desc {
    const struct aob_dispatch *dispatch;
    struct aob_effect_maker maker;
    struct aob_effect_ask ask;
    const char *folder; /* for its frames; it exists */
    int spp;            /* rays a pixel of the truth; 0: as many as the size needs */
    bool picture;       /* a view without motion is one picture: no frames before it are to be thought of */
    void (*on_work)(void *user, const char *work); /* before each step; NULL: nobody asks */
    void *user;
};

/* A plan of effects, of one view. aob_effects_finish frees. */
struct aob_effects {
    struct aob_effect_answer answer;
    /* As measured; zero where there were none. Images: a second time of longer sequences. */
    struct aob_sweep truth, images[2], flickers, times[2];
    json_t *truth_records, *image_records[2], *flicker_records, *time_records[2];
    int spp;
    bool unsupported; /* what failed is a frame that this device does not draw, or no device */
    double truth_s, images_s, times_s; /* wall time of the measurements; flicker counts as images */
    struct aob_seen seen;
    struct aob_drawn drawn
        [AOB_EFFECT_IMAGES]; /* by aob_effect_image_of, with every effect that is open; empty where none were */
};

/* False after a line. */
bool aob_effects_plan(const struct aob_effects_desc *desc, struct aob_effects *effects,
                      struct aob_error *error);
void aob_effects_finish(struct aob_effects *effects);

/* The measurement whose plan says which view, light and lengths these are. */
const struct aob_sweep *aob_effects_sweep(const struct aob_effects *effects);
#endif
