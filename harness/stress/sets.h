/* The sets that properties build: meshes of a few closed solids, in scene units, fronts outwards, so that techniques which draw
 * triangles meet them too. Each adds to a mesh; nothing is painted. */
#ifndef AOB_STRESS_SETS_H
#define AOB_STRESS_SETS_H
#include "trial.h"

/* An open plane, far larger than what is seen of it. Zeros: 3 units before the camera, which has 60 degrees, and facing
 * it. */
struct aob_plane_desc {
    double distance, fov_deg, ortho_height;
    double tilt_deg, azimuth_deg; /* away from facing the camera, towards an azimuth of the image */
    double shift[2];
    int width, height, guard; /* 0: 48 x 32, no guard band */
};
struct aob_exhibit *aob_set_plane(struct aob_trial *trial, const struct aob_plane_desc *plane);

/* An open plane `out` from the eye, which looks along -z; its normal comes towards the axis of the view. 90 degrees, or
 * orthographic; 64 x 48, with a guard band of 16. */
struct aob_exhibit *aob_set_plane_beside(struct aob_trial *trial, struct aob_vec3 out, double ortho_height);

/* The still life: on a floor before a wall stand a box, a ball and a thin pillar; 5 units wide, all within 1.6 of the floor.
 * `scale` and `move` place it: everything is multiplied, then moved. */
void aob_set_still_life(struct aob_mesh *mesh, double scale, struct aob_vec3 move);
/* It as everybody looks at it: from (1.2, 1.7, 3.6) to (0, .4, 0), 50 degrees. */
struct aob_camera aob_still_life_camera(double scale, struct aob_vec3 move);
/* It, scaled and moved, as that camera sees it. */
struct aob_exhibit *aob_set_still_life_at(struct aob_trial *trial, double scale, struct aob_vec3 move,
                                          int width, int height);
/* 96 x 64 pixels of it at scale 1, where a radius of 1 covers some 20 pixels. */
struct aob_exhibit *aob_set_default(struct aob_trial *trial);

/* Turns all fronts of a mesh round. */
void aob_set_turn_faces(struct aob_mesh *mesh);

/* Floor y = 0 and wall z = 0 of an endless corner. */
void aob_set_corner(struct aob_mesh *mesh, double size);
#endif
