/* Normals as shaders are promised them: unit vectors towards the camera, whatever a G-buffer holds. Renderers' buffers have
 * zeros where nothing was written, NANs from a division, lengths from a filter, and the backs of surfaces. */
#ifndef AOB_GBUFFER_FACING_H
#define AOB_GBUFFER_FACING_H
#include "gbuffer.h"

/* Four floats a pixel, from `normals`, which are gbuffer->normal or gbuffer->shading; the caller frees them. Those that keep
 * the promise keep their bits. One that has no direction becomes that of the depth, as the option normals=from_depth has it.
 * One that points away from the camera is turned round where the depth's lies on its other side, else bent up to the
 * horizon (AOB_LEAST_FACING). The sky's are 0. */
float *aob_facing_normals(const struct aob_gbuffer *gbuffer, const float *normals);
#endif
