#include "scene_table.h"
#include "base/memory.h"
#include "mesh_solids.h"

/* Gears lie in planes of constant z before the plate (front z = 0); two gears mesh if they have one module (pitch
 * diameter over teeth), and a tooth of one points where the other has a gap. */
enum { TOOTH_POINTS = 6, MAX_TEETH = 64 };

struct gear {
    double x, y, z, width; /* middle of the back face; thickness towards +z */
    double module;
    int teeth, spokes;
    double turn_deg; /* of the middle of the first tooth, from +x counter-clockwise */
    double bore;     /* radius of the hub */
};

static struct aob_vec3 polar(const struct gear *gear, double radius, double turn)
{
    return aob_vec(gear->x + radius * cos(turn), gear->y + radius * sin(turn), gear->z);
}

/* Adds root, pitch and tip of both flanks. A tooth is half a pitch thick at the pitch circle, less some play. */
static void tooth_rim(const struct gear *gear, double inner_radius, struct aob_vec3 *outer,
                      struct aob_vec3 *inner)
{
    static const struct {
        double share, height; /* of the pitch angle; of the module, from the pitch circle */
    } corners[TOOTH_POINTS] = {{-0.34, -1.25}, {-0.23, 0}, {-0.11, 1}, {0.11, 1}, {0.23, 0}, {0.34, -1.25}};
    double pitch = 2 * M_PI / gear->teeth, radius = gear->module * gear->teeth / 2;
    for (int tooth = 0; tooth < gear->teeth; tooth++)
        for (int k = 0; k < TOOTH_POINTS; k++) {
            double turn = gear->turn_deg * (M_PI / 180) + pitch * (tooth + corners[k].share);
            int at = tooth * TOOTH_POINTS + k;
            outer[at] = polar(gear, radius + gear->module * corners[k].height, turn);
            inner[at] = polar(gear, inner_radius, turn);
        }
}

static void add_spokes(struct aob_mesh *mesh, const struct gear *gear, double from, double to)
{
    for (int i = 0; i < gear->spokes; i++) {
        double turn = gear->turn_deg * (M_PI / 180) + 2 * M_PI * i / gear->spokes;
        struct aob_vec3 side = aob_vec(-sin(turn), cos(turn), 0), lift = aob_vec(0, 0, gear->width / 4);
        struct aob_vec3 root = aob_vec_scale(side, to * 0.09), end = aob_vec_scale(side, to * 0.06);
        struct aob_vec3 a = aob_vec_add(polar(gear, from, turn), lift);
        struct aob_vec3 b = aob_vec_add(polar(gear, to, turn), lift);
        const struct aob_vec3 outer[2] = {aob_vec_sub(a, root), aob_vec_sub(b, end)};
        const struct aob_vec3 inner[2] = {aob_vec_add(a, root), aob_vec_add(b, end)};
        aob_mesh_add_band(mesh, outer, inner, 2, aob_vec(0, 0, gear->width / 2), false);
    }
}

static void add_bolt(struct aob_mesh *mesh, struct aob_vec3 foot, struct aob_vec3 axis, double size)
{
    const struct aob_turning washer[] = {
        {0, -0.1 * size}, {1.3 * size, -0.1 * size}, {1.3 * size, 0.2 * size}, {0, 0.2 * size}};
    const struct aob_turning head[] = {
        {0, 0.1 * size}, {size, 0.1 * size}, {size, 0.9 * size}, {0.85 * size, size}, {0, size}};
    aob_mesh_add_lathe(mesh, foot, axis, washer, AOB_COUNT(washer), 16);
    aob_mesh_add_lathe(mesh, foot, axis, head, AOB_COUNT(head), 6);
}

static void add_bolts(struct aob_mesh *mesh, struct aob_vec3 centre, double circle, int count, double size)
{
    for (int i = 0; i < count; i++) {
        double turn = 2 * M_PI * (i + 0.5) / count;
        struct aob_vec3 out = aob_vec(circle * cos(turn), circle * sin(turn), 0);
        add_bolt(mesh, aob_vec_add(centre, out), aob_vec(0, 0, 1), size);
    }
}

