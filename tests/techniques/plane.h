/* An open plane for the tests of techniques. */
#ifndef AOB_TESTS_PLANE_H
#define AOB_TESTS_PLANE_H
#include <math.h>
#include "rig.h"

/* Its distance from the camera along the axis, scene units; its tilt from facing the camera, degrees, towards an
 * azimuth of the image. It fills the image, guard band included, at a tilt below 90 degrees less half the view's. */
static inline void aob_plane_rig(struct aob_rig *rig, double distance, double tilt_deg, double azimuth_deg,
                                 int width, int height, int guard)
{
    double t = tilt_deg * M_PI / 180, a = azimuth_deg * M_PI / 180, size = 100 * distance;
    struct aob_vec3 n = aob_vec(sin(t) * cos(a), sin(t) * sin(a), cos(t));
    struct aob_vec3 u =
        aob_vec_normalize(aob_vec_cross(fabs(n.y) < 0.9 ? aob_vec(0, 1, 0) : aob_vec(1, 0, 0), n));
    struct aob_vec3 v = aob_vec_cross(n, u);
    struct aob_mesh mesh = {0};
    struct aob_camera camera = {.eye = {0, 0, distance}, .fov_deg = 45};
    aob_mesh_add_quad(&mesh, aob_vec_scale(aob_vec_add(u, v), -size / 2), aob_vec_scale(u, size),
                      aob_vec_scale(v, size));
    aob_rig_init(rig, &mesh, &camera, width, height, guard);
    aob_mesh_finish(&mesh);
}
#endif
