#include "scene_table.h"
#include <string.h>
#include "base/memory.h"

static void add_floor(struct aob_mesh *mesh)
{
    aob_mesh_add_quad(mesh, aob_vec(-20, 0, -20), aob_vec(0, 0, 40), aob_vec(40, 0, 0));
}

static void build_plane(struct aob_mesh *mesh)
{
    add_floor(mesh);
}

static const struct aob_view plane_views[] = {
    AOB_VIEW("front", 0, 2, 4, 0, 0, 0, 60),
    AOB_VIEW("low", 0, 0.3, 6, 0, 0, 0, 60),
    AOB_VIEW("top", 0, 5, 0, 0, 0, 0, 60),
};
static const struct aob_scene_info plane = {
    .name = "plane",
    .title = "Flat floor y = 0, 40 x 40 m about the origin: visibility is 1 everywhere",
    .metres_per_unit = 1,
    .metre = 1,
    .views = plane_views,
    .view_count = AOB_COUNT(plane_views),
    .build = build_plane,
};

static void build_corner(struct aob_mesh *mesh)
{
    aob_mesh_add_quad(mesh, aob_vec(-20, 0, 0), aob_vec(0, 0, 40), aob_vec(40, 0, 0));
    aob_mesh_add_quad(mesh, aob_vec(-20, 0, 0), aob_vec(40, 0, 0), aob_vec(0, 40, 0));
}

static const struct aob_view corner_views[] = {
    AOB_VIEW("front", 0, 2, 4, 0, 0.8, 0, 60),
    AOB_VIEW("far", 3, 4, 8, 0, 1, 0, 45),
};
static const struct aob_scene_info corner = {
    .name = "corner",
    .title =
        "Floor y = 0 (z 0..40) and wall z = 0 (y 0..40), x -20..20 m, meeting at 90 degrees: visibility in "
        "closed form",
    .metres_per_unit = 1,
    .metre = 1,
    .views = corner_views,
    .view_count = AOB_COUNT(corner_views),
    .build = build_corner,
};

/* Two balls on the floor touch when their centres are 2 sqrt(r1 r2) apart along it. */
static void build_spheres(struct aob_mesh *mesh)
{
    add_floor(mesh);
    aob_mesh_add_sphere(mesh, aob_vec(0, 1, 0), 1, 96);
    aob_mesh_add_sphere(mesh, aob_vec(M_SQRT2, 0.5, 0), 0.5, 96);
    aob_mesh_add_sphere(mesh, aob_vec(-0.6, 0.25, 0.8), 0.25, 96);
    aob_mesh_add_sphere(mesh, aob_vec(0.5, 0.125, 1.5), 0.125, 96);
    aob_mesh_add_sphere(mesh, aob_vec(-1.5, 0.6, 0.6), 0.4, 96);
}

static const struct aob_view spheres_views[] = {
    AOB_VIEW("front", 0.5, 1.6, 4, 0, 0.6, 0, 50),
    AOB_VIEW("close", 0.9, 0.6, 2.6, 0.6, 0.3, 0.4, 45),
    AOB_VIEW("top", 0, 6, 0.01, 0, 0, 0, 50),
};
static const struct aob_scene_info spheres = {
    .name = "spheres",
    .title =
        "Floor y = 0, 40 x 40 m; spheres of radius 1 at (0, 1, 0), 0.5 at (1.41421, 0.5, 0), 0.25 at (-0.6, "
        "0.25, 0.8), all touching, 0.125 at (0.5, 0.125, 1.5) on the floor, 0.4 at (-1.5, 0.6, 0.6) above it",
    .metres_per_unit = 1,
    .metre = 1,
    .views = spheres_views,
    .view_count = AOB_COUNT(spheres_views),
    .build = build_spheres,
};

