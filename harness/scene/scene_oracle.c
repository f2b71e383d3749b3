/* Scenes for closed forms (reference/oracle_scene.h). They are small, so that a radius of 0.5 m reaches past each
 * edge. */
#include "base/memory.h"
#include "scene_table.h"

static void build_wall(struct aob_mesh *mesh)
{
    aob_mesh_add_quad(mesh, aob_vec(-20, 0, 0), aob_vec(0, 0, 40), aob_vec(40, 0, 0));
    aob_mesh_add_quad(mesh, aob_vec(-20, 0, 0), aob_vec(40, 0, 0), aob_vec(0, 0.25, 0));
}

static const struct aob_view wall_views[] = {
    AOB_VIEW("front", 0, 0.6, 1.3, 0, 0.05, 0.2, 50),
    AOB_VIEW("side", 1.2, 0.8, 1, 0, 0, 0.2, 50),
};
const struct aob_scene_info aob_scene_wall = {
    .name = "wall",
    .title = "Floor y = 0 (z 0..40), wall z = 0 of height 0.25 m, x -20..20 m: visibility of the floor in "
             "closed form (O3)",
    .metres_per_unit = 1,
    .metre = 1,
    .views = wall_views,
    .view_count = AOB_COUNT(wall_views),
    .build = build_wall,
};

static void build_sheet(struct aob_mesh *mesh)
{
    aob_mesh_add_quad(mesh, aob_vec(-20, 0, -20), aob_vec(0, 0, 40), aob_vec(40, 0, 0));
    aob_mesh_add_quad(mesh, aob_vec(-20, 0.2, -20), aob_vec(20, 0, 0), aob_vec(0, 0, 40));
}

static const struct aob_view sheet_views[] = {
    AOB_VIEW("front", 1.1, 0.7, 0.3, 0.1, 0, 0, 50),
    AOB_VIEW("below", 0.9, 0.15, 0.5, -0.05, 0.06, 0, 50),
};
const struct aob_scene_info aob_scene_sheet = {
    .name = "sheet",
    .title = "Floor y = 0, 40 x 40 m about the origin; 0.2 m above its half x < 0 a sheet without thickness: "
             "visibility of the floor in closed form (O4)",
    .metres_per_unit = 1,
    .metre = 1,
    .views = sheet_views,
    .view_count = AOB_COUNT(sheet_views),
    .build = build_sheet,
};

static void build_sphere(struct aob_mesh *mesh)
{
    aob_mesh_add_sphere(mesh, aob_vec(0, 0, 0), 0.5, 192);
}

static const struct aob_view sphere_views[] = {
    AOB_VIEW("front", 0, 0.3, 1.6, 0, 0, 0, 50),
    AOB_VIEW("close", 0.5, 0.5, 0.5, 0.2, 0.2, 0.2, 60),
};
const struct aob_scene_info aob_scene_sphere = {
    .name = "sphere",
    .title = "Sphere of radius 0.5 m about the origin, 36,480 triangles, nothing else: visibility is 1 "
             "everywhere (O5)",
    .metres_per_unit = 1,
    .metre = 1,
    .views = sphere_views,
    .view_count = AOB_COUNT(sphere_views),
    .build = build_sphere,
};

static void build_room(struct aob_mesh *mesh)
{
    struct aob_vec3 x = aob_vec(0.2, 0, 0), y = aob_vec(0, 0.2, 0), z = aob_vec(0, 0, 0.2);
    struct aob_vec3 low = aob_vec(-0.1, -0.1, -0.1), high = aob_vec(0.1, 0.1, 0.1);
    struct aob_vec3 back_x = aob_vec_scale(x, -1), back_y = aob_vec_scale(y, -1),
                    back_z = aob_vec_scale(z, -1);
    aob_mesh_add_quad(mesh, low, z, x);
    aob_mesh_add_quad(mesh, low, x, y);
    aob_mesh_add_quad(mesh, low, y, z);
    aob_mesh_add_quad(mesh, high, back_x, back_z);
    aob_mesh_add_quad(mesh, high, back_y, back_x);
    aob_mesh_add_quad(mesh, high, back_z, back_y);
}

static const struct aob_view room_views[] = {
    AOB_VIEW("inside", 0.08, 0.06, 0.09, -0.1, -0.05, -0.1, 80),
    AOB_VIEW("wall", -0.06, -0.05, -0.08, -0.1, 0.02, 0.05, 80),
};
const struct aob_scene_info aob_scene_room = {
    .name = "room",
    .title =
        "Closed cube of 0.2 m about the origin, seen from inside: visibility is 0 everywhere for a radius "
        "beyond its diagonal (O6)",
    .metres_per_unit = 1,
    .metre = 1,
    .views = room_views,
    .view_count = AOB_COUNT(room_views),
    .build = build_room,
};

static void build_disc(struct aob_mesh *mesh)
{
    aob_mesh_add_quad(mesh, aob_vec(-20, 0, -20), aob_vec(0, 0, 40), aob_vec(40, 0, 0));
    aob_mesh_add_disc(mesh, aob_vec(0, 0.15, 0), aob_vec(0, -1, 0), 0.15, 256);
}

static const struct aob_view disc_views[] = {
    AOB_VIEW("front", 0.5, 0.4, 0.6, 0, 0.03, 0, 50),
    AOB_VIEW("below", 0, 0.12, 0.7, 0, 0.05, 0, 50),
};
const struct aob_scene_info aob_scene_disc = {
    .name = "disc",
    .title =
        "Floor y = 0, 40 x 40 m about the origin; disc of radius 0.15 m without thickness at (0, 0.15, 0), "
        "level: visibility of the floor about its axis in closed form (O7)",
    .metres_per_unit = 1,
    .metre = 1,
    .views = disc_views,
    .view_count = AOB_COUNT(disc_views),
    .build = build_disc,
};
