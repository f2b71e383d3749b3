/* What changed between the images of two cases of one view. */
#ifndef AOB_COMPARE_IMAGE_CHANGE_H
#define AOB_COMPARE_IMAGE_CHANGE_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "store/image.h"

struct aob_image_change { /* over the pixels that are no sky */
    bool moved;           /* a pixel of what the technique wrote differs, visibility or bent normal */
    double max, rmse;     /* of the visibility: largest difference, root of the mean square */
    double share;         /* of pixels whose visibility differs by more than a step of 8 bits, 1 / 255 */
    size_t pixels;
};

/* Both images as a run keeps them (docs/design.md, EXR channels). False with a line where they are not of one view and
 * size, or hold no technique. */
bool aob_image_change_measure(struct aob_image_change *change, const struct aob_image *a,
                              const struct aob_image *b, struct aob_error *error);

/* The map of the change as an EXR file that the pictures are drawn from: technique.AO of B, reference.AO of A, error.AO
 * the one less the other, Z of A. */
bool aob_image_change_write(const struct aob_image *a, const struct aob_image *b, const char *path,
                            struct aob_error *error);
#endif
