/* The scenes are procedural ones with fixed, published geometry, packaged meshes, and any mesh file. */
#ifndef AOB_SCENE_SCENE_H
#define AOB_SCENE_SCENE_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "camera.h"
#include "mesh.h"

struct aob_view {
    const char *name; /* "front" */
    struct aob_camera camera;
};
struct aob_scene_info {
    const char *name, *title; /* title: one sentence with the geometry in numbers */
    double metres_per_unit;
    /* Scene units that stand for a metre in the default lengths of techniques. It is 1 / metres_per_unit; of a packaged
     * model at most half of the box's middle side: defaults are made for rooms, and would swallow a smaller model. */
    double metre;
    const struct aob_view *views; /* view_count; the first is the default */
    size_t view_count;
    void (*build)(struct aob_mesh *mesh); /* procedural, as it is in frame 0; NULL: loaded from `file` */
    bool moves;                           /* a part of it moves from frame to frame (aob_mesh_move) */
    const char *file;                     /* absolute path of a packaged mesh, or NULL */
    const char *package;                  /* the Debian package that brings it, or NULL */
    const char *light;                    /* name of its light (light.h); NULL: uniform */
    const char *licence, *sha256;         /* of `file`: in words; of Debian 12's bytes. NULL if procedural */
};

/* NULL-ended, in the order that `list scenes` prints. */
extern const struct aob_scene_info *const aob_scenes[];

const struct aob_scene_info *aob_scene_find(const char *name); /* NULL if unknown */
const struct aob_view *aob_scene_view(const struct aob_scene_info *scene,
                                      const char *name); /* NULL name: the first; NULL if unknown */

/* Returns a camera that frames a mesh without views, from the front, above and a little to the right, with 60
 * degrees. */
struct aob_camera aob_scene_framing(struct aob_vec3 low, struct aob_vec3 high);
#endif
