/* The caches of a profile, fed with a capture. The simulation is a sink (trace.h): it orders the invocations of each band
 * as the profile says, gives each texel its address, and sends it through the levels, once with one warp in flight and
 * once with the most.
 *
 * Memory, all of it at most: for each cache and each of the two orders 16 bytes for each of its lines, a bit for each
 * sector of the textures, and for each of their lines 4 bytes, 12 more with a curve of powers of two, 46 more with one of
 * every size. And for each unit 32 bytes (64 with a map) for each word that its warps in flight fetch: up to four texels
 * each, in arrays that double as they grow; fewer words than the invocations of a pass have, and none where one warp is in
 * flight. The first part is taken from the room (room.h) before a frame begins, the second before a pass's first band;
 * what does not fit is refused then.
 * Threads: one at a time for each object. */
#ifndef AOB_PROFILE_SIMULATE_H
#define AOB_PROFILE_SIMULATE_H
#include "result.h"
#include "room.h"
#include "trace.h"

enum aob_curve_kind {
    AOB_CURVE_NONE,
    AOB_CURVE_POWERS, /* sizes of 1, 2, 4 ... lines, and the level's own */
    AOB_CURVE_EVERY,  /* every size; slower */
};

struct aob_simulation_desc {
    const struct aob_profile *profile; /* borrowed, until the simulation is destroyed */
    enum aob_curve_kind
        curve; /* of the first level; without one capacity and conflict are not told apart either */
    bool map;  /* of misses by pixel */
    enum aob_flight map_flight; /* that the map is of */
    struct aob_room *room;      /* of all simulations that run at once, borrowed; NULL: this one is alone */
};

struct aob_simulation;
struct aob_simulation *aob_simulation_create(const struct aob_simulation_desc *desc);
void aob_simulation_destroy(struct aob_simulation *simulation);

/* Takes one frame. It fails with a line where a texture or a cache is too large to be simulated. */
struct aob_trace_sink aob_simulation_sink(struct aob_simulation *simulation);

/* After the last pass has ended. It belongs to the simulation. */
const struct aob_cache_result *aob_simulation_result(const struct aob_simulation *simulation);

/* What pass number `pass` of the capture executed (result.h); without it there are no modelled times. */
void aob_simulation_count(struct aob_simulation *simulation, size_t pass,
                          const struct aob_operations *operations);

/* Several sinks as one, such as several profiles over one capture. The struct is borrowed. */
struct aob_trace_fan {
    const struct aob_trace_sink *sinks;
    size_t count;
};
struct aob_trace_sink aob_trace_fan_sink(struct aob_trace_fan *fan);
#endif
