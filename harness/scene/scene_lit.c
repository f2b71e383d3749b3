#include "base/memory.h"
#include "mesh_solids.h"
#include "scene_interior.h"
#include "scene_table.h"

static struct aob_material matte(float r, float g, float b)
{
    return (struct aob_material){.base_colour = {r, g, b}, .roughness = 1};
}

/* --- One furnished room in white and in black. --- */

static void add_shelf(struct aob_mesh *mesh)
{
    static const double widths[] = {0.05, 0.03, 0.06, 0.04, 0.05, 0.03, 0.07, 0.04};
    static const double heights[] = {0.27, 0.3, 0.24, 0.28, 0.31, 0.22, 0.26, 0.29};
    for (int side = 0; side < 2; side++)
        aob_mesh_add_box(mesh, aob_vec(side ? -0.84 : -2.4, 0, -2.5), aob_vec(side ? -0.8 : -2.36, 2, -2.15),
                         0);
    for (int board = 0; board < 5; board++) {
        double y = 0.08 + 0.47 * board;
        aob_mesh_add_box(mesh, aob_vec(-2.36, y, -2.5), aob_vec(-0.84, y + 0.03, -2.16), 0);
        double x = -2.34 + 0.12 * board;
        for (size_t i = 0; board < 4 && i < 20; i++) {
            size_t k = (i + 3 * (size_t)board) % AOB_COUNT(widths);
            aob_mesh_add_box(mesh, aob_vec(x, y + 0.03, -2.46),
                             aob_vec(x + widths[k], y + 0.03 + heights[k], -2.24), 0);
            x += widths[k] + 0.004;
        }
    }
}

static void add_furniture(struct aob_mesh *mesh)
{
    add_shelf(mesh);
    aob_interior_add_table(mesh, aob_vec(-0.9, 0, -0.5), aob_vec(0.7, 0.74, 0.4), 12);
    aob_interior_add_block(mesh, aob_vec(-0.35, 0.74, 0), aob_vec(0.3, 0.22, 0.2), 40);
    aob_interior_add_block(mesh, aob_vec(0.3, 0.74, -0.1), aob_vec(0.22, 0.04, 0.3), -20);
    aob_interior_add_block(mesh, aob_vec(0.3, 0.78, -0.1), aob_vec(0.2, 0.05, 0.26), 5);
    aob_interior_add_table(mesh, aob_vec(-0.5, 0, 0.6), aob_vec(-0.05, 0.45, 1.05), 20);
    aob_interior_add_table(mesh, aob_vec(1, 0, -0.55), aob_vec(1.45, 0.45, -0.1), -8);
    aob_interior_add_block(mesh, aob_vec(2.3, 0, -1.9), aob_vec(0.8, 0.8, 0.7), 0); /* boxes in the corner */
    aob_interior_add_block(mesh, aob_vec(2.35, 0.8, -1.95), aob_vec(0.5, 0.5, 0.5), 25);
    aob_interior_add_block(mesh, aob_vec(1.4, 0, -2.05), aob_vec(0.5, 0.5, 0.5), -15);
    aob_interior_add_block(mesh, aob_vec(1.75, 0, -1.3), aob_vec(0.35, 0.3, 0.45), 33);
    aob_interior_add_block(mesh, aob_vec(-2.65, 0, 0.4), aob_vec(0.7, 0.42, 1.9),
                           0); /* a bench by the wall */
    aob_interior_add_block(mesh, aob_vec(-2.88, 0.42, 0.4), aob_vec(0.24, 0.4, 1.88), 0);
    aob_interior_add_block(mesh, aob_vec(0.2, 1.2, -2.48), aob_vec(0.9, 0.7, 0.04),
                           0); /* a board on the wall */
}

static void build_matte(struct aob_mesh *mesh, float grey)
{
    const struct aob_interior room = {{-3, 0, -2.5}, {3, 3, 2.5}};
    aob_mesh_paint(mesh, matte(grey, grey, grey));
    for (int wall = 0; wall < AOB_WALL_COUNT; wall++)
        aob_interior_add_wall(mesh, &room, (enum aob_wall)wall);
    add_furniture(mesh);
}

static void build_matte_white(struct aob_mesh *mesh)
{
    build_matte(mesh, 0.85f);
}

