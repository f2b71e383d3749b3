/* Closed solids for the procedural scenes. Every front faces out, and every triangle has an area. Lengths are in
 * scene units. */
#ifndef AOB_SCENE_MESH_SOLIDS_H
#define AOB_SCENE_MESH_SOLIDS_H
#include <stdbool.h>
#include "mesh.h"

struct aob_turning { /* a point of a lathe's profile */
    double radius, height;
};

/* Adds what a lathe makes: the profile turned about the line from `base` along `axis` (any length but 0), in
 * `segments` >= 3 flat sides. Heights are from `base`. The profile runs with the solid on its left in the plane of
 * (radius, height), so it goes up the outside. It begins and ends on the axis (radius 0), or its last point is its
 * first, for a ring. */
void aob_mesh_add_lathe(struct aob_mesh *mesh, struct aob_vec3 base, struct aob_vec3 axis,
                        const struct aob_turning *profile, size_t count, int segments);

/* Adds a cylinder between the middles of its ends, as a lathe makes it. */
void aob_mesh_add_cylinder(struct aob_mesh *mesh, struct aob_vec3 from, struct aob_vec3 to, double radius,
                           int segments);

/* Adds the flat strip between two lines of `count` points each in one plane, pushed by `along`. outer[i] and inner[i]
 * are its rungs. Seen from where `along` points to, the lines run counter-clockwise with `outer` on their right. If
 * it is `closed`, the last rung is joined to the first (a gear's rim); otherwise both ends are walls (an arch). */
void aob_mesh_add_band(struct aob_mesh *mesh, const struct aob_vec3 *outer, const struct aob_vec3 *inner,
                       size_t count, struct aob_vec3 along, bool closed);

/* Adds a round rod along the line through `points` (count >= 2). Its corners are rounded to arcs of `bend` in 8
 * steps, and both ends are capped. Neighbouring points must lie farther apart than the arcs of both need. */
void aob_mesh_add_pipe(struct aob_mesh *mesh, const struct aob_vec3 *points, size_t count, double radius,
                       double bend, int segments);
#endif
