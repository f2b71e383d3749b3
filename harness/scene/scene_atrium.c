#include "scene_table.h"
#include "base/memory.h"
#include "mesh_solids.h"

/* Columns stand at x = +-6.5, z = -16, -12 .. 16; `side` is -1 for the left half of the hall and 1 for the right. */
enum { BAYS = 10, ARCH_STEPS = 20, BAY_POINTS = ARCH_STEPS + 2 };
static const double springing = 4.4, crown = 6.5;

static void add_box(struct aob_mesh *mesh, double side, struct aob_vec3 low, struct aob_vec3 high)
{
    struct aob_vec3 a = aob_vec(side > 0 ? low.x : -high.x, low.y, low.z);
    struct aob_vec3 b = aob_vec(side > 0 ? high.x : -low.x, high.y, high.z);
    aob_mesh_add_box(mesh, a, b, 0);
}

static void add_shell(struct aob_mesh *mesh)
{
    struct aob_vec3 x = aob_vec(20, 0, 0), y = aob_vec(0, 8, 0), z = aob_vec(0, 0, 42);
    aob_mesh_add_quad(mesh, aob_vec(-10, 0, -21), z, x); /* floor */
    aob_mesh_add_quad(mesh, aob_vec(-10, 0, -21), x, y);
    aob_mesh_add_quad(mesh, aob_vec(-10, 0, -21), y, z);
    aob_mesh_add_quad(mesh, aob_vec(10, 0, -21), z, y);
    aob_mesh_add_quad(mesh, aob_vec(-10, 0, 21), y, x);
}

static void add_column(struct aob_mesh *mesh, double x, double z)
{
    static const struct aob_turning profile[] = {
        {0, 0.25},    {0.45, 0.25}, {0.48, 0.29}, {0.48, 0.34}, {0.44, 0.38}, {0.38, 0.41},
        {0.38, 0.45}, {0.41, 0.49}, {0.41, 0.53}, {0.36, 0.57}, {0.35, 0.65}, {0.345, 1.7},
        {0.31, 3.7},  {0.31, 3.8},  {0.35, 3.83}, {0.35, 3.87}, {0.31, 3.9},  {0.32, 4},
        {0.36, 4.1},  {0.43, 4.17}, {0.47, 4.2},  {0, 4.2},
    };
    aob_mesh_add_box(mesh, aob_vec(x - 0.5, 0, z - 0.5), aob_vec(x + 0.5, 0.25, z + 0.5), 0);
    aob_mesh_add_lathe(mesh, aob_vec(x, 0, z), aob_vec(0, 1, 0), profile, AOB_COUNT(profile), 24);
    aob_mesh_add_box(mesh, aob_vec(x - 0.5, 4.2, z - 0.5), aob_vec(x + 0.5, springing, z + 0.5), 0);
}

struct arch {
    struct aob_vec3 start, across; /* left foot; unit, to the right as seen against `along` */
    double width, radius, rise;    /* of a bay; of the opening in its middle; to the straight top above */
};

static void arch_points(const struct arch *arch, struct aob_vec3 *upper, struct aob_vec3 *lower)
{
    for (int i = 0; i < BAY_POINTS; i++) {
        double turn = M_PI * (i - 1) / (ARCH_STEPS - 1);
        double x = arch->width / 2 - arch->radius * cos(turn), y = arch->radius * sin(turn);
        if (i == 0 || i == BAY_POINTS - 1) {
            x = i ? arch->width : 0;
            y = 0;
        } else if (i == 1 || i == BAY_POINTS - 2)
            y = 0;
        struct aob_vec3 foot = aob_vec_add(arch->start, aob_vec_scale(arch->across, x));
        lower[i] = aob_vec_add(foot, aob_vec(0, y, 0));
        upper[i] = aob_vec_add(foot, aob_vec(0, arch->rise, 0));
    }
}

/* The line of a band runs with its outer side on the right: from the right foot to the left one. */
static void add_arch(struct aob_mesh *mesh, const struct arch *arch, struct aob_vec3 along)
{
    struct aob_vec3 upper[BAY_POINTS], lower[BAY_POINTS], outer[BAY_POINTS], inner[BAY_POINTS];
    arch_points(arch, upper, lower);
    for (int i = 0; i < BAY_POINTS; i++) {
        outer[i] = upper[BAY_POINTS - 1 - i];
        inner[i] = lower[BAY_POINTS - 1 - i];
    }
    aob_mesh_add_band(mesh, outer, inner, BAY_POINTS, along, false);
}

