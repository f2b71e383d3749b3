/* The G-buffer drawn by a device's rasteriser, and how it differs from the canonical one.
 * The rasteriser decides which triangle a pixel shows (its corners snap to a grid, usually 1/256 pixel, so an
 * edge may pass a pixel's centre on the other side than a ray sees it); depth and normal are then those of
 * the triangle's plane on the ray through the pixel's centre, as in the canonical G-buffer. Triangles are given
 * to the device in view space, relative to the eye, from double precision, so a scene far from the origin keeps
 * its detail. */
#ifndef AOB_FRAME_RASTER_H
#define AOB_FRAME_RASTER_H
#include "gpu/gpu.h"
#include "reference/tracer.h"

enum { AOB_RASTER_MAX_TRIANGLES = (1 << 24) - 1 }; /* numbers that a float holds, 0 being none */

/* Fills `hits` like aob_tracer_cast, but u and v stay NULL; aob_hits_finish frees. What lies nearer to the eye
 * along the view axis than 2^-20 of the mesh's farthest point is cut: a near plane must be somewhere, and
 * reversed float depth is as fine with a small one. Triangles without an area are skipped. False after one
 * line: too many triangles, or the device fails; a device that draws nothing (info.draws_nothing) is refused. */
bool aob_raster_draw(struct aob_gpu *gpu, const struct aob_mesh *mesh, const struct aob_camera *camera,
                     const struct aob_projection *projection, struct aob_hits *hits, struct aob_error *error);

/* Pixels are those of the whole G-buffer. An edge: a pixel whose 3x3 neighbourhood holds more than one primitive
 * (sky counts as one) in the canonical G-buffer. Depths are compared where both see the same primitive. */
struct aob_raster_difference {
    size_t pixels, other, off_edge; /* other: of another primitive; off_edge: of those, not at an edge */
    double depth_rmse, depth_max;   /* scene units */
    double depth_relative_max;      /* over the canonical depth */
    double normal_max;              /* largest difference of a component of the geometric normal */
};
void aob_raster_compare(const struct aob_hits *canonical, const struct aob_hits *drawn,
                        struct aob_raster_difference *difference);
#endif