static void build_cornell(struct aob_mesh *mesh)
{
    struct aob_vec3 x = aob_vec(2, 0, 0), y = aob_vec(0, 2, 0), z = aob_vec(0, 0, 2);
    const struct aob_material white = {.base_colour = {0.725f, 0.71f, 0.68f}, .roughness = 1},
                              red = {.base_colour = {0.63f, 0.065f, 0.05f}, .roughness = 1},
                              green = {.base_colour = {0.14f, 0.45f, 0.091f}, .roughness = 1};
    aob_mesh_paint(mesh, white);
    aob_mesh_add_quad(mesh, aob_vec(-1, 0, -1), z, x); /* floor */
    aob_mesh_add_quad(mesh, aob_vec(-1, 2, -1), x, z); /* ceiling */
    aob_mesh_add_quad(mesh, aob_vec(-1, 0, -1), x, y); /* back */
    aob_mesh_paint(mesh, red);
    aob_mesh_add_quad(mesh, aob_vec(-1, 0, -1), y, z); /* left */
    aob_mesh_paint(mesh, green);
    aob_mesh_add_quad(mesh, aob_vec(1, 0, -1), z, y); /* right */
    aob_mesh_paint(mesh, white);
    aob_mesh_add_box(mesh, aob_vec(-0.65, 0, -0.6), aob_vec(-0.05, 1.2, 0), 18);
    aob_mesh_add_box(mesh, aob_vec(0.05, 0, 0), aob_vec(0.65, 0.6, 0.6), -17);
}

static const struct aob_view cornell_views[] = {
    AOB_VIEW("front", 0, 1, 3.4, 0, 1, 0, 45),
    AOB_VIEW("blocks", 0.4, 1.2, 1.6, 0, 0.4, -0.2, 60),
};
static const struct aob_scene_info cornell = {
    .name = "cornell",
    .title =
        "Room x -1..1, y 0..2, z -1..1 m, open at z = 1; blocks 0.6 x 1.2 x 0.6 about (-0.35, 0.6, -0.3) "
        "turned 18 degrees and 0.6 x 0.6 x 0.6 about (0.35, 0.3, 0.3) turned -17; base colour 0.725 0.71 "
        "0.68, "
        "left wall 0.63 0.065 0.05, right wall 0.14 0.45 0.091",
    .metres_per_unit = 1,
    .metre = 1,
    .views = cornell_views,
    .view_count = AOB_COUNT(cornell_views),
    .build = build_cornell,
};

static void build_plates(struct aob_mesh *mesh)
{
    aob_mesh_add_quad(mesh, aob_vec(-4, 0, -4), aob_vec(0, 0, 8), aob_vec(8, 0, 0));
    for (int i = 1; i <= 3; i++)
        aob_mesh_add_box(mesh, aob_vec(-1, 0.3 * i, -1), aob_vec(1, 0.3 * i + 0.01, 1), 0);
}

static const struct aob_view plates_views[] = {
    AOB_VIEW("front", 3, 1.6, 4, 0, 0.4, 0, 40),
    AOB_VIEW("between", 1.7, 0.75, 2, 0.6, 0.5, 0.6, 45),
};
static const struct aob_scene_info plates = {
    .name = "plates",
    .title =
        "Floor y = 0, 8 x 8 m about the origin; plates of 2 x 2 m, 0.01 m thick, from y = 0.3, 0.6 and 0.9: "
        "thin solids that stack",
    .metres_per_unit = 1,
    .metre = 1,
    .views = plates_views,
    .view_count = AOB_COUNT(plates_views),
    .build = build_plates,
};

static const struct aob_view bunny_views[] = {
    AOB_VIEW("front", 0, 0.4, 3.3, 0, 0, 0, 45),
    AOB_VIEW("left", -3, 0.6, 1, 0, 0, 0, 45),
    AOB_VIEW("ears", 0.4, 1.4, 1.4, -0.4, 0.3, -0.1, 45),
};
static const struct aob_scene_info bunny = {
    .name = "bunny",
    .title =
        "Stanford bunny, 69,666 triangles, box 2 x 1.98 x 1.55 units about the origin (the clay model is "
        "0.156 m wide), without a floor",
    .metres_per_unit = 0.078,
    .metre = 1,
    .views = bunny_views,
    .view_count = AOB_COUNT(bunny_views),
    .file = "/usr/share/glmark2/models/bunny.obj",
    .package = "glmark2-data",
    .licence = "GPL-3+ as the package states",
    .sha256 = "bff773d28c62e80187b2dfa8c6c8cc771a4c7707ddcdcf2e515913d322d1f548",
};

static const struct aob_view horse_views[] = {
    AOB_VIEW("right", 0, 2.6, 0.3, 0, 0, 0, 45),
    AOB_VIEW("left", 0, -2.6, -0.3, 0, 0, 0, 45),
    AOB_VIEW("head", 0.1, 1.3, -0.25, 0.02, 0, -0.6, 40),
};
static const struct aob_scene_info horse = {
    .name = "horse",
    .title =
        "Rearing horse, 7,172 triangles, box 1.25 x 0.77 x 1.70 units about the origin, upright along -Z",
    .metres_per_unit = 1.4,
    .metre = 0.62,
    .views = horse_views,
    .view_count = AOB_COUNT(horse_views),
    .file = "/usr/share/glmark2/models/horse.3ds",
    .package = "glmark2-data",
    .licence = "GPL-3+ as the package states",
    .sha256 = "1c241dbf9188b5c673cb6d1887492e305d53eba5ccf194e90314d8deb9d0a111",
};

