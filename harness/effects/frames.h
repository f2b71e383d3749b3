/* Frames of a plan of effects: measured as a run measures its cases, in workers, into a folder of their own. */
#ifndef AOB_EFFECTS_FRAMES_H
#define AOB_EFFECTS_FRAMES_H
#include <jansson.h>
#include "effect_row.h"
#include "run/sweep.h"

/* The scene, its view, size and backend, and the entry of the technique that is planned with what is fixed of its parameters and
 * of the run options: a config of one case (command/single.h). False after a line; it is finished either way. */
struct aob_effect_maker {
    bool (*make)(void *user, struct aob_config *config, struct aob_error *error);
    void *user;
};

struct aob_effect_frames_desc {
    const struct aob_dispatch *dispatch;
    struct aob_effect_maker maker;
    const char *folder; /* that exists; images/ in it gets a picture of each frame that is not timed */
    const unsigned
        *sets;        /* one frame each; more effects than a set may hold draw their outputs all the same */
    size_t count;     /* AOB_BLOCK_MAX at most */
    bool unlit;       /* no lit image is wanted, as of a capture */
    int spp;          /* rays a pixel of the truth; 0: there is none */
    int still_frames; /* of a sequence, where the view has no motion of its own; 0: one picture */
    double seconds;   /* of timing a frame; 0: they are not timed */
    const char *profile; /* times are modelled on it; NULL: on none */
    bool *unsupported;   /* set where a frame's record says so; NULL: nobody asks */
};

/* A journal's record for each set, in their order; NULL after a line if one of them is not ok. `sweep` is filled in, and to be
 * finished in any case: its plan has the camera, the light and the lengths. Decref the array. */
json_t *aob_effect_frames_measure(const struct aob_effect_frames_desc *desc, struct aob_sweep *sweep,
                                  struct aob_error *error);

/* The file of a record's image below the folder; free() it. NULL without an image. */
char *aob_effect_frames_image(const struct aob_effect_frames_desc *desc, const json_t *record);

/* False after a line: a run option or a parameter of that entry is one that a plan chooses itself. */
bool aob_effect_frames_judge(const struct aob_config *config, size_t entry, struct aob_error *error);

/* Makes axes of what the effects in `some` choose, of the run options and of the entry of a technique; without `unlit` the lit image is wanted. */
void aob_effect_frames_widen(struct aob_config *config, size_t entry, unsigned some, bool unlit);

/* The set that a planned case draws: of technique `none` its outputs alone, so 0 if nothing is wanted of it. */
unsigned aob_effect_set_of(const struct aob_case *c);
#endif