/* A rim with teeth, a hub, and either spokes or a web between them. */
static void add_gear(struct aob_mesh *mesh, const struct gear *gear)
{
    struct aob_vec3 outer[MAX_TEETH * TOOTH_POINTS], inner[MAX_TEETH * TOOTH_POINTS];
    double rim = gear->module * (gear->teeth / 2.0 - 1.25 - (gear->spokes ? 2 : 1));
    double w = gear->width, hub = gear->bore;
    struct aob_vec3 middle = aob_vec(gear->x, gear->y, gear->z), axis = aob_vec(0, 0, 1);
    const struct aob_turning boss[] = {{0, -0.15 * w},       {hub, -0.15 * w},     {hub, 1.1 * w},
                                       {0.9 * hub, 1.2 * w}, {0.6 * hub, 1.2 * w}, {0.6 * hub, 1.5 * w},
                                       {0, 1.5 * w}};
    const struct aob_turning web[] = {
        {0, 0.3 * w}, {1.02 * rim, 0.3 * w}, {1.02 * rim, 0.7 * w}, {0, 0.7 * w}};
    tooth_rim(gear, rim, outer, inner);
    aob_mesh_add_band(mesh, outer, inner, (size_t)gear->teeth * TOOTH_POINTS, aob_vec(0, 0, w), true);
    aob_mesh_add_lathe(mesh, middle, axis, boss, AOB_COUNT(boss), 48);
    if (gear->spokes)
        add_spokes(mesh, gear, 0.8 * hub, rim + 0.5 * gear->module);
    else
        aob_mesh_add_lathe(mesh, middle, axis, web, AOB_COUNT(web), 48);
    add_bolts(mesh, aob_vec(gear->x, gear->y, gear->z + 1.2 * w), 0.75 * hub, 6, 0.09 * hub);
}

/* The shaft from the plate through a train's gears, in a flanged bearing on the plate. */
static void add_shaft(struct aob_mesh *mesh, double x, double y, double radius, double reach)
{
    double r = radius;
    const struct aob_turning bearing[] = {{0, -0.02},
                                          {2.6 * r, -0.02},
                                          {2.6 * r, 0.3 * r},
                                          {1.7 * r, 0.4 * r},
                                          {1.5 * r, 0.9 * r},
                                          {1.35 * r, r},
                                          {0, r}};
    aob_mesh_add_lathe(mesh, aob_vec(x, y, 0), aob_vec(0, 0, 1), bearing, AOB_COUNT(bearing), 40);
    aob_mesh_add_cylinder(mesh, aob_vec(x, y, -0.02), aob_vec(x, y, reach), radius, 32);
    add_bolts(mesh, aob_vec(x, y, 0.36 * r), 2.15 * r, 6, 0.2 * r);
}

static void add_frame(struct aob_mesh *mesh)
{
    aob_mesh_add_quad(mesh, aob_vec(-6, 0, -6), aob_vec(0, 0, 12), aob_vec(12, 0, 0));
    aob_mesh_add_box(mesh, aob_vec(-2.2, 0.15, -0.12), aob_vec(2.2, 3.1, 0), 0);
    aob_mesh_add_box(mesh, aob_vec(-2.4, 0, -0.5), aob_vec(2.4, 0.15, 0.9), 0);
    for (int i = 0; i < 3; i++) /* feet of the plate */
        aob_mesh_add_box(mesh, aob_vec(-2.1 + 2.05 * i, 0.15, 0), aob_vec(-2 + 2.05 * i, 0.4, 0.35), 0);
    for (int i = 0; i < 12; i++) {
        add_bolt(mesh, aob_vec(-2.09 + 0.38 * i, 3, 0), aob_vec(0, 0, 1), 0.03);
        add_bolt(mesh, aob_vec(-2.25 + 0.409 * i, 0.15, 0.8), aob_vec(0, 1, 0), 0.035);
    }
}

/* A collar on a pipe, at `centre` along `axis`, with bolts through it. */
static void add_flange(struct aob_mesh *mesh, struct aob_vec3 centre, struct aob_vec3 axis, double radius)
{
    double half = 0.35 * radius;
    const struct aob_turning collar[] = {
        {0, -half},        {1.7 * radius, -half},         {1.7 * radius, -0.04 * radius},
        {1.6 * radius, 0}, {1.7 * radius, 0.04 * radius}, {1.7 * radius, half},
        {0, half}};
    struct aob_vec3 u = aob_vec_normalize(aob_vec_cross(axis, aob_vec(0.3, 0.2, 0.7)));
    struct aob_vec3 v = aob_vec_cross(axis, u);
    aob_mesh_add_lathe(mesh, centre, axis, collar, AOB_COUNT(collar), 32);
    for (int i = 0; i < 8; i++) {
        double turn = 2 * M_PI * i / 8;
        struct aob_vec3 out = aob_vec_add(aob_vec_scale(u, cos(turn)), aob_vec_scale(v, sin(turn)));
        struct aob_vec3 at = aob_vec_add(centre, aob_vec_scale(out, 1.35 * radius));
        add_bolt(mesh, aob_vec_add(at, aob_vec_scale(axis, half)), axis, 0.15 * radius);
        add_bolt(mesh, aob_vec_sub(at, aob_vec_scale(axis, half)), aob_vec_scale(axis, -1), 0.15 * radius);
    }
}

