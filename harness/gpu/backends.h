/* The tables that gpu.c registers, one a folder (gl has two), and what the backends share. For gpu.c and the
 * backends only. */
#ifndef AOB_GPU_BACKENDS_H
#define AOB_GPU_BACKENDS_H
#include "gpu/glsl.h"
#include "gpu/gpu.h"

extern const struct aob_gpu_fns aob_gpu_vulkan;
extern const struct aob_gpu_fns aob_gpu_gl_egl;
extern const struct aob_gpu_fns aob_gpu_gl_osmesa;

/* Textures are memory, programs are compiled and never run, every pass writes zeros and takes 100 ns a texel
 * of its area on each target, by a clock that looks at sizes only. */
extern const struct aob_gpu_fns aob_gpu_null;

extern const char *const aob_gpu_driver_environment[]; /* of every backend that has a driver */

/* The default of a list (aob_gpu_devices); its count where no device can be opened. */
size_t aob_gpu_default_device(const struct aob_gpu_device_list *list);

/* The default where another API's is `like`: the same device by its render node, else by its name up to " (" within the
 * other one. The list's count where `like` is a GPU and what can be opened are processors only. */
size_t aob_gpu_default_like(const struct aob_gpu_device_list *list, const struct aob_gpu_device *like);

/* The slot `devices` of a backend that has one device, and what its `open` asks at its end: closes the device, and is NULL,
 * where `desc` wants another one. */
bool aob_gpu_single_device(const struct aob_gpu_fns *fns, struct aob_gpu_device_list *list, size_t *chosen,
                           struct aob_error *error);
struct aob_gpu *aob_gpu_keep_single(struct aob_gpu *gpu, const struct aob_gpu_desc *desc,
                                    struct aob_error *error);

/* Among a program's bindings: BIND_STORAGE. */
#define AOB_GPU_STORAGE_BIT ((uint64_t)1 << AOB_GLSL_STORAGE)

/* The words of one stage of a program: compiled and, of the fragment text, rewritten as the desc says. Allocated (free()), or
 * NULL after one line. What they declare (aob_glsl_bindings) is added to `bindings`. */
uint32_t *aob_gpu_program_words(const struct aob_gpu_program_desc *desc, enum aob_glsl_stage stage,
                                enum aob_glsl_client client, size_t *count, uint64_t *bindings,
                                struct aob_error *error);

struct aob_gpu_texture aob_gpu_texture_base(const struct aob_gpu_texture_desc *desc);

/* How often a submit repeats a list of `count` passes that took list_ns (0: not known yet, so once), of `left` times: 1 or
 * more. */
int aob_gpu_submit_repeats(int64_t list_ns, size_t count, int left);

/* From a device's timestamp to a later one, each of `bits` valid bits (1..64): the counter may have wrapped in between,
 * and bits beyond the valid ones mean nothing. A tick is `period_ns`. */
int64_t aob_gpu_ticks_ns(uint64_t from, uint64_t to, unsigned bits, double period_ns);

int aob_gpu_bind_levels(const struct aob_gpu_bind *bind); /* that it shows */
#endif
