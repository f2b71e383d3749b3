/* A scene in front of a camera, as the properties of `stress` set it up: the mesh, what a ray sees of it at pixel centres,
 * and the G-buffer made of that. Everything is in scene units. Threads: one at a time. */
#ifndef AOB_STRESS_EXHIBIT_H
#define AOB_STRESS_EXHIBIT_H
#include "base/error.h"
#include "frame/geometry.h"
#include "gbuffer/gbuffer.h"
#include "reference/tracer.h"
#include "scene/camera.h"
#include "scene/mesh.h"

struct aob_exhibit_desc {
    struct aob_mesh *mesh; /* taken: the exhibit owns what it holds, and *mesh is empty afterwards */
    struct aob_camera camera;
    int width, height, guard; /* pixels; the guard band lies around width x height */
};
struct aob_exhibit {
    struct aob_mesh mesh;
    struct aob_camera camera;
    int width, height, guard;
    struct aob_tracer *tracer;
    struct aob_hits hits;       /* guard band included */
    struct aob_gbuffer gbuffer; /* likewise; a property may change its numbers before the exhibit is drawn */
    struct aob_geometry geometry;
};

/* False after one line; then there is nothing to finish, and the mesh is gone as well. */
bool aob_exhibit_init(struct aob_exhibit *exhibit, const struct aob_exhibit_desc *desc,
                      struct aob_error *error);
void aob_exhibit_finish(struct aob_exhibit *exhibit); /* of a zeroed one too */

/* Pixels of the image, and whether pixel i of it, counted from the top left without the guard band, shows a surface. */
size_t aob_exhibit_pixels(const struct aob_exhibit *exhibit);
bool aob_exhibit_is_surface(const struct aob_exhibit *exhibit, size_t i);

/* Its depth along the view axis (AOB_GBUFFER_SKY: sky), its world position, and its place in the G-buffer's arrays. */
float aob_exhibit_depth(const struct aob_exhibit *exhibit, size_t i);
struct aob_vec3 aob_exhibit_position(const struct aob_exhibit *exhibit, size_t i);
size_t aob_exhibit_place(const struct aob_exhibit *exhibit, size_t i);

/* Paints all of it, sky and guard band too, with one material: linear base colour; roughness and metalness. */
void aob_exhibit_paint(struct aob_exhibit *exhibit, const float albedo[3], const float shine[2]);

/* What is to be traced of its image, the guard band left out: one term, which must outlive it, with `spp` rays a pixel, an even
 * number. */
struct aob_visibility_desc aob_exhibit_rays(const struct aob_exhibit *exhibit,
                                            const struct aob_visibility_term *term, int spp);

/* The traced visibility of the image's pixels, cosine-weighted with a hard cutoff at `radius` (INFINITY allowed), into
 * width x height floats; sky is 1. `spp` rays a pixel, an even number. */
bool aob_exhibit_trace(const struct aob_exhibit *exhibit, double radius, int spp, float *visibility,
                       struct aob_error *error);
#endif
