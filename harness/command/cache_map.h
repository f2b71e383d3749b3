/* A picture of the misses by pixel. */
#ifndef AOB_COMMAND_CACHE_MAP_H
#define AOB_COMMAND_CACHE_MAP_H

struct aob_cache_map_desc {
    const char *image; /* FILE.exr with the channel PROFILE.misses; the picture is FILE-PROFILE.png */
    const char *profile;
    const char *title;
    const char *program; /* beside which aobudget-plot lies */
};
/* One warning where it cannot be drawn. */
void aob_cache_map_draw(const struct aob_cache_map_desc *desc);
#endif
