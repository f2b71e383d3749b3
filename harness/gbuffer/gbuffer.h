/* The canonical G-buffer is what the ray tracer sees at pixel centres, in the form that shaders and scores read. It
 * travels between processes as an EXR file (Z, N.X N.Y N.Z, S.X S.Y S.Z, primitive; V.X V.Y V.Z if the camera or an object
 * moves; material, albedo.R albedo.G albedo.B, roughness, metalness if the mesh has other materials than the default, or the capture has
 * some, but then without `material`; Z = 0 and
 * primitive = material = -1 where sky). */
#ifndef AOB_GBUFFER_GBUFFER_H
#define AOB_GBUFFER_GBUFFER_H
#include <stdbool.h>
#include "base/error.h"
#include "reference/tracer.h"
#include "scene/camera.h"
#include "store/image.h"

struct aob_gbuffer {
    struct aob_projection projection; /* guard band included */
    int guard;
    float *depth;  /* scene units along the view axis; AOB_GBUFFER_SKY where sky */
    float *normal; /* four floats a pixel: geometric normal, view space, towards the camera; 0 */
    /* The interpolated normals in the same form, on the geometric one's side. Where a mesh has none, the geometric. */
    float *shading;
    float *
        velocity; /* three floats a pixel, as struct aob_hits has them; NULL: nothing moves, and depth is what it was */
    float *albedo; /* three floats a pixel: base colour, linear, 0 where sky; NULL: the default throughout */
    float *shine;  /* two floats a pixel: roughness and metalness, 0 where sky; NULL with albedo */
};
#define AOB_GBUFFER_SKY 1e9f /* far beyond any scene, and its square is finite; AOB_SKY_Z in shaders */

/* Takes depth, normals and, if something moves, velocities from the hits of the tracer or of a rasteriser (frame/raster.h). Allocates;
 * aob_gbuffer_finish frees. */
void aob_gbuffer_init(struct aob_gbuffer *gbuffer, const struct aob_hits *hits,
                      const struct aob_projection *projection, int guard);

/* Adds the materials of the mesh that was hit to a G-buffer made of these hits; none if the mesh has no table of them. */
void aob_gbuffer_paint(struct aob_gbuffer *gbuffer, const struct aob_hits *hits, const struct aob_mesh *mesh);

/* Writes the hits into a file, with the materials of the mesh that was cast.
 * aob_gbuffer_load reads such a file; it allocates as well. */
bool aob_gbuffer_store(const struct aob_hits *hits, const struct aob_mesh *mesh, const char *path,
                       struct aob_error *error);

/* The same of a capture, whose materials are those of its pixels (capture.h); NULL twice: it has none. */
bool aob_gbuffer_store_capture(const struct aob_hits *hits, const float *albedo, const float *shine,
                               const char *path, struct aob_error *error);
struct aob_gbuffer_desc { /* what such a file must show */
    const struct aob_camera *camera;
    int width, height, guard; /* pixels; the guard band lies around width x height */
    bool objects_move;        /* so the file has velocities, as it has where the camera moves */
};
bool aob_gbuffer_load(struct aob_gbuffer *gbuffer, const char *path, const struct aob_gbuffer_desc *desc,
                      struct aob_error *error);

/* Goes the other way, for the screen-space bound of a capture (reference/bound.h): the hits hold depth, normals and
 * which pixels are sky (primitive 0 or none), but no place on a triangle. Allocates; aob_hits_finish frees. */
void aob_gbuffer_hits(const struct aob_gbuffer *gbuffer, struct aob_hits *hits);
void aob_gbuffer_finish(struct aob_gbuffer *gbuffer);

/* The version is raised when such files hold something else. It is part of cache keys. */
extern const char aob_gbuffer_version[];
#endif
