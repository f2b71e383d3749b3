#include "base/memory.h"
#include "mesh_solids.h"
#include "scene_random.h"
#include "scene_table.h"

/* A bush is stems that fork twice: each stem has branches, each branch has twigs, each twig has leaves. */
enum { BUSHES = 20, STEMS = 3, BRANCHES = 3, TWIGS = 3, LEAVES = 9, SIDES = 5 };

struct stick {
    struct aob_vec3 from, along; /* along: to the other end */
    double radius;
};

/* A stick tapers to 0.6 of its radius. */
static void add_stick(struct aob_mesh *mesh, const struct stick *stick)
{
    double length = aob_vec_length(stick->along);
    const struct aob_turning profile[] = {
        {0, 0}, {stick->radius, 0}, {0.6 * stick->radius, length}, {0, length}};
    aob_mesh_add_lathe(mesh, stick->from, stick->along, profile, AOB_COUNT(profile), SIDES);
}

static struct aob_vec3 point_on(const struct stick *stick, double share)
{
    return aob_vec_add(stick->from, aob_vec_scale(stick->along, share));
}

/* A stick from somewhere on another: it leans away from it to any side, and a little up. */
static struct stick fork_from(const struct stick *stick, uint32_t *sequence, double shorter)
{
    double turn = 2 * M_PI * aob_scene_draw(sequence), length = aob_vec_length(stick->along);
    struct aob_vec3 along = aob_vec_scale(stick->along, 1 / length);
    struct aob_vec3 side = aob_vec(cos(turn), 0.25 + 0.5 * aob_scene_draw(sequence), sin(turn));
    struct aob_vec3 lean = aob_vec_normalize(aob_vec_add(aob_vec_scale(along, 0.5), side));
    double share = 0.35 + 0.6 * aob_scene_draw(sequence);
    length *= shorter * (0.7 + 0.5 * aob_scene_draw(sequence));
    return (struct stick){point_on(stick, share), aob_vec_scale(lean, length), 0.5 * stick->radius};
}

/* A leaf is a flat solid of eight triangles: a rhombus, raised and lowered in its middle. */
static void add_leaf(struct aob_mesh *mesh, struct aob_vec3 at, struct aob_vec3 along, uint32_t *sequence)
{
    double length = 0.09 + 0.07 * aob_scene_draw(sequence), turn = 2 * M_PI * aob_scene_draw(sequence);
    struct aob_vec3 out = aob_vec(cos(turn), 1.2 * aob_scene_draw(sequence) - 0.5, sin(turn));
    out = aob_vec_normalize(aob_vec_add(aob_vec_scale(aob_vec_normalize(along), 0.4), out));
    struct aob_vec3 side = aob_vec_normalize(aob_vec_cross(out, aob_vec(0.3, 1, 0.2)));
    struct aob_vec3 lift = aob_vec_scale(aob_vec_cross(out, side), 0.03 * length);
    struct aob_vec3 middle = aob_vec_add(at, aob_vec_scale(out, 0.45 * length));
    side = aob_vec_scale(side, 0.3 * length);
    const uint32_t rim[4] = {aob_mesh_add_vertex(mesh, at),
                             aob_mesh_add_vertex(mesh, aob_vec_sub(middle, side)),
                             aob_mesh_add_vertex(mesh, aob_vec_add(at, aob_vec_scale(out, length))),
                             aob_mesh_add_vertex(mesh, aob_vec_add(middle, side))};
    uint32_t upper = aob_mesh_add_vertex(mesh, aob_vec_add(middle, lift));
    uint32_t lower = aob_mesh_add_vertex(mesh, aob_vec_sub(middle, lift));
    for (int i = 0; i < 4; i++) {
        aob_mesh_add_triangle(mesh, rim[i], rim[(i + 1) % 4], upper);
        aob_mesh_add_triangle(mesh, rim[(i + 1) % 4], rim[i], lower);
    }
}

