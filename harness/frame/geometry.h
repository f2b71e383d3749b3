/* The scene's triangles on a device, for passes that draw them (AOB_TRIANGLES): corners in view space, relative to the
 * eye in double precision before they become floats, and the front's normal. Threads: as the device's. */
#ifndef AOB_FRAME_GEOMETRY_H
#define AOB_FRAME_GEOMETRY_H
#include "gpu/gpu.h"
#include "scene/camera.h"
#include "scene/mesh.h"
#include "technique/graph.h"

/* Texels of a triangle, RGBA32F: corner k and component k of the normal. AOB_GEOMETRY_ROW triangles a row. */
enum { AOB_GEOMETRY_TEXELS = 3, AOB_GEOMETRY_ROW = 2048 };

struct aob_geometry {
    size_t count;       /* triangles */
    float (*texels)[4]; /* whole rows */
    struct aob_gpu *gpu;
    struct aob_gpu_texture *texture; /* NULL before the upload */
};

/* Without a device; the mesh may go afterwards. aob_geometry_finish frees, also the texture. */
void aob_geometry_init(struct aob_geometry *geometry, const struct aob_mesh *mesh,
                       const struct aob_camera *camera);
bool aob_geometry_upload(struct aob_geometry *geometry, struct aob_gpu *gpu, struct aob_error *error);
void aob_geometry_finish(struct aob_geometry *geometry);

/* About how many fragments a frame of the pass has: the pixels of its outputs within the triangles' boxes along the view's
 * axes, each made larger by the pass's reach. A technique may draw less, or more if its shapes reach out of these.
 * `projection` is the G-buffer's, `divisor` the outputs'. */
double aob_geometry_fragments(const struct aob_geometry *geometry, const struct aob_projection *projection,
                              float reach, int divisor);

/* Whether the graph's passes of triangles can be run; else one line with the numbers. A device's textures end at 16384 x
 * 16384 texels. A frame of AOB_GEOMETRY_FRAGMENTS takes a processor about 7 s (57 ns each: ao_volumes on llvmpipe), and a
 * case of dearer frames would not end before its job does. NULL geometry: a captured frame. */
#define AOB_GEOMETRY_FRAGMENTS 1.2e8
bool aob_geometry_serves(const struct aob_geometry *geometry, const struct aob_pass_graph *graph,
                         const struct aob_projection *projection, struct aob_error *error);
#endif
