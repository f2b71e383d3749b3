/* The misses by pixel, from the image file that has them: a picture, and a file for ParaView. */
#ifndef AOB_COMMAND_CACHE_MAP_H
#define AOB_COMMAND_CACHE_MAP_H
#include "base/text.h"

struct aob_cache_map_desc {
    const char
        *image; /* FILE.exr with the channel PROFILE.misses; the others are FILE-PROFILE.png and .vti */
    const char *profile;
    const char *title;
    const char *program; /* beside which aobudget-plot lies */
};
/* One warning where a file cannot be drawn. Adds a line to `out` that names those that are there, unless it is NULL. */
void aob_cache_map_draw(const struct aob_cache_map_desc *desc, struct aob_text *out);
#endif
