#include "base/memory.h"
#include "scene_random.h"
#include "scene_table.h"

static const double half_plain = 150;

static void add_plain(struct aob_mesh *mesh)
{
    aob_mesh_add_quad(mesh, aob_vec(-half_plain, 0, -half_plain), aob_vec(0, 0, 2 * half_plain),
                      aob_vec(2 * half_plain, 0, 0));
}

/* --- Rocks on a plain. --- */

enum { ROCKS = 160, SEGMENTS = 11 };

struct rock {
    double x, z, radius;
};

static struct aob_vec3 draw_direction(uint32_t *sequence)
{
    double y = 2 * aob_scene_draw(sequence) - 1, turn = 2 * M_PI * aob_scene_draw(sequence);
    double across = sqrt(1 - y * y);
    return aob_vec(across * cos(turn), y, across * sin(turn));
}

/* A coarse ball whose poles point anywhere and whose corners are moved in and out, and a little along. */
static void add_rock(struct aob_mesh *mesh, const struct rock *rock, uint32_t sequence)
{
    struct aob_vec3 up = draw_direction(&sequence);
    struct aob_vec3 u = aob_vec_normalize(aob_vec_cross(up, aob_vec(0.3, 0.5, 0.8))),
                    v = aob_vec_cross(u, up);
    double wide = 0.8 + 0.3 * aob_scene_draw(&sequence), tall = 0.5 + 0.35 * aob_scene_draw(&sequence);
    double sunk = 0.25 + 0.3 * aob_scene_draw(&sequence), turn = 2 * M_PI * aob_scene_draw(&sequence);
    size_t first = mesh->vertex_count;
    aob_mesh_add_sphere(mesh, aob_vec(0, 0, 0), 1, SEGMENTS);
    for (size_t i = first; i < mesh->vertex_count; i++) {
        struct aob_vec3 *p = &mesh->positions[i];
        struct aob_vec3 q =
            aob_vec_add(aob_vec_add(aob_vec_scale(u, p->x), aob_vec_scale(v, p->z)), aob_vec_scale(up, p->y));
        q = aob_vec_normalize(aob_vec_add(q, aob_vec_scale(draw_direction(&sequence), 0.1)));
        q = aob_vec_scale(q, rock->radius * (0.86 + 0.14 * aob_scene_draw(&sequence)));
        q = aob_vec(q.x * wide, (q.y + sunk * rock->radius) * tall, q.z);
        *p = aob_vec(rock->x + q.x * cos(turn) + q.z * sin(turn), q.y,
                     rock->z + q.z * cos(turn) - q.x * sin(turn));
    }
}

/* Where rocks lie: within `reach` of the middle, the denser there the higher the exponent, and not about a camera at z. */
struct ground {
    double reach, exponent, camera_z;
    uint32_t sequence;
};

/* Whether the rock keeps clear of the others and of where the cameras stand. */
static bool is_clear(const struct ground *ground, const struct rock *rock, const struct rock *others,
                     int count)
{
    if (hypot(rock->x, rock->z - ground->camera_z) < 1.2 + rock->radius)
        return false;
    for (int i = 0; i < count; i++)
        if (hypot(rock->x - others[i].x, rock->z - others[i].z) < 0.85 * (rock->radius + others[i].radius))
            return false;
    return true;
}

/* Most are small. */
static void build_ground(const struct ground *ground, struct aob_mesh *mesh)
{
    struct rock rocks[ROCKS];
    uint32_t sequence = ground->sequence;
    aob_mesh_paint(mesh, (struct aob_material){.base_colour = {0.35f, 0.33f, 0.3f}, .roughness = 1});
    add_plain(mesh);
    for (int count = 0; count < ROCKS;) {
        double small = aob_scene_draw(&sequence),
               away = ground->reach * pow(aob_scene_draw(&sequence), ground->exponent);
        double turn = 2 * M_PI * aob_scene_draw(&sequence);
        rocks[count] = (struct rock){away * cos(turn), away * sin(turn), 0.12 + 0.9 * small * small * small};
        if (is_clear(ground, &rocks[count], rocks, count)) {
            add_rock(mesh, &rocks[count], 1000 + (uint32_t)count);
            count++;
        }
    }
}

static void build_rocks(struct aob_mesh *mesh)
{
    build_ground(&(struct ground){13, 0.7, 9, 7}, mesh);
}

static void build_scattered_rocks(struct aob_mesh *mesh)
{
    build_ground(&(struct ground){60, 0.5, 0, 11}, mesh);
}

static const struct aob_view rocks_views[] = {
    AOB_VIEW("low", 0, 0.9, 9, -0.3, 0.72, 0, 50),
    AOB_VIEW("down", 0, 3.2, 9, -0.2, 0, 3, 50),
};
const struct aob_scene_info aob_scene_rocks = {
    .name = "rocks",
    .title = "Plain of 300 x 300 m with 160 rocks of 88 faces, 0.12 to 1.02 m in radius, within 13 m of its "
             "middle, "
             "14,082 "
             "triangles, of base colour 0.35 0.33 0.3 and roughness 1",
    .metres_per_unit = 1,
    .metre = 1,
    .light = "sky",
    .views = rocks_views,
    .view_count = AOB_COUNT(rocks_views),
    .build = build_rocks,
};

static const struct aob_view scattered_rocks_views[] = {
    AOB_VIEW("down", 0, 5, 0, 0, 0, -9, 50),
    AOB_VIEW("low", 0, 1.6, 0, 0, 1.2, -10, 60),
};
const struct aob_scene_info aob_scene_scattered_rocks = {
    .name = "scattered_rocks",
    .title = "Plain of 300 x 300 m with 160 rocks of 88 faces, 0.12 to 1.02 m in radius, within 60 m of its "
             "middle, 14,082 triangles, of base colour 0.35 0.33 0.3 and roughness 1: most of it is open",
    .metres_per_unit = 1,
    .metre = 1,
    .light = "sky",
    .views = scattered_rocks_views,
    .view_count = AOB_COUNT(scattered_rocks_views),
    .build = build_scattered_rocks,
};

/* --- A plain below much sky. --- */

static void build_open_sky(struct aob_mesh *mesh)
{
    aob_mesh_paint(mesh, (struct aob_material){.base_colour = {0.3f, 0.27f, 0.2f}, .roughness = 1});
    add_plain(mesh);
}

static const struct aob_view open_sky_views[] = {
    AOB_VIEW("up", 0, 1.6, 0, 0, 6.2, -10, 60),
    AOB_VIEW("level", 0, 1.6, 0, 0, 1.4, -10, 60),
};
const struct aob_scene_info aob_scene_open_sky = {
    .name = "open_sky",
    .title = "Plain of 300 x 300 m, 2 triangles, of base colour 0.3 0.27 0.2 and roughness 1, below a sky "
             "that fills "
             "nine tenths of the view",
    .metres_per_unit = 1,
    .metre = 1,
    .light = "sky",
    .views = open_sky_views,
    .view_count = AOB_COUNT(open_sky_views),
    .build = build_open_sky,
};
