/* How much a frame leaves out, because nothing can occlude it (technique/clearance.h). */
#ifndef AOB_FRAME_LEFT_OUT_H
#define AOB_FRAME_LEFT_OUT_H
#include "frame.h"

/* The share of the surfaces in the frame, guard band cropped, that its passes leave out: those of clear tiles, and those
 * whose radius is less than half a pixel (aob_is_clear in frame/clearance.glsl). 0..1; the sky does not count, and where
 * there is nothing else it is NAN. 0 of a frame without thrift. Reads a texture back, so the frame must have run. False if
 * the device fails. */
bool aob_frame_left_out(const struct aob_frame *frame, double *share, struct aob_error *error);
#endif
