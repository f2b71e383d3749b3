/* Random numbers that fix the geometry of a procedural scene: a thing's own number, hashed again and again. The hash is
 * "pcg" of Jarzynski and Olano, Hash Functions for GPU Rendering, JCGT 2020. */
#ifndef AOB_SCENE_SCENE_RANDOM_H
#define AOB_SCENE_SCENE_RANDOM_H
#include <stdint.h>

/* The next number of a sequence, in [0, 1). */
static inline double aob_scene_draw(uint32_t *sequence)
{
    uint32_t state = *sequence * 747796405u + 2891336453u;
    uint32_t word = ((state >> ((state >> 28) + 4)) ^ state) * 277803737u;
    *sequence = (word >> 22) ^ word;
    return *sequence * 0x1p-32;
}
#endif
