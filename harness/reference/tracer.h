/* The ray tracer: a mesh in Embree, primary hits, and visibility of many definitions from one set of rays. Everything
 * given and returned is in scene units. The tracer recentres and rescales inside (the mesh's box to unit size, in
 * double precision), so that a scene's place and scale do not show. A tracer is used by one thread at a time; its
 * calls use all cores (OpenMP). */
#ifndef AOB_REFERENCE_TRACER_H
#define AOB_REFERENCE_TRACER_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/error.h"
#include "scene/camera.h"
#include "scene/mesh.h"

struct aob_tracer;

/* Keeps its own copy of what it needs. Triangles without an area are skipped; the others keep their numbers. NULL
 * after an error line if aob_mesh_check refuses the mesh, or if it has no extent or no area. */
struct aob_tracer *aob_tracer_create(const struct aob_mesh *mesh, struct aob_error *error);
void aob_tracer_destroy(struct aob_tracer *tracer);

enum { AOB_NO_PRIMITIVE = 0xffffffffu }; /* sky */

/* What the camera sees at pixel centres. Row 0 is the top. Both sides of a triangle are seen alike. */
struct aob_hits {
    int width, height;   /* guard band included */
    uint32_t *primitive; /* triangle, or AOB_NO_PRIMITIVE */
    float *u, *v;        /* barycentric: p = (1-u-v) p0 + u p1 + v p2 */
    float *depth;        /* scene units along the view axis, exact to float rounding; 0 where sky */
    float (*normal)[3];  /* geometric, view space, unit, turned to the camera; 0 where sky */
    float (*shading)[3]; /* shading normal, on the geometric one's side and not turned away from the camera
                            (AOB_LEAST_FACING); the geometric one where the mesh has none */
    /* NULL unless the camera or a part of the mesh moves. The first two: how many pixels, right and down, the point in the
     * pixel's centre has moved over the image since the previous frame, its place now less its place then. The third: how
     * far it was then from the previous camera along that one's view axis, scene units. A point of a triangle that moves
     * was a step earlier then. The sky lies infinitely far, AOB_NO_VELOCITY: it moves with the camera's rotation only, and
     * not at all in an orthographic view. If the point was behind the previous camera, all three are AOB_NO_VELOCITY, a
     * displacement larger than any image. */
    float (*velocity)[3];
};
#define AOB_NO_VELOCITY 1e9f

/* A shading normal that leans away from the camera, as interpolated and bump-mapped ones do where a surface is seen at a
 * flat angle, is bent in the plane of the two until its cosine with the direction to the camera is this, or the
 * geometric normal's cosine if that is less. Turning it round would point it into the surface. The value is above what
 * three components of 8 bits are rounded by (sqrt(3) / 255), so that the normal faces the camera as it is read, too. The
 * options oct_rg8 (sqrt(18) / 255) and packed8 turn a normal by more, as in the renderers that have them. */
#define AOB_LEAST_FACING 0x1p-6

/* Embree decides which triangle is hit; the place on it, depth, normals and velocity are computed in double precision
 * on the pixel's own ray. `camera` must have passed aob_camera_check. Allocates the arrays of `hits`. */
void aob_tracer_cast(const struct aob_tracer *tracer, const struct aob_camera *camera,
                     const struct aob_projection *projection, struct aob_hits *hits);
void aob_hits_finish(struct aob_hits *hits);

/* One visibility to compute: V = map(1 - mean over directions of [hit within radius] *
 * falloff(distance/radius)). */
struct aob_visibility_term {
    double radius; /* scene units; INFINITY allowed (then falloff must be NULL) */
    bool uniform;  /* weighting of directions: uniform over the hemisphere, else cosine */
    bool
        of_triangle; /* distance: from the surface point to the nearest point of the triangle that the ray meets
                             first, however far along the ray; else along the ray */
    const float *falloff; /* `falloff_count` values over sqrt(t) = 0..1, linear between; NULL: 1 */
    size_t falloff_count; /* >= 1 with a table; 1: that value throughout */
    bool bent;            /* the mean open direction is wanted too */
};
struct aob_visibility_desc {
    const struct aob_visibility_term *terms;
    size_t term_count;
    int x0, y0, width, height; /* the part of the hits to compute, the guard band cropped; 0 size: all */
    int spp;                   /* rays a pixel: two independent halves of spp/2; even, 2..65536 */
    uint32_t seed;
};
struct aob_visibility { /* width * height floats each, scene part only; sky pixels are 1 with se 0 */
    float *ao;          /* (A+B)/2, before any map */
    float *se;          /* |A-B|/2: the standard error's estimate of the pixel; pool it as an RMS */
    float (*bent)
        [3]; /* mean over directions of direction times openness, view space: 0 where closed, and its length
                           is below 1 (2/3 on an open plane, cosine-weighted). Sky pixels are 0. NULL unless the term
                           asks for it */
};
/* Fills result[term_count] (its arrays are allocated here; aob_visibility_finish frees). False after one line if spp,
 * part, radius or falloff is bad, or if terms differ in of_triangle, whose rays have no end; nothing is allocated
 * then. `camera` is the one that cast the hits. One closest-hit trace, to the largest radius, serves all terms
 * (design.md, References 1): directions about hits->normal, Owen-scrambled Sobol, each pixel and half scrambled by
 * its own hash of place and seed; the same result for any number of threads. Directions are cosine-distributed if all
 * terms are. If any is `uniform`, all are drawn from the density (cos + 1/2) / (2 pi), half of each kind. Their
 * weights are cos / (cos + 1/2) or 1 / (cos + 1/2), over the sum of the weights, which is the balance heuristic
 * (Veach 1997, 9.2) in one stratified set. A cosine term that is traced beside a uniform one therefore has another
 * (equally good) noise than alone, and a cache key has to say which it was. Rays start at the barycentric hit point,
 * moved towards the camera until it is 2^-23 of the mesh's longest side above the surface. (Waechter and Binder's
 * offset, Ray Tracing Gems ch. 6, is up to 128 times that, along the normal.) Hits so near that rounding could have
 * made them are checked again in double precision, so that a plane and a convex solid are open exactly. */
bool aob_tracer_visibility(const struct aob_tracer *tracer, const struct aob_camera *camera,
                           const struct aob_hits *hits, const struct aob_visibility_desc *desc,
                           struct aob_visibility *result, struct aob_error *error);
void aob_visibility_finish(struct aob_visibility *visibility);

/* The version is raised when any traced value could change. It is part of cache keys. */
extern const char aob_tracer_version[];
#endif
