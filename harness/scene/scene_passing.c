#include "base/memory.h"
#include "scene_table.h"

/* The box passes along the wall, with a ball ahead of it, behind a post that stands still. */
static void build_passing_box(struct aob_mesh *mesh)
{
    aob_mesh_add_quad(mesh, aob_vec(-6, 0, 0), aob_vec(0, 0, 8), aob_vec(12, 0, 0));
    aob_mesh_add_quad(mesh, aob_vec(-6, 0, 0), aob_vec(12, 0, 0), aob_vec(0, 4, 0));
    aob_mesh_add_box(mesh, aob_vec(0.5, 0, 2), aob_vec(0.8, 0.5, 2.3), 0);
    aob_mesh_start(mesh, aob_vec(0.1, 0, 0));
    aob_mesh_add_box(mesh, aob_vec(-2.4, 0, 0.3), aob_vec(-1.6, 1, 0.9), 0);
    aob_mesh_add_sphere(mesh, aob_vec(-0.6, 0.35, 1.2), 0.35, 32);
    aob_mesh_rest(mesh);
}

static const struct aob_view passing_box_views[] = {
    AOB_VIEW("front", 0.3, 1.5, 4.4, 0, 0.5, 0.4, 50),
    AOB_VIEW("far", 3, 3.5, 9, 0, 0.4, 0, 45),
};
const struct aob_scene_info aob_scene_passing_box = {
    .name = "passing_box",
    .title =
        "Floor y = 0 (z 0..8) and wall z = 0 (y 0..4), x -6..6 m; a post x 0.5..0.8, y 0..0.5, z 2..2.3; a "
        "box x -2.4..-1.6, y 0..1, z 0.3..0.9 and a ball of radius 0.35 about (-0.6, 0.35, 1.2), which move "
        "by "
        "0.1 m along x a frame, 988 triangles",
    .metres_per_unit = 1,
    .metre = 1,
    .moves = true,
    .views = passing_box_views,
    .view_count = AOB_COUNT(passing_box_views),
    .build = build_passing_box,
};
