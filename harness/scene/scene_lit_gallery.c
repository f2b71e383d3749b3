#include "base/memory.h"
#include "mesh_solids.h"
#include "scene_interior.h"
#include "scene_table.h"

static struct aob_material paint(float r, float g, float b, float roughness)
{
    return (struct aob_material){.base_colour = {r, g, b}, .roughness = roughness};
}

static const struct aob_turning vase[] = {
    {0, 0},       {0.12, 0},    {0.14, 0.02}, {0.2, 0.16}, {0.22, 0.26}, {0.2, 0.36}, {0.12, 0.47},
    {0.08, 0.53}, {0.08, 0.58}, {0.12, 0.63}, {0.1, 0.63}, {0.06, 0.58}, {0, 0.58},
};

static const float colours[][3] = {{0.7f, 0.2f, 0.15f},
                                   {0.15f, 0.3f, 0.6f},
                                   {0.75f, 0.7f, 0.6f},
                                   {0.2f, 0.45f, 0.25f},
                                   {0.65f, 0.5f, 0.15f}};

/* A plinth, and what stands on it. */
static void add_exhibit(struct aob_mesh *mesh, double x, double z, int number)
{
    const float *c = colours[number % 5];
    const double top = 1.05;
    aob_mesh_paint(mesh, paint(0.75f, 0.75f, 0.72f, 0.6f));
    aob_interior_add_block(mesh, aob_vec(x, 0, z), aob_vec(0.56, 0.1, 0.56), 0);
    aob_interior_add_block(mesh, aob_vec(x, 0.1, z), aob_vec(0.46, top - 0.1, 0.46), 0);
    aob_mesh_paint(mesh, paint(c[0], c[1], c[2], 0.2f + 0.1f * (float)(number % 5)));
    if (number % 3 == 0)
        aob_mesh_add_sphere(mesh, aob_vec(x, top + 0.21, z), 0.21, 64);
    else if (number % 3 == 1)
        aob_interior_add_block(mesh, aob_vec(x, top, z), aob_vec(0.3, 0.38, 0.26), 15.0 + 20 * number);
    else
        aob_mesh_add_lathe(mesh, aob_vec(x, top, z), aob_vec(0, 1, 0), vase, AOB_COUNT(vase), 48);
}

/* A frame on the left wall (side -1) or the right one (1) about z. Its picture is 3 cm before the wall, half as far as
 * the rim. */
static void add_picture(struct aob_mesh *mesh, double side, double z, int number)
{
    static const double signs[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    struct aob_vec3 outer[4], inner[4];
    double wall = 3 * side, rim = 0.08, y = 1.75, half_y = 0.45 + 0.1 * (number % 3);
    double half_z = 0.75 - 0.15 * (number % 4 / 2);
    const float *paints = colours[(number * 3 + 1) % 5];
    for (int i = 0; i < 4; i++) {
        double up = signs[i][0], along = -side * signs[i][1];
        outer[i] = aob_vec(wall, y + up * half_y, z + along * half_z);
        inner[i] = aob_vec(wall, y + up * (half_y - rim), z + along * (half_z - rim));
    }
    aob_mesh_paint(mesh, paint(0.12f, 0.08f, 0.05f, 0.4f));
    aob_mesh_add_band(mesh, outer, inner, 4, aob_vec(-0.06 * side, 0, 0), true);
    aob_mesh_paint(mesh, paint(paints[0], paints[1], paints[2], 0.5f));
    double back = wall - 0.01 * side, front = wall - 0.03 * side;
    aob_mesh_add_box(mesh, aob_vec(fmin(back, front), y - half_y + rim / 2, z - half_z + rim / 2),
                     aob_vec(fmax(back, front), y + half_y - rim / 2, z + half_z - rim / 2), 0);
}

static void add_hall(struct aob_mesh *mesh)
{
    const struct aob_interior hall = {{-3, 0, -9}, {3, 4, 9}}, skylight = {{-0.9, 3, -8}, {0.9, 5, 8}};
    aob_mesh_paint(mesh, paint(0.4f, 0.4f, 0.4f, 0.3f));
    aob_interior_add_wall(mesh, &hall, AOB_WALL_FLOOR);
    aob_mesh_paint(mesh, paint(0.8f, 0.79f, 0.76f, 0.9f));
    for (int wall = AOB_WALL_BACK; wall < AOB_WALL_COUNT; wall++)
        aob_interior_add_wall(mesh, &hall, (enum aob_wall)wall);
    aob_interior_add_opening(mesh, &hall, AOB_WALL_CEILING, &skylight, 0.4);
}

static void build_gallery(struct aob_mesh *mesh)
{
    const struct aob_material metal = {
        .base_colour = {0.95f, 0.93f, 0.88f}, .roughness = 0.2f, .metalness = 1};
    add_hall(mesh);
    for (int i = 0; i < 10; i++)
        add_exhibit(mesh, i % 2 ? 1.9 : -1.9, 6.4 - 3.2 * (i / 2), i);
    for (int i = 0; i < 8; i++)
        add_picture(mesh, i % 2 ? 1 : -1, 4.8 - 3.2 * (i / 2), i);
    aob_mesh_paint(mesh, paint(0.75f, 0.75f, 0.72f, 0.6f));
    aob_interior_add_block(mesh, aob_vec(0, 0, 1.6), aob_vec(0.9, 0.5, 0.9), 0);
    aob_mesh_paint(mesh, metal);
    aob_mesh_add_sphere(mesh, aob_vec(0, 0.95, 1.6), 0.45, 96);
    aob_mesh_paint(mesh, paint(0.3f, 0.18f, 0.1f, 0.35f));
    aob_interior_add_table(mesh, aob_vec(-0.4, 0, -3.4), aob_vec(0.4, 0.46, -1.4), 0);
}

static const struct aob_view gallery_views[] = {
    AOB_VIEW("hall", 1, 1.65, 7.6, -0.5, 1.15, -2, 60),
    AOB_VIEW("ball", -1.2, 1.5, 3.6, 0.25, 0.8, 1.2, 50),
};
const struct aob_scene_info aob_scene_gallery = {
    .name = "gallery",
    .title = "Hall x -3..3, y 0..4, z -9..9 m under an open skylight of 1.8 x 16 m, 28,790 triangles: floor "
             "of base "
             "colour 0.4 and roughness 0.3, ten plinths with balls, blocks and vases of roughness 0.2 to "
             "0.6, a ball of "
             "radius 0.45 and metalness 1, a bench and eight framed pictures",
    .metres_per_unit = 1,
    .metre = 1,
    .light = "sky",
    .views = gallery_views,
    .view_count = AOB_COUNT(gallery_views),
    .build = build_gallery,
};