static void build_matte_dark(struct aob_mesh *mesh)
{
    build_matte(mesh, 0.05f);
}

static const struct aob_view matte_views[] = {
    AOB_VIEW("room", 2.7, 1.75, 2.2, -0.9, 0.75, -1, 60),
    AOB_VIEW("shelf", 0.2, 1.5, 0.9, -1.5, 0.95, -2.3, 55),
};
const struct aob_scene_info aob_scene_matte_white_room = {
    .name = "matte_white_room",
    .title = "Closed room x -3..3, y 0..3, z -2.5..2.5 m with a table, two stools, a shelf of 80 books, a "
             "bench and "
             "boxes, 1,356 triangles, all of base colour 0.85 and roughness 1",
    .metres_per_unit = 1,
    .metre = 1,
    .light = "uniform",
    .views = matte_views,
    .view_count = AOB_COUNT(matte_views),
    .build = build_matte_white,
};
const struct aob_scene_info aob_scene_matte_dark_room = {
    .name = "matte_dark_room",
    .title = "The room of matte_white_room, 1,356 triangles, all of base colour 0.05 and roughness 1",
    .metres_per_unit = 1,
    .metre = 1,
    .light = "uniform",
    .views = matte_views,
    .view_count = AOB_COUNT(matte_views),
    .build = build_matte_dark,
};

/* --- White things between coloured walls. --- */

static void add_white_things(struct aob_mesh *mesh)
{
    const struct aob_turning cone[] = {{0, 0}, {0.32, 0}, {0.32, 0.04}, {0.03, 0.95}, {0, 0.97}};
    aob_interior_add_block(mesh, aob_vec(-0.8, 0, -1.1), aob_vec(0.7, 1.5, 0.7), 20);
    aob_interior_add_block(mesh, aob_vec(1.35, 0, -1.2), aob_vec(0.9, 0.6, 0.6), -25);
    aob_mesh_add_sphere(mesh, aob_vec(1.35, 0.9, -1.2), 0.3, 48);
    aob_mesh_add_sphere(mesh, aob_vec(-2, 0.35, 0.2), 0.35, 48);
    aob_mesh_add_sphere(mesh, aob_vec(0.25, 0.25, 0.4), 0.25, 48);
    aob_mesh_add_lathe(mesh, aob_vec(0.35, 0, -1), aob_vec(0, 1, 0), cone, AOB_COUNT(cone), 48);
    aob_mesh_add_cylinder(mesh, aob_vec(1.9, 0, 0.5), aob_vec(1.9, 0.8, 0.5), 0.28, 48);
    aob_interior_add_block(mesh, aob_vec(-0.7, 0, 1.3), aob_vec(0.5, 0.35, 0.5), 40);
}

static void build_coloured_walls(struct aob_mesh *mesh)
{
    const struct aob_interior room = {{-2.5, 0, -2}, {2.5, 3, 2}};
    const struct aob_material white = matte(0.8f, 0.8f, 0.8f);
    const struct aob_material paints[AOB_WALL_COUNT] = {
        [AOB_WALL_FLOOR] = white,
        [AOB_WALL_CEILING] = white,
        [AOB_WALL_BACK] = matte(0.05f, 0.1f, 0.7f),
        [AOB_WALL_FRONT] = matte(0.8f, 0.65f, 0.04f),
        [AOB_WALL_LEFT] = matte(0.75f, 0.05f, 0.04f),
        [AOB_WALL_RIGHT] = matte(0.06f, 0.6f, 0.08f),
    };
    for (int wall = 0; wall < AOB_WALL_COUNT; wall++) {
        aob_mesh_paint(mesh, paints[wall]);
        aob_interior_add_wall(mesh, &room, (enum aob_wall)wall);
    }
    aob_mesh_paint(mesh, white);
    add_white_things(mesh);
}

