/* `aobudget worker`: one job in a process of its own. Reads one JSON document on standard input, answers with JSON
 * lines on standard output. Only here are modules loaded, drivers opened, meshes parsed; so a crash costs this job.
 *   describe {modules}
 *            -> a technique a line (aob_technique_to_json)
 *   probe    {backend}
 *            -> {device, driver, software}
 *   layout   {modules, technique, cases: [[number a parameter]]}
 *            -> {index, status, reason | graph, dot, triangles, definition: {radius, uniform, falloff, of_triangle} or
 *               null, mapped} a line
 *   mesh     {file, out}
 *            -> {low, high, vertices, triangles, warnings: [text]}
 *   capture  {file, depth, normals, near, far, left_handed, up, depth_channel, normal_channel, fov_deg, ortho_height,
 *             camera or null, out}
 *            -> {width, height, camera, surface, derived, warnings: [text]}
 *   view     {scene | mesh, captured, camera, width, height, guard, gbuffer, spp,
 *             terms: [{radius, uniform, falloff, of_triangle, screen (the bound's thickness; absent: the scene's),
 *             out}]}
 *            -> {trace_s, rays} for each trace
 *   block    {modules, scene | mesh, raster, triangles, backend, validate, camera, width, height, guard, gbuffer, seconds, time, error,
 *             cases: [{technique, params, options, radius, captured, reference, definition, screen, image}]}
 *            -> {index, status, reason, time, error, memory_bytes, fingerprint, gbuffer (where raster)} a line,
 *               then {shares}
 * A job that cannot be done says so in one line on standard error and exits with 2. */
#ifndef AOB_WORKER_WORKER_H
#define AOB_WORKER_WORKER_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "technique/registry.h"

int aob_worker_main(void); /* the exit code */

struct aob_worker {
    const json_t *job;
    int reply; /* file descriptor of the answers; what drivers print on standard output goes to standard error */
};
void aob_worker_reply(struct aob_worker *worker, json_t *answer); /* takes the reference */

bool aob_worker_registry(struct aob_worker *worker, struct aob_registry *registry, struct aob_error *error);
bool aob_worker_params(const struct aob_technique *technique, const json_t *numbers, void *values,
                       struct aob_error *error); /* into a buffer of 4 * AOB_MAX_PARAM bytes */
struct aob_camera;
struct aob_mesh;
bool aob_worker_mesh(const json_t *job, struct aob_mesh *mesh,
                     struct aob_error *error); /* its scene or mesh */
bool aob_worker_camera(const json_t *object, struct aob_camera *camera, struct aob_error *error);

bool aob_worker_capture(struct aob_worker *worker, struct aob_error *error);
bool aob_worker_view(struct aob_worker *worker, struct aob_error *error);
bool aob_worker_block(struct aob_worker *worker, struct aob_error *error);
#endif