static void add_pipes(struct aob_mesh *mesh)
{
    const struct aob_vec3 wide[] = {
        {-1.75, 0, 0.35}, {-1.75, 2.75, 0.35}, {-0.2, 2.75, 0.35}, {-0.2, 2.75, -0.1}};
    const struct aob_vec3 feed[] = {{1.95, 0, 0.3},    {1.95, 1.2, 0.3}, {1.95, 1.2, 0.6},
                                    {1.95, 2.85, 0.6}, {1.1, 2.85, 0.6}, {1.1, 2.85, -0.1}};
    aob_mesh_add_pipe(mesh, wide, AOB_COUNT(wide), 0.15, 0.3, 32);
    add_flange(mesh, aob_vec(-1.75, 0.9, 0.35), aob_vec(0, 1, 0), 0.15);
    add_flange(mesh, aob_vec(-1.75, 2.2, 0.35), aob_vec(0, 1, 0), 0.15);
    add_flange(mesh, aob_vec(-0.95, 2.75, 0.35), aob_vec(1, 0, 0), 0.15);
    aob_mesh_add_pipe(mesh, feed, AOB_COUNT(feed), 0.06, 0.12, 24);
    add_flange(mesh, aob_vec(1.95, 0.7, 0.3), aob_vec(0, 1, 0), 0.06);
    add_flange(mesh, aob_vec(1.95, 2.1, 0.6), aob_vec(0, 1, 0), 0.06);
    for (int i = 0; i < 6;
         i++) { /* thin lines side by side, from the base round the pinion to the plate's edge */
        double shift = 0.05 * i;
        const struct aob_vec3 line[] = {{1.3 + shift, 0, 0.55},
                                        {1.3 + shift, 0.75 - shift, 0.55},
                                        {1.3 + shift, 0.75 - shift, 0.04},
                                        {1.8, 0.75 - shift, 0.04},
                                        {1.8, 0.75 - shift, -0.05}};
        aob_mesh_add_pipe(mesh, line, AOB_COUNT(line), 0.012, 0.03, 12);
    }
}

/* The train, by modules 40, 25 and 10 mm: 48 teeth drive 16, 40 on that shaft drive 12, 60 on that one drive 15. */
static const struct gear gears[] = {
    {-0.45, 1.5, 0.25, 0.16, 0.04, 48, 6, 0, 0.2},
    {0.658464, 2.14, 0.25, 0.16, 0.04, 16, 0, 221.25, 0.13},
    {0.658464, 2.14, 0.56, 0.1, 0.025, 40, 5, 0, 0.12},
    {0.658464, 1.49, 0.56, 0.1, 0.025, 12, 0, 105, 0.07},
    {0.658464, 1.49, 0.72, 0.05, 0.01, 60, 6, 0, 0.06},
    {1.033464, 1.49, 0.72, 0.05, 0.01, 15, 0, 192, 0.03},
};

static void build_machine(struct aob_mesh *mesh)
{
    add_frame(mesh);
    for (size_t i = 0; i < AOB_COUNT(gears); i++)
        add_gear(mesh, &gears[i]);
    add_shaft(mesh, -0.45, 1.5, 0.12, 0.62);
    add_shaft(mesh, 0.658464, 2.14, 0.07, 0.78);
    add_shaft(mesh, 0.658464, 1.49, 0.04, 0.86);
    add_shaft(mesh, 1.033464, 1.49, 0.02, 0.84);
    add_pipes(mesh);
}

static const struct aob_view machine_views[] = {
    AOB_VIEW("front", 0.6, 1.9, 4.2, 0, 1.5, 0, 50),
    AOB_VIEW("train", 1.5, 2.2, 2, 0.6, 1.7, 0.4, 50),
    AOB_VIEW("teeth", 0.75, 1.62, 1.35, 0.85, 1.5, 0.7, 40),
    AOB_VIEW("pipes", -2.6, 1.2, 1.9, -1.3, 2.1, 0.2, 55),
};
const struct aob_scene_info aob_scene_machine = {
    .name = "machine",
    .title = "Gear train before a plate of 4.4 x 2.95 m, floor x, z -6..6 m, 40,282 triangles: gears of 48 "
             "and 16 teeth (module 40 mm, the first 2 m across), 40 and 12 (25 mm), 60 and 15 (10 mm), "
             "shafts in bearings, pipes 300, 120 and 24 mm thick with bends and flanges, bolts of 3 to 35 mm "
             "radius",
    .metres_per_unit = 1,
    .metre = 1,
    .views = machine_views,
    .view_count = AOB_COUNT(machine_views),
    .build = build_machine,
};
