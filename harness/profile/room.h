/* The memory that simulations may take together: half of what this process may use (base/machine.h). The other half is
 * left to the captures that feed them, to the driver and to the system. What is to be allocated is counted before it is;
 * a room ends with what was allocated in it, so nothing is given back. */
#ifndef AOB_PROFILE_ROOM_H
#define AOB_PROFILE_ROOM_H
#include "base/error.h"

struct aob_room { /* zero: nothing is taken */
    double taken; /* bytes */
};

double aob_room_size(void); /* bytes */

/* Counts the bytes as taken. False with a line if they are more than is left: "WHO may take 3.1 GiB ...: ADVICE". */
bool aob_room_take(struct aob_room *room, double bytes, const char *who, const char *advice,
                   struct aob_error *error);
#endif
