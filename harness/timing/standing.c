#include "standing.h"

bool aob_standing_check(const struct aob_gpu_time *whole, enum aob_clock clock, struct aob_error *error)
{
    if (whole->wall_ns < AOB_STANDING_NS)
        return aob_fail(error,
                        "the host's clock stands still: it saw %d ns of what the device drew; no time can be "
                        "measured on this machine",
                        (int)whole->wall_ns);
    if (clock == AOB_CLOCK_DEVICE && whole->device_ns <= 0) /* a time that nobody took is 0 */
        return aob_fail(error, "the device told no time by the %s clock", aob_clock_name(clock));
    return true;
}
