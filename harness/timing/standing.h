/* Clocks that stand still. A loop that ends when a clock has gone far enough asks this of each submit, and so it ends. */
#ifndef AOB_TIMING_STANDING_H
#define AOB_TIMING_STANDING_H
#include <stdbool.h>
#include "base/clock.h"
#include "base/error.h"
#include "gpu/gpu.h"

enum { AOB_STANDING_NS = 100 }; /* on the host; a submit and the wait for its end always take more */

/* Whether the host's clock went on during the submits that took `whole`, and the device told a time if costs are judged by
 * its clock. False with a line. */
bool aob_standing_check(const struct aob_gpu_time *whole, enum aob_clock clock, struct aob_error *error);
#endif
