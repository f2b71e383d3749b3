/* What a profile's device does in a second: the rates of the device model (model.h). */
#ifndef AOB_PROFILE_RATES_H
#define AOB_PROFILE_RATES_H
#include <stdbool.h>

struct aob_rates {
    double clock;     /* GHz, of everything but the lanes; 0: the profile has no rates */
    double alu_clock; /* GHz, of the lanes */
    double
        lanes; /* scalar operations a clock of it, of all units; a multiplication with its addition is one */
    double special;       /* share of that rate at which a special function runs: 0.25 */
    bool special_blocks;  /* the lanes wait meanwhile; else both run side by side */
    double texture_units; /* texels of 32 bits or less a clock, of all units, filtered or not */
    double
        tags; /* banks of tags of a texture unit, a power of two: lines in different ones are found at once */
    double point_64; /* how often the cost of a 32-bit one an unfiltered texel of 64 bits has: 1 or 2 */
    double rops;     /* pixels a clock into a target */
    double memory;   /* GB/s */
    double launch;   /* us from the end of a pass to the first pixels of the next */
};
#endif
