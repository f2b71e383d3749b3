/* What a frame leaves for the next one, for a frame of other programs to read: a traced or counted frame is one of many, but only it is
 * drawn with the programs that write down what they do. Threads: as the device's. */
#ifndef AOB_FRAME_PAST_H
#define AOB_FRAME_PAST_H
#include "frame.h"

struct aob_past {
    int number;                                    /* of the frame that left it */
    struct aob_gpu_texture *left[AOB_MAX_TEXTURE]; /* borrowed; NULL where nothing is kept */
};

/* What the last run of a frame left. It holds until that frame is drawn twice more, or is finished. */
void aob_past_take(const struct aob_frame *frame, struct aob_past *past);

/* The frame 0 of a technique that keeps a history, drawn for what it leaves. */
struct aob_first {
    struct aob_frame frame; /* plain; without a screen where the technique keeps no history */
    struct aob_past past;
    bool unfit; /* after a refusal: as of a frame (frame.h) */
};

/* Draws frame 0 of what `desc` describes, by plain programs, and takes what it leaves. Nothing is made where the technique keeps no
 * history. False leaves nothing behind but `unfit`. */
bool aob_first_init(struct aob_first *first, struct aob_screen *screen, const struct aob_frame_desc *desc,
                    struct aob_error *error);
void aob_first_finish(struct aob_first *first); /* of a zeroed one too */

/* What it left; NULL where the technique keeps no history. */
const struct aob_past *aob_first_past(const struct aob_first *first);
#endif
