/* A second implementation of LDR-FLIP: the paper's steps for any colours, in three channels, with filters of two
 * dimensions and the paper's radius. The matrix comes from the chromaticities of sRGB's primaries and of D65. It shares
 * no code with the harness. */
#ifndef AOB_TESTS_SCORE_DIRECT_FLIP_H
#define AOB_TESTS_SCORE_DIRECT_FLIP_H
#include <stdbool.h>

struct direct_colour { /* linear R, G, B, 0..1 */
    double c[3];
};

/* Images of width x height pixels, row 0 at the top. */
struct direct_pair {
    int width, height;
    const struct direct_colour *image, *truth;
    const bool *sky; /* which pixels do not count; what they hold is looked at as it is */
};
double direct_flip(const struct direct_pair *pair);

/* Of two images that hold one colour each: they have no features, and no filter changes them. */
double direct_flip_of_colours(struct direct_colour one, struct direct_colour other);
#endif
