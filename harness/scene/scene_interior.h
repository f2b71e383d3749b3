/* Rooms seen from inside, for the procedural scenes: walls without thickness whose fronts face in. Metres. */
#ifndef AOB_SCENE_SCENE_INTERIOR_H
#define AOB_SCENE_SCENE_INTERIOR_H
#include "mesh.h"

struct aob_interior {
    struct aob_vec3 low, high;
};
enum aob_wall {
    AOB_WALL_FLOOR,
    AOB_WALL_CEILING,
    AOB_WALL_BACK,
    AOB_WALL_FRONT,
    AOB_WALL_LEFT,
    AOB_WALL_RIGHT
};
enum { AOB_WALL_COUNT = 6 }; /* back is at the least z, front at the greatest; left at the least x */

void aob_interior_add_wall(struct aob_mesh *mesh, const struct aob_interior *room, enum aob_wall wall);

/* Adds a wall with a hole in it, and the hole's sides, which reach `depth` outwards. The hole is the part of the wall
 * that lies within `hole`, a box; it reaches no edge of the wall. */
void aob_interior_add_opening(struct aob_mesh *mesh, const struct aob_interior *room, enum aob_wall wall,
                              const struct aob_interior *hole, double depth);

/* Adds a table on the floor y = 0: a top 0.05 thick between `low` and `high`, whose y is the height, on four legs 0.06
 * thick, 0.05 from its edges; turned about its centre. */
void aob_interior_add_table(struct aob_mesh *mesh, struct aob_vec3 low, struct aob_vec3 high,
                            double turn_y_deg);

/* Adds a box as aob_mesh_add_box does, by the middle of its lower face and its sizes. */
void aob_interior_add_block(struct aob_mesh *mesh, struct aob_vec3 foot, struct aob_vec3 size,
                            double turn_y_deg);
#endif
