/* The mesh as Embree holds it, and in double precision. The files of the tracer share it. Two spaces: *local* is
 * scene units less the box's centre (double); *unit* is local * to_unit (float, Embree's), the longest side of the
 * box being 1. */
#ifndef AOB_REFERENCE_EMBREE_MESH_H
#define AOB_REFERENCE_EMBREE_MESH_H
#include <embree3/rtcore.h>
#include "tracer.h"

struct aob_tracer {
    RTCDevice device;
    RTCScene scene;
    float (*unit_points)[3];       /* Embree's, padded by one */
    uint32_t (*unit_triangles)[3]; /* Embree's: those with an area */
    uint32_t *triangle_of;         /* Embree's primitive -> triangle of the mesh */
    struct aob_vec3 *points;       /* local, vertex_count */
    struct aob_vec3 *normals;      /* shading, or NULL */
    uint32_t (*triangles)[3];      /* triangle_count */
    size_t vertex_count, triangle_count, unit_count;
    struct aob_material *materials;    /* a table, [0] the default one */
    uint32_t *material_of;             /* of a triangle, its place in the table, or NULL: all are of [0] */
    struct aob_vec3 centre, half;      /* of the box, scene units */
    size_t moving_first, moving_count; /* triangles that stood a step earlier a frame before; 0: none */
    struct aob_vec3 step;
    double to_unit;
};

/* Embree wants denormals flushed. aob_float_mode_end restores the mode; each thread needs its own pair of calls. */
unsigned aob_float_mode_begin(void);
void aob_float_mode_end(unsigned mode);

/* Gives the corners of a triangle in local space, and returns its normal (counter-clockwise), which is not
 * normalised. */
struct aob_vec3 aob_tracer_corners(const struct aob_tracer *tracer, uint32_t triangle,
                                   struct aob_vec3 corner[3]);

/* What a triangle is made of. */
const struct aob_material *aob_tracer_material(const struct aob_tracer *tracer, uint32_t triangle);
#endif
