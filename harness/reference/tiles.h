/* The part of an image that a trace computes, in tiles on all cores. What the traces have in common is here: the check
 * of the part and of the rays a pixel, and the loop over the pixels. */
#ifndef AOB_REFERENCE_TILES_H
#define AOB_REFERENCE_TILES_H
#include "tracer.h"

struct aob_tiles {
    const struct aob_hits *hits;
    int x0, y0, width, height; /* of the part within the hits */
};

/* A part of no size is all of the hits. False after a line that begins with `name` if the part is not within them, or
 * if `spp` is not even and 2 to 65536. */
bool aob_tiles_init(struct aob_tiles *tiles, const struct aob_hits *hits, const int part[4], int spp,
                    const char *name, struct aob_error *error); /* part: x0, y0, width, height */

/* What is done for each pixel. `pixel` counts in the hits, `out` in the part. The order of the pixels and their threads
 * differ from call to call, so a pixel's result may depend on its own numbers only. */
struct aob_tiles_work {
    const void *job;
    size_t scratch_size; /* of what each thread has for itself; it is zero before scratch_init */
    void (*scratch_init)(void *scratch, const void *job);
    void (*scratch_finish)(void *scratch);
    void (*do_pixel)(const void *job, size_t pixel, size_t out, void *scratch);
};

/* Denormals are flushed meanwhile, as Embree wants it (aob_float_mode_begin). */
void aob_tiles_run(const struct aob_tiles *tiles, const struct aob_tiles_work *work);
#endif
