/* The files of the scenes share this: each large procedural scene has a file of its own, and scene.c has the table. */
#ifndef AOB_SCENE_SCENE_TABLE_H
#define AOB_SCENE_SCENE_TABLE_H
#include "scene.h"

#define AOB_VIEW(name_, ex, ey, ez, tx, ty, tz, fov)                                                         \
    {                                                                                                        \
        .name = name_, .camera = {.eye = {ex, ey, ez}, .target = {tx, ty, tz}, .fov_deg = fov }              \
    }

extern const struct aob_scene_info aob_scene_atrium, aob_scene_machine, aob_scene_grass;
extern const struct aob_scene_info aob_scene_wall, aob_scene_sheet, aob_scene_sphere, aob_scene_room,
    aob_scene_disc;
extern const struct aob_scene_info aob_scene_matte_white_room, aob_scene_matte_dark_room, aob_scene_gallery,
    aob_scene_coloured_walls, aob_scene_window_room, aob_scene_rocks, aob_scene_scattered_rocks,
    aob_scene_thicket, aob_scene_open_sky, aob_scene_passing_box;
#endif
