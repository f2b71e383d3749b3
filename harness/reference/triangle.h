/* A triangle as a set of points. */
#ifndef AOB_REFERENCE_TRIANGLE_H
#define AOB_REFERENCE_TRIANGLE_H
#include "base/vec.h"

/* The distance from p to the nearest point of the triangle, in p's units; 0 on it. The triangle may be any with an
 * area. */
double aob_triangle_distance(struct aob_vec3 p, const struct aob_vec3 corner[3]);
#endif
