/* The caches of profiles over the fetches of one frame: `aobudget cache --technique ...`. */
#ifndef AOB_COMMAND_CACHE_FRAME_H
#define AOB_COMMAND_CACHE_FRAME_H
#include "command.h"
#include "single.h"

struct aob_cache_frame_desc {
    struct aob_common *common;
    const struct aob_single_flags *frame;
    const char *profiles; /* "P[,P...]"; NULL: not given */
    const char *out;      /* EXR file of the misses by pixel; NULL: none */
};
/* The table goes to the common's `out`, the record to its `json`. */
enum aob_exit aob_cache_frame(const struct aob_cache_frame_desc *desc, struct aob_error *error);
#endif