static void add_twig(struct aob_mesh *mesh, const struct stick *branch, uint32_t *sequence)
{
    const struct aob_material bark = {.base_colour = {0.22f, 0.14f, 0.08f}, .roughness = 1};
    const struct aob_material green = {.base_colour = {0.16f, 0.32f, 0.06f}, .roughness = 0.7f};
    const struct aob_material yellow = {.base_colour = {0.34f, 0.36f, 0.08f}, .roughness = 0.7f};
    struct stick twig = fork_from(branch, sequence, 0.6);
    aob_mesh_paint(mesh, bark);
    add_stick(mesh, &twig);
    aob_mesh_paint(mesh, aob_scene_draw(sequence) < 0.7 ? green : yellow);
    for (int i = 0; i < LEAVES; i++)
        add_leaf(mesh, point_on(&twig, 0.2 + 0.78 * i / (LEAVES - 1)), twig.along, sequence);
}

static void add_stem(struct aob_mesh *mesh, double x, double z, uint32_t *sequence)
{
    const struct aob_material bark = {.base_colour = {0.26f, 0.18f, 0.11f}, .roughness = 1};
    double turn = 2 * M_PI * aob_scene_draw(sequence), lean = 0.15 + 0.55 * aob_scene_draw(sequence);
    struct stick stem = {.from = aob_vec(x + 0.12 * cos(turn), -0.05, z + 0.12 * sin(turn))};
    stem.along = aob_vec(lean * cos(turn), 1, lean * sin(turn));
    stem.along = aob_vec_scale(stem.along, 0.9 + 0.7 * aob_scene_draw(sequence));
    stem.radius = 0.013 + 0.012 * aob_scene_draw(sequence);
    aob_mesh_paint(mesh, bark);
    add_stick(mesh, &stem);
    for (int i = 0; i < BRANCHES; i++) {
        struct stick branch = fork_from(&stem, sequence, 0.6);
        aob_mesh_paint(mesh, bark);
        add_stick(mesh, &branch);
        for (int k = 0; k < TWIGS; k++)
            add_twig(mesh, &branch, sequence);
    }
}

static void build_thicket(struct aob_mesh *mesh)
{
    uint32_t sequence = 11;
    aob_mesh_paint(mesh, (struct aob_material){.base_colour = {0.2f, 0.15f, 0.1f}, .roughness = 1});
    aob_mesh_add_quad(mesh, aob_vec(-10, 0, -10), aob_vec(0, 0, 20), aob_vec(20, 0, 0));
    for (int i = 0; i < BUSHES; i++) { /* on a grid that the hash shakes, clear of the camera */
        double x = -2.2 + 0.8 * (i % 6) + 0.5 * aob_scene_draw(&sequence);
        double z = -2.6 + 0.9 * (i / 6) + 0.5 * aob_scene_draw(&sequence);
        for (int k = 0; k < STEMS; k++)
            add_stem(mesh, x, z, &sequence);
    }
}

static const struct aob_view thicket_views[] = {
    AOB_VIEW("edge", 0.4, 1.35, 3.2, 0, 0.75, -0.4, 50),
    AOB_VIEW("low", 0.7, 0.7, 1.7, -0.3, 0.6, -0.6, 50),
};
const struct aob_scene_info aob_scene_thicket = {
    .name = "thicket",
    .title =
        "20 bushes of crossed sticks and leaves on 4.5 x 3.2 m of a floor x, z -10..10 m, 54,482 triangles: "
        "780 sticks of 3 to 25 mm radius, base colour 0.26 0.18 0.11 and 0.22 0.14 0.08, roughness 1, and "
        "4,860 leaves 90 to 160 mm long, 0.16 0.32 0.06 or 0.34 0.36 0.08, roughness 0.7, all closed solids",
    .metres_per_unit = 1,
    .metre = 1,
    .light = "sky",
    .views = thicket_views,
    .view_count = AOB_COUNT(thicket_views),
    .build = build_thicket,
};
