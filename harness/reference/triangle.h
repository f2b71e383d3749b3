/* A triangle as a set of points. */
#ifndef AOB_REFERENCE_TRIANGLE_H
#define AOB_REFERENCE_TRIANGLE_H
#include "base/vec.h"

/* From p to the nearest point of the triangle; 0 on it. Any triangle with an area, in p's units. */
double aob_triangle_distance(struct aob_vec3 p, const struct aob_vec3 corner[3]);
#endif