static const struct aob_view engine_views[] = {
    AOB_VIEW("front", 0, 160, 640, 0, -35, 0, 50),
    AOB_VIEW("corner", 420, 200, 420, 40, -40, 0, 50),
    AOB_VIEW("fins", 250, 60, 290, 170, -10, 0, 50),
};
static const struct aob_scene_info engine = {
    .name = "engine",
    .title = "Two-cylinder engine, 110,336 triangles, box 743 x 273 x 268 units (millimetres by its size)",
    .metres_per_unit = 0.001,
    .metre = 137,
    .views = engine_views,
    .view_count = AOB_COUNT(engine_views),
    .file = "/usr/share/assimp/models/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
    .package = "assimp-testmodels",
    .licence = "BSD-3-Clause as the package states",
    .sha256 = "bb5fbccc73a3f68c52f26687fbb25b4a1248ab5f8a115ec55e7ac6a4451c47ee",
};

static const struct aob_view cornell_box_views[] = {
    AOB_VIEW("front", 278, 273, -800, 278, 273, 0, 39),
    AOB_VIEW("blocks", 380, 330, -120, 250, 110, 300, 60),
};
static const struct aob_scene_info cornell_box = {
    .name = "cornell_box",
    .title = "The measured Cornell box, 34 triangles, room 556 x 549 x 559 mm, open at z = 0",
    .metres_per_unit = 0.001,
    .metre = 278,
    .views = cornell_box_views,
    .view_count = AOB_COUNT(cornell_box_views),
    .file = "/usr/share/doc/embree3/models/cornell_box.obj",
    .package = "embree-tools",
    .licence = "Apache-2.0 as the package states",
    .sha256 = "1df799353b985e1862a590c6c37814227990e0338220e2e9a575fcd54031a667",
};

const struct aob_scene_info *const aob_scenes[] = {&plane,
                                                   &corner,
                                                   &spheres,
                                                   &cornell,
                                                   &plates,
                                                   &aob_scene_atrium,
                                                   &aob_scene_machine,
                                                   &aob_scene_grass,
                                                   &aob_scene_wall,
                                                   &aob_scene_sheet,
                                                   &aob_scene_sphere,
                                                   &aob_scene_room,
                                                   &aob_scene_disc,
                                                   &aob_scene_matte_white_room,
                                                   &aob_scene_matte_dark_room,
                                                   &aob_scene_gallery,
                                                   &aob_scene_coloured_walls,
                                                   &aob_scene_window_room,
                                                   &aob_scene_rocks,
                                                   &aob_scene_scattered_rocks,
                                                   &aob_scene_thicket,
                                                   &aob_scene_open_sky,
                                                   &aob_scene_passing_box,
                                                   &bunny,
                                                   &horse,
                                                   &engine,
                                                   &cornell_box,
                                                   NULL};

const struct aob_scene_info *aob_scene_find(const char *name)
{
    for (const struct aob_scene_info *const *scene = aob_scenes; *scene; scene++)
        if (!strcmp((*scene)->name, name))
            return *scene;
    return NULL;
}

const struct aob_view *aob_scene_view(const struct aob_scene_info *scene, const char *name)
{
    for (size_t i = 0; i < scene->view_count; i++)
        if (!name || !strcmp(scene->views[i].name, name))
            return &scene->views[i];
    return NULL;
}

struct aob_camera aob_scene_framing(struct aob_vec3 low, struct aob_vec3 high)
{
    const double fov_deg = 60;
    struct aob_vec3 centre = aob_vec_scale(aob_vec_add(low, high), 0.5);
    double radius = aob_vec_length(aob_vec_sub(high, low)) / 2;
    if (!(radius > 0))
        radius = 1;
    struct aob_vec3 out = aob_vec_normalize(aob_vec(0.35, 0.4, 1));
    double distance = radius / sin(fov_deg * (M_PI / 360));
    return (struct aob_camera){
        .eye = aob_vec_add(centre, aob_vec_scale(out, distance)), .target = centre, .fov_deg = fov_deg};
}
