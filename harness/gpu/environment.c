#include "backends.h"

/* Code from a disk cache may have been made under other settings, and hides what a compile costs. */
const char *const aob_gpu_driver_environment[] = {
    "MESA_SHADER_CACHE_DISABLE=true",
    "__GL_SHADER_DISK_CACHE=0",
    NULL,
};
