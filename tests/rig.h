/* A scene on a device, in this process. The tests of techniques and backends share it. */
#ifndef AOB_TESTS_RIG_H
#define AOB_TESTS_RIG_H
#include "check.h"
#include "frame/frame.h"
#include "reference/tracer.h"
#include "scene/scene.h"

struct aob_rig {
    struct aob_camera camera;
    struct aob_light light; /* world space; uniform until a test sets another */
    int width, height, guard;
    struct aob_hits hits;         /* guard band included */
    struct aob_gbuffer gbuffer;   /* likewise */
    struct aob_geometry geometry; /* not uploaded */
    struct aob_tracer *tracer;
};

/* Casts the mesh, and ends the test program on any failure. The mesh may be freed afterwards. */
void aob_rig_init(struct aob_rig *rig, const struct aob_mesh *mesh, const struct aob_camera *camera,
                  int width, int height, int guard);
void aob_rig_scene(struct aob_rig *rig, const char *scene, const char *view, int width, int height,
                   int guard);
/* An open plane that fills the image, seen along its middle. Zeros stand for 3 units away, a field of view of 60
 * degrees, and facing the camera. */
struct aob_rig_plane {
    double distance, fov_deg;
    double tilt_deg, azimuth_deg; /* from facing the camera, towards an azimuth of the image */
    int width, height, guard;
};
void aob_rig_plane(struct aob_rig *rig, const struct aob_rig_plane *plane);
void aob_rig_finish(struct aob_rig *rig);

/* Draws one frame of a built-in technique. `params` are such as "radius=1 slices=9", with run options among them
 * ("depth_encoding=r16f"; guard_band, fetch and threads do nothing here); the rest has its default. `pixels` holds
 * width x height floats. */
void aob_rig_run(const struct aob_rig *rig, struct aob_gpu *gpu, const char *technique, const char *params,
                 enum aob_fetch fetch, float *pixels);

/* The same with the bent normals, width x height vectors; NULL: not wanted. */
void aob_rig_run_open(const struct aob_rig *rig, struct aob_gpu *gpu, const char *technique,
                      const char *params, enum aob_fetch fetch, float *pixels, float (*bent)[3]);

/* The same with any outputs: images[enum aob_output] is NULL where one is not wanted, and else holds width x height pixels of
 * 1 float (visibility, specular) or 3. */
void aob_rig_run_outputs(const struct aob_rig *rig, struct aob_gpu *gpu, const char *technique,
                         const char *params, enum aob_fetch fetch, float *const images[AOB_OUTPUT_COUNT]);

/* What such parameters make of a technique's values struct (4 * AOB_MAX_PARAM bytes), and of the options. */
void aob_rig_params(const struct aob_technique *technique, const char *params, void *values,
                    struct aob_options *options);

/* Draws one frame of any technique, such as one that a test makes for the purpose. `values` is the technique's own
 * struct. */
void aob_rig_probe(const struct aob_rig *rig, struct aob_gpu *gpu, const struct aob_technique *technique,
                   const void *values, const struct aob_options *options, float *pixels);

/* The same with any outputs. */
void aob_rig_draw(const struct aob_rig *rig, struct aob_gpu *gpu, const struct aob_technique *technique,
                  const void *values, const struct aob_options *options,
                  float *const images[AOB_OUTPUT_COUNT]);

/* The text of that name of a built-in technique, its steps' among them. Ends the program if there is none. */
const char *aob_rig_text(const char *technique, const char *name);

/* Traces what that technique claims to compute with those parameters, as a run does. `pixels` holds width x height
 * floats; sky is 1. */
void aob_rig_definition(const struct aob_rig *rig, const char *technique, const char *params, int spp,
                        float *pixels);

/* Returns a device. If there is no driver for it, the program ends with exit code 77 and has failed, since ./dev
 * installs every driver; it ends with 1 if the device does not open for another reason. Vulkan runs under the
 * validation layer. */
struct aob_gpu *aob_rig_gpu(const char *backend);

/* Runs `count` tests on one device, which each has as its `*state`, and returns what main() returns. The backend is the
 * program's only argument; the driver finds the environment that a worker has. */
int aob_rig_device_tests(int argc, char **argv, const struct CMUnitTest *tests, size_t count);

/* Gives the world position of the surface in view pixel (x, y), guard band not counted. False for sky. */
bool aob_rig_position(const struct aob_rig *rig, int x, int y, struct aob_vec3 *position);

/* Returns the RMSE of a technique on `corner` against truth(distance to the other plane, radius), over pixels with
 * truth < 0.995. */
double aob_rig_corner_rmse(const struct aob_rig *rig, struct aob_gpu *gpu, const char *technique,
                           const char *params, double (*truth)(double d, double r), double radius);
#endif
