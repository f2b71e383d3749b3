/* The loaders of Vulkan and EGL, which belong to the system. Where it has none (containers often get a GPU's driver alone),
 * those that the program was packed with take their place: a driver finds its way to either. */
#ifndef AOB_GPU_CHECK_LOADER_H
#define AOB_GPU_CHECK_LOADER_H
#include <jansson.h>

/* "LD_LIBRARY_PATH=..." for gpu-check-device, with the folders below `folder` whose loaders the system lacks; free() it. NULL:
 * it lacks none. `packed` gets their names. */
char *aob_loader_environment(const char *folder, json_t *packed);
#endif