static void add_colonnade(struct aob_mesh *mesh, double side)
{
    for (int bay = 0; bay < BAYS; bay++) {
        double z = -20 + 4 * bay;
        struct arch arcade = {aob_vec(side * 6.5 - 0.4, springing, z + 4), aob_vec(0, 0, -1), 4, 1.5,
                              crown - springing};
        add_arch(mesh, &arcade, aob_vec(0.8, 0, 0));
        if (bay == 0)
            continue;
        add_column(mesh, side * 6.5, z);
        struct arch rib = {aob_vec(side > 0 ? 6.8 : -9.7, springing, z - 0.3), aob_vec(1, 0, 0), 2.9, 1.2,
                           crown - springing};
        add_arch(mesh, &rib, aob_vec(0, 0, 0.6));
        add_box(mesh, side, aob_vec(9.6, 0, z - 0.4), aob_vec(10, crown, z + 0.4)); /* pilaster */
    }
    for (int end = -1; end <= 1; end += 2) /* half piers at the end walls */
        add_box(mesh, side, aob_vec(6, 0, end > 0 ? 19.5 : -20), aob_vec(7, springing, end > 0 ? 20 : -19.5));
}

static void add_gallery(struct aob_mesh *mesh, double side)
{
    static const struct aob_turning baluster[] = {{0, 6.95},     {0.06, 6.95}, {0.06, 7},   {0.03, 7.05},
                                                  {0.065, 7.25}, {0.03, 7.6},  {0.05, 7.7}, {0, 7.7}};
    add_box(mesh, side, aob_vec(5.9, crown, -20), aob_vec(10, 6.9, 20));
    add_box(mesh, side, aob_vec(6, 6.9, -20), aob_vec(6.3, 6.95, 20));
    add_box(mesh, side, aob_vec(6, 7.7, -20), aob_vec(6.3, 7.85, 20));
    for (int i = 0; i < 99; i++)
        aob_mesh_add_lathe(mesh, aob_vec(side * 6.15, 0, -19.6 + 0.4 * i), aob_vec(0, 1, 0), baluster,
                           AOB_COUNT(baluster), 8);
}

/* An end wall 1 m thick with a niche under an arch, and three steps up into it. */
static void add_end(struct aob_mesh *mesh, double near)
{
    double low = near < 0 ? -21 : 20;
    struct arch arch = {aob_vec(-10, 3.5, low), aob_vec(1, 0, 0), 20, 2.5, 4.5};
    add_arch(mesh, &arch, aob_vec(0, 0, 1));
    for (int side = -1; side <= 1; side += 2)
        add_box(mesh, side, aob_vec(2.5, 0, low), aob_vec(10, 3.5, low + 1));
    for (int step = 0; step < 3; step++) {
        double rise = 0.16 * step, front = 20 - 0.35 * (3 - step);
        aob_mesh_add_box(mesh, aob_vec(-3.5, rise, near < 0 ? -21 : front),
                         aob_vec(3.5, rise + 0.16, near < 0 ? -front : 21), 0);
    }
}

static void build_atrium(struct aob_mesh *mesh)
{
    add_shell(mesh);
    for (int side = -1; side <= 1; side += 2) {
        add_colonnade(mesh, side);
        add_gallery(mesh, side);
        add_end(mesh, side);
    }
}

static const struct aob_view atrium_views[] = {
    AOB_VIEW("nave", 0.6, 1.7, 18.5, -0.2, 2.6, -20, 60),
    AOB_VIEW("aisle", 8.2, 1.7, 19, 7.9, 2, -20, 60),
    AOB_VIEW("gallery", -4.5, 6, 13, 5, 3.2, -6, 55),
    AOB_VIEW("column", 3.6, 1.2, 3.2, 6.6, 0.9, 0, 50),
};
const struct aob_scene_info aob_scene_atrium = {
    .name = "atrium",
    .title = "Hall x -10..10, y 0..8, z -21..21 m, open above its middle, 44,066 triangles: two rows of 9 "
             "columns, 4 m apart at x = -6.5 and 6.5, under round arches of radius 1.5; ribs and flat "
             "ceilings 6.5 m above the aisles, balustrades of 99 posts each, a niche under an arch of radius "
             "2.5 at each end",
    .metres_per_unit = 1,
    .metre = 1,
    .views = atrium_views,
    .view_count = AOB_COUNT(atrium_views),
    .build = build_atrium,
};
