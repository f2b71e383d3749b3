/* How much of what occludes a view are backs of triangles. Ray tracing does not care; a technique that draws the scene's
 * triangles by their fronts takes what lies behind a back for open. */
#ifndef AOB_REFERENCE_BACKS_H
#define AOB_REFERENCE_BACKS_H
#include "tracer.h"

enum { AOB_BACKS_RAYS = 16 }; /* a pixel */

/* The share of the cosine-weighted directions, over all surfaces that `camera`, which cast the hits, sees, whose first
 * hit within the radius is the back of a triangle: the mean visibility that is at stake. 0 without a surface. `radius`
 * is in scene units; INFINITY is allowed. Of closed solids that face outwards it is 0, in a room that faces inwards
 * too, and whether parts stand within others does not matter. */
double aob_tracer_backs(const struct aob_tracer *tracer, const struct aob_camera *camera,
                        const struct aob_hits *hits, double radius);
#endif
