#include "room.h"
#include "base/machine.h"

double aob_room_size(void)
{
    return (double)aob_machine_memory() / 2;
}

bool aob_room_take(struct aob_room *room, double bytes, const char *who, const char *advice,
                   struct aob_error *error)
{
    double left = aob_room_size() - room->taken;
    if (bytes > left)
        return aob_fail(
            error,
            "%s may take %.3g GiB, and %.3g GiB is left of the half of this machine's memory that "
            "simulations may take: %s",
            who, bytes / 0x1p30, left / 0x1p30, advice);
    room->taken += bytes;
    return true;
}
