/* The velocity texture: where each surface point was in the frame before, as a renderer would hold it. */
#ifndef AOB_FRAME_VELOCITY_TEXELS_H
#define AOB_FRAME_VELOCITY_TEXELS_H
#include "gbuffer/gbuffer.h"

/* Four half floats a pixel, AOB_RGBA16F: the pixels, right and down, by which the point has moved over the image, the depth it
 * had less the depth that it has (scene units), and 1 where it was before the camera, else 0. Without velocities everything
 * stood still. What half floats cannot hold is taken for what was not there. The caller frees them. */
void *aob_velocity_texels(const struct aob_gbuffer *gbuffer);
#endif
