/* The mesh of a screen-space bound; bound.h defines it. */
#ifndef AOB_REFERENCE_BOUND_MESH_H
#define AOB_REFERENCE_BOUND_MESH_H
#include "bound.h"

/* How many vertices and triangles aob_bound_mesh would make, exactly, without making them. */
struct aob_bound_size {
    size_t vertices, triangles;
};
struct aob_bound_size aob_bound_mesh_size(const struct aob_camera *camera,
                                          const struct aob_projection *projection,
                                          const struct aob_hits *hits, const struct aob_bound_desc *desc);

/* Builds the mesh in world space. Vertex i and triangle i, which has no area, are the point of pixel i, so a pixel is
 * named as a hit is: primitive i, u = v = 0. All kinds have the same bounds, so a tracer rounds them alike. False,
 * with an empty mesh, if no pixel shows a surface. */
bool aob_bound_mesh(const struct aob_camera *camera, const struct aob_projection *projection,
                    const struct aob_hits *hits, const struct aob_bound_desc *desc, struct aob_mesh *mesh);
#endif
