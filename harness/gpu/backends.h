/* The tables that gpu.c registers, one a folder (gl has two). For gpu.c and the backends only. */
#ifndef AOB_GPU_BACKENDS_H
#define AOB_GPU_BACKENDS_H
#include "gpu/gpu.h"

extern const struct aob_gpu_fns aob_gpu_vulkan;
extern const struct aob_gpu_fns aob_gpu_gl_egl;
extern const struct aob_gpu_fns aob_gpu_gl_osmesa;

/* Textures are memory, programs are compiled and never run, every pass writes zeros and takes 100 ns a texel
 * of each target, by a clock that looks at sizes only. */
extern const struct aob_gpu_fns aob_gpu_null;
#endif
