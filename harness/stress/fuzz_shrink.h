/* The smallest frame that fails as a given one does: fewer pixels, no guard band, fewer hostile pixels, values and options at
 * their defaults, a flat surface, fewer triangles. Each step is kept if the frame then fails in the same way. */
#ifndef AOB_STRESS_FUZZ_SHRINK_H
#define AOB_STRESS_FUZZ_SHRINK_H
#include "fuzz_draw.h"

/* Changes the frame and what is seen of it. `sight` is the frame's. */
void aob_fuzz_shrink(struct aob_fuzz_artist *artist, struct aob_fuzz_frame *frame,
                     struct aob_fuzz_sight *sight);
#endif
