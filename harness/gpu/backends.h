/* The tables that gpu.c registers, one a folder (gl has two), and what the backends share. For gpu.c and the
 * backends only. */
#ifndef AOB_GPU_BACKENDS_H
#define AOB_GPU_BACKENDS_H
#include "gpu/gpu.h"

extern const struct aob_gpu_fns aob_gpu_vulkan;
extern const struct aob_gpu_fns aob_gpu_gl_egl;
extern const struct aob_gpu_fns aob_gpu_gl_osmesa;

/* Textures are memory, programs are compiled and never run, every pass writes zeros and takes 100 ns a texel
 * of its area on each target, by a clock that looks at sizes only. */
extern const struct aob_gpu_fns aob_gpu_null;

extern const char *const aob_gpu_driver_environment[]; /* of every backend that has a driver */

struct aob_gpu_texture aob_gpu_texture_base(const struct aob_gpu_texture_desc *desc);
int aob_gpu_bind_levels(const struct aob_gpu_bind *bind); /* that it shows */
#endif
