/* The screen-space bound: the visibility that is left when the scene is only what the depth buffer shows. The
 * surface is rebuilt from depth and geometric normal of all pixels, guard band included, and the rays of
 * aob_tracer_visibility are traced against it: the same directions, from the same points (to the rounding of
 * the depth). What separates it from the ray-traced truth is information that no screen-space technique has.
 *
 * The rebuilt surface. A *cell* lies between four neighbouring pixel centres. Two neighbours a and b are
 * *joined* if max(|d.n_a|, |d.n_b|) <= 2 w, with d the vector between their points and w a pixel's width at
 * the nearer one: each lies in the other's tangent plane, nearly. Lengths only enter as ratios.
 *   whole cell (all four sides joined): two triangles between the four points, split along the diagonal
 *     whose middle is farther away.
 *   cut cell: each pixel has its own quarter, on its tangent plane, clamped to the depths in the cell; in a
 *     cell with sky, to half and twice those. Joined neighbours share the middle of their side and the
 *     quarter's corner, so that a gap opens along the cut only.
 * With Z(q) the depth of that surface at image position q:
 *   infinite: all that lies behind it is solid, {z >= Z(q)}: cuts are closed by walls along the view rays.
 *     Against the sky walls end at 4 times the view's farthest depth.
 *   slab: {Z(q) <= z <= Z(q) + thickness}, closed on all sides; not beyond those 4 times.
 *   thin: the whole cells alone, without thickness: what is known to be there. A feature one pixel wide has
 *     no whole cell, and is in the other two only.
 * So thin, slab and infinite each contain the one before: with the same rays each is no brighter than the one
 * before; of a slab to rounding, which lets single rays through. Outside the rectangle of the outermost pixel
 * centres, and in the sky, there is nothing. */
#ifndef AOB_REFERENCE_BOUND_H
#define AOB_REFERENCE_BOUND_H
#include "tracer.h"

enum aob_bound_kind { AOB_BOUND_INFINITE, AOB_BOUND_THIN, AOB_BOUND_SLAB };

struct aob_bound_desc {
    enum aob_bound_kind kind;
    double thickness; /* slab: along the view axis, scene units, > 0; else unused */
    size_t memory;    /* bytes that it may take; 0: no ceiling */
};

struct aob_bound;

/* Reads `depth` (0: sky) and `normal` of the hits, and keeps nothing of them. NULL after one line if the thickness is
 * not positive, if aob_tracer_create fails, or if it needs more memory than it may take: 0.3 to 4 KB a pixel, most where
 * thin things are cut everywhere. A picture that has nothing but sky, or nothing that can be joined, is
 * open everywhere. It is used by one thread at a time, as a tracer is. */
struct aob_bound *aob_bound_create(const struct aob_camera *camera, const struct aob_projection *projection,
                                   const struct aob_hits *hits, const struct aob_bound_desc *desc,
                                   struct aob_error *error);
void aob_bound_destroy(struct aob_bound *bound);

/* Does what aob_tracer_visibility does, with all its terms. With the same desc it traces the same rays as the truth. */
bool aob_bound_visibility(const struct aob_bound *bound, const struct aob_visibility_desc *desc,
                          struct aob_visibility *result, struct aob_error *error);

/* The version is raised when any value of the bound could change for the same truth. It is part of cache keys. */
extern const char aob_bound_version[];
#endif