static const struct aob_view coloured_views[] = {
    AOB_VIEW("blue", 0.4, 1.5, 1.85, 0, 0.8, -1.2, 70),
    AOB_VIEW("yellow", -2, 1.7, 0.1, 1.2, 0.5, 0.5, 70),
};
const struct aob_scene_info aob_scene_coloured_walls = {
    .name = "coloured_walls",
    .title =
        "Closed room x -2.5..2.5, y 0..3, z -2..2 m, 7,152 triangles: walls of base colour 0.75 0.05 0.04 "
        "(left), 0.06 0.6 0.08 (right), 0.05 0.1 0.7 (back) and 0.8 0.65 0.04 (front); floor, ceiling and "
        "eight "
        "blocks, balls, a cone and a drum of 0.8; roughness 1",
    .metres_per_unit = 1,
    .metre = 1,
    .light = "uniform",
    .views = coloured_views,
    .view_count = AOB_COUNT(coloured_views),
    .build = build_coloured_walls,
};

/* --- A room that one window lights. --- */

static void add_window_things(struct aob_mesh *mesh)
{
    aob_mesh_add_box(mesh, aob_vec(1.1, 0, 0.9), aob_vec(1.3, 2.8, 2.5), 0);      /* a wall into the room */
    aob_mesh_add_box(mesh, aob_vec(-0.6, 0, -2.5), aob_vec(-0.2, 2.8, -2.1), 0);  /* a pillar */
    aob_mesh_add_box(mesh, aob_vec(-3, 0.85, -1.1), aob_vec(-2.75, 0.9, 1.1), 0); /* the sill */
    aob_interior_add_table(mesh, aob_vec(-2.2, 0, -0.8), aob_vec(-1.2, 0.74, 0.9), 6);
    aob_interior_add_block(mesh, aob_vec(-1.75, 0.74, -0.3), aob_vec(0.25, 0.3, 0.25), 30);
    aob_mesh_add_sphere(mesh, aob_vec(-1.6, 0.89, 0.35), 0.15, 48);
    aob_mesh_add_cylinder(mesh, aob_vec(-1.95, 0.74, 0.15), aob_vec(-1.95, 1.04, 0.15), 0.06, 32);
    aob_interior_add_table(mesh, aob_vec(-0.85, 0, -0.2), aob_vec(-0.4, 0.45, 0.25), -14);
    aob_interior_add_block(mesh, aob_vec(0.5, 0, -1.6), aob_vec(0.5, 0.9, 1.1), 0);
    aob_interior_add_block(mesh, aob_vec(0.45, 0.9, -1.45), aob_vec(0.3, 0.35, 0.4), -18);
    aob_interior_add_block(mesh, aob_vec(2, 0, -1.9), aob_vec(0.9, 0.5, 0.7), 15);
    aob_mesh_add_sphere(mesh, aob_vec(1.5, 0.3, -0.7), 0.3, 48);
    aob_interior_add_block(mesh, aob_vec(-0.2, 0, 1.5), aob_vec(0.5, 0.5, 0.5), 35);
}

static void build_window_room(struct aob_mesh *mesh)
{
    const struct aob_interior room = {{-3, 0, -2.5}, {3, 2.8, 2.5}}, window = {{-4, 0.9, -1}, {-2, 2.3, 1}};
    aob_mesh_paint(mesh, matte(0.7f, 0.7f, 0.7f));
    for (int wall = 0; wall < AOB_WALL_COUNT; wall++)
        if (wall != AOB_WALL_LEFT)
            aob_interior_add_wall(mesh, &room, (enum aob_wall)wall);
    aob_interior_add_opening(mesh, &room, AOB_WALL_LEFT, &window, 0.3);
    add_window_things(mesh);
}

static const struct aob_view window_views[] = {
    AOB_VIEW("room", 2.6, 1.6, 0.5, -1.8, 0.85, -0.5, 65),
    AOB_VIEW("table", -0.1, 1.35, 1.1, -1.9, 0.75, -0.3, 60),
};
const struct aob_scene_info aob_scene_window_room = {
    .name = "window_room",
    .title = "Room x -3..3, y 0..2.8, z -2.5..2.5 m with one open window, y 0.9..2.3, z -1..1 m, in its wall "
             "x = -3, "
             "4,786 triangles: a wall into the room, a pillar, a table, a stool, chests and balls; base "
             "colour 0.7, "
             "roughness 1",
    .metres_per_unit = 1,
    .metre = 1,
    .light = "window",
    .views = window_views,
    .view_count = AOB_COUNT(window_views),
    .build = build_window_room,
};
