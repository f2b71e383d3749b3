/* Half-size images against full-size ones, for the tests of techniques. */
#ifndef AOB_TESTS_TECHNIQUES_HALF_H
#define AOB_TESTS_TECHNIQUES_HALF_H
#include <math.h>
#include "rig.h"

/* Which object of scene `spheres` is seen: 0 sky, 1 floor, 2... the spheres. */
static inline int aob_half_object(const struct aob_rig *rig, int x, int y)
{
    static const struct {
        double x, y, z;
    } centres[] = {{0, 1, 0}, {M_SQRT2, 0.5, 0}, {-0.6, 0.25, 0.8}, {0.5, 0.125, 1.5}, {-1.5, 0.6, 0.6}};
    static const double radii[] = {1, 0.5, 0.25, 0.125, 0.4};
    struct aob_vec3 p;
    if (!aob_rig_position(rig, x, y, &p))
        return 0;
    double least = fabs(p.y);
    int object = 1;
    for (int i = 0; i < 5; i++) {
        struct aob_vec3 d = aob_vec_sub(p, aob_vec(centres[i].x, centres[i].y, centres[i].z));
        double off = fabs(sqrt(aob_vec_dot(d, d)) - radii[i]);
        object = off < least ? i + 2 : object;
        least = fmin(least, off);
    }
    return object;
}

/* Pixels of an upsampled image whose value is none between those of the low pixels around them on their own object.
 * Low pixel q is the image's own pixel q * divisor. `alone`: pixels without such a neighbour, which are not judged. */
static inline size_t aob_half_phantoms(const struct aob_rig *rig, const float *image, int divisor,
                                       size_t *alone)
{
    size_t phantoms = 0;
    *alone = 0;
    for (int y = 0; y < rig->height - divisor; y++)
        for (int x = 0; x < rig->width - divisor; x++) {
            float low = INFINITY, high = -INFINITY, v = image[y * rig->width + x];
            int own = aob_half_object(rig, x, y);
            for (int i = 0; own && i < 4; i++) {
                int lx = (x / divisor + (i & 1)) * divisor, ly = (y / divisor + i / 2) * divisor;
                if (aob_half_object(rig, lx, ly) != own)
                    continue;
                low = fminf(low, image[ly * rig->width + lx]);
                high = fmaxf(high, image[ly * rig->width + lx]);
            }
            *alone += own && low > high;
            phantoms += own && low <= high && (v < low - 1e-3f || v > high + 1e-3f); /* half floats */
        }
    return phantoms;
}
#endif
