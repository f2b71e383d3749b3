#include "scene_table.h"
#include "base/memory.h"
#include "scene_random.h"

enum { CLUMPS = 640, CLUMP_BLADES = 46, ROCK_SEGMENTS = 48 };
static const double half_field = 2.5;

static const struct rock {
    struct aob_vec3 centre, size; /* half axes */
} rocks[] = {
    {{-0.7, 0.12, 0.3}, {0.5, 0.36, 0.42}},  {{0.25, 0.06, 1.1}, {0.24, 0.17, 0.28}},
    {{1.2, 0.18, -0.6}, {0.62, 0.44, 0.5}},  {{0.85, 0.04, 0.7}, {0.14, 0.12, 0.17}},
    {{-1.6, 0.08, 1.5}, {0.33, 0.22, 0.26}}, {{-0.3, 0.1, -1.4}, {0.4, 0.3, 0.36}},
    {{1.9, 0.05, 1.4}, {0.22, 0.16, 0.3}},   {{-0.1, 0.02, 0.75}, {0.09, 0.07, 0.1}},
};

/* Low waves on a sphere keep it smooth and free of folds. */
static void add_rock(struct aob_mesh *mesh, const struct rock *rock, int number)
{
    size_t first = mesh->vertex_count;
    aob_mesh_add_sphere(mesh, aob_vec(0, 0, 0), 1, ROCK_SEGMENTS);
    for (size_t i = first; i < mesh->vertex_count; i++) {
        struct aob_vec3 *p = &mesh->positions[i];
        double swell = 1 + 0.09 * sin(3.1 * p->x + 1.7 * number) * cos(2.3 * p->y + p->z) +
                       0.05 * sin(5.3 * p->z + 4.1 * p->y + number) + 0.025 * sin(9 * p->x - 7 * p->y);
        *p = aob_vec_add(rock->centre, aob_vec(p->x * rock->size.x * swell, p->y * rock->size.y * swell,
                                               p->z * rock->size.z * swell));
    }
}

/* Whether a clump there would stand on a rock. */
static bool on_rock(double x, double z)
{
    for (size_t i = 0; i < AOB_COUNT(rocks); i++) {
        double dx = (x - rocks[i].centre.x) / (rocks[i].size.x + 0.02);
        double dz = (z - rocks[i].centre.z) / (rocks[i].size.z + 0.02);
        if (dx * dx + dz * dz < 1)
            return true;
    }
    return false;
}

struct blade {
    double x, z, height, width;
    struct aob_vec3 lean; /* level: how far the tip hangs over */
};

/* A blade is three triangles without thickness: an upright foot, and a tip that bends over by the lean. */
static void add_blade(struct aob_mesh *mesh, const struct blade *blade)
{
    struct aob_vec3 over = aob_vec_normalize(blade->lean);
    struct aob_vec3 side = aob_vec_scale(aob_vec(over.z, 0, -over.x), blade->width / 2);
    struct aob_vec3 foot = aob_vec(blade->x, 0, blade->z);
    struct aob_vec3 knee = aob_vec_add(foot, aob_vec_scale(blade->lean, 0.3));
    struct aob_vec3 tip = aob_vec_add(foot, blade->lean), slim = aob_vec_scale(side, 0.75);
    knee.y = blade->height * 0.6;
    tip.y = blade->height;
    uint32_t a = aob_mesh_add_vertex(mesh, aob_vec_sub(foot, side));
    uint32_t b = aob_mesh_add_vertex(mesh, aob_vec_add(foot, side));
    uint32_t c = aob_mesh_add_vertex(mesh, aob_vec_add(knee, slim));
    uint32_t d = aob_mesh_add_vertex(mesh, aob_vec_sub(knee, slim));
    aob_mesh_add_triangle(mesh, a, b, c);
    aob_mesh_add_triangle(mesh, a, c, d);
    aob_mesh_add_triangle(mesh, d, c, aob_mesh_add_vertex(mesh, tip));
}

/* Blades stand within `spread` of the middle and lean away from it. */
static void add_clump(struct aob_mesh *mesh, double x, double z, uint32_t *sequence)
{
    double tall = 0.16 + 0.22 * aob_scene_draw(sequence), spread = 0.05 + 0.1 * aob_scene_draw(sequence);
    for (int i = 0; i < CLUMP_BLADES; i++) {
        double turn = 2 * M_PI * aob_scene_draw(sequence), away = spread * sqrt(aob_scene_draw(sequence));
        struct blade blade = {.x = x + away * cos(turn), .z = z + away * sin(turn)};
        blade.height = tall * (0.55 + 0.45 * aob_scene_draw(sequence));
        blade.width = 0.004 + 0.006 * aob_scene_draw(sequence);
        turn += 1.6 * (aob_scene_draw(sequence) - 0.5);
        double lean = blade.height * (0.08 + 0.5 * aob_scene_draw(sequence));
        blade.lean = aob_vec(lean * cos(turn), 0, lean * sin(turn));
        if (!on_rock(blade.x, blade.z))
            add_blade(mesh, &blade);
    }
}

static void build_grass(struct aob_mesh *mesh)
{
    aob_mesh_add_quad(mesh, aob_vec(-10, 0, -10), aob_vec(0, 0, 20), aob_vec(20, 0, 0));
    for (size_t i = 0; i < AOB_COUNT(rocks); i++)
        add_rock(mesh, &rocks[i], (int)i);
    for (uint32_t i = 0; i < CLUMPS; i++) {
        uint32_t sequence = i;
        double x = half_field * (2 * aob_scene_draw(&sequence) - 1),
               z = half_field * (2 * aob_scene_draw(&sequence) - 1);
        add_clump(mesh, x, z, &sequence);
    }
}

static const struct aob_view grass_views[] = {
    AOB_VIEW("field", 0.3, 1, 3.3, 0, 0.1, 0, 50),
    AOB_VIEW("low", 0.4, 0.3, 2.75, 0.1, 0.18, 0, 45),
    AOB_VIEW("rocks", -0.4, 0.75, 1.9, -0.2, 0.15, 0.5, 45),
    AOB_VIEW("top", 0, 4, 0.01, 0, 0, 0, 50),
};
const struct aob_scene_info aob_scene_grass = {
    .name = "grass",
    .title = "Grass on 5 x 5 m of a floor x, z -10..10 m, 95,705 triangles: 26,013 blades of three triangles "
             "without thickness, 4 to 10 mm wide and 0.09 to 0.38 m tall, in 640 clumps among 8 rounded "
             "rocks up to 1.3 m wide",
    .metres_per_unit = 1,
    .metre = 1,
    .views = grass_views,
    .view_count = AOB_COUNT(grass_views),
    .build = build_grass,
};
