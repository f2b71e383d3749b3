/* The lit image of a set beside the truth, both made smaller: `shrink` x `shrink` pixels become one, the mean of their surfaces, so that
 * what is looked at has more rays a pixel than what was traced. */
#ifndef AOB_EFFECTS_SMALL_H
#define AOB_EFFECTS_SMALL_H
#include "drawn.h"

struct aob_small {
    int width, height;
    float *image, *truth; /* R G B a pixel */
    float *depth;         /* INFINITY where no surface is */
};

/* aob_small_finish frees. A view smaller than `shrink` gives no pixel. */
void aob_small_init(struct aob_small *small, const struct aob_seen *seen, const struct aob_drawn *drawn,
                    unsigned set, int shrink);
void aob_small_finish(struct aob_small *small);

/* FLIP in colour at an exposure; NAN without a pixel. It takes a while. */
double aob_small_flip(const struct aob_small *small, double exposure);

/* Writes channels Z, technique.lit, reference.lit and error.lit (docs/design.md, EXR channels). */
bool aob_small_write(const struct aob_small *small, const char *path, struct aob_error *error);
#endif
