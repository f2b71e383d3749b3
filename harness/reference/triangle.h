/* A triangle as a set of points. */
#ifndef AOB_REFERENCE_TRIANGLE_H
#define AOB_REFERENCE_TRIANGLE_H
#include "base/vec.h"

/* The distance from p to the nearest point of the triangle, in p's units; 0 on it. The triangle may be any with an
 * area. */
double aob_triangle_distance(struct aob_vec3 p, const struct aob_vec3 corner[3]);

/* The place where the line from `origin` along `direction` meets the plane of the triangle, kept within the triangle:
 * corner[0] (1-u-v) + corner[1] u + corner[2] v. `normal` is (corner[1] - corner[0]) x (corner[2] - corner[0]). Where the
 * line does not meet the plane, the place that *u and *v had is kept, within the triangle too. */
void aob_triangle_meet(struct aob_vec3 origin, struct aob_vec3 direction, const struct aob_vec3 corner[3],
                       struct aob_vec3 normal, double *u, double *v);
#endif
