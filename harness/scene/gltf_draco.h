/* Geometry that Draco compressed, by the library's decoder; C in front of its C++. */
#ifndef AOB_SCENE_GLTF_DRACO_H
#define AOB_SCENE_GLTF_DRACO_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#ifdef __cplusplus
extern "C" {
#endif

struct aob_draco; /* a decoded mesh */

/* NULL, and a reason in `why`, if the bytes are no Draco mesh; aob_draco_destroy frees. */
struct aob_draco *aob_draco_create(const void *bytes, size_t size, char *why, size_t why_size);
void aob_draco_destroy(struct aob_draco *draco);

size_t aob_draco_vertex_count(const struct aob_draco *draco);
size_t aob_draco_triangle_count(const struct aob_draco *draco);
void aob_draco_triangles(const struct aob_draco *draco, uint32_t (*triangles)[3]);

/* How many numbers an element of the attribute of this unique id has; 0: there is none. */
int aob_draco_components(const struct aob_draco *draco, uint32_t id);
/* The numbers of all vertices; normalised integers are converted. */
bool aob_draco_numbers(const struct aob_draco *draco, uint32_t id, double *values);

#ifdef __cplusplus
}
#endif
#endif
