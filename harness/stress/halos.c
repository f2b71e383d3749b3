#include <math.h>
#include <string.h>
#include "base/memory.h"
#include "claim.h"
#include "groups.h"
#include "sets.h"

enum { WIDTH = 96, HEIGHT = 64 };

/* A wall z = 0, four units before the camera, and before it bars at z = gap: closed, so that techniques which draw triangles
 * see them, and reaching over the image from top to bottom. A sheet is one bar that ends in the middle. */
struct bars {
    double gap, width,
        period; /* scene units; without a period it is the sheet, without a gap the wall alone */
    bool whole; /* the sheet fills the image */
};

static void add_bar(struct aob_mesh *mesh, double left, double right, double gap)
{
    aob_mesh_add_box(mesh, aob_vec(left, -40, gap), aob_vec(right, 40, gap + 0.02), 0);
}

static struct aob_exhibit *show_bars(struct aob_trial *trial, const struct bars *bars)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-40, -40, 0), aob_vec(80, 0, 0), aob_vec(0, 80, 0));
    if (bars->gap > 0 && !(bars->period > 0))
        add_bar(&mesh, -40, bars->whole ? 40 : 0, bars->gap);
    for (double x = -5; bars->gap > 0 && bars->period > 0 && x < 5; x += bars->period)
        add_bar(&mesh, x, x + bars->width, bars->gap);
    return aob_trial_exhibit(trial, &(struct aob_exhibit_desc){.mesh = &mesh,
                                                               .camera = {.eye = {0, 0, 4}, .fov_deg = 60},
                                                               .width = WIDTH,
                                                               .height = HEIGHT});
}

static bool shows_wall(const struct aob_exhibit *exhibit, size_t i)
{
    return aob_exhibit_depth(exhibit, i) > 3.999F && aob_exhibit_is_surface(exhibit, i);
}

/* Takes by how much a pixel of the wall is darker than without the bars. */
static void take_halo(struct aob_trial *trial, const struct bars *bars, double radius)
{
    struct aob_shot bare = {.exhibit = show_bars(trial, &(struct bars){0}), .radius = radius},
                    shot = {.exhibit = show_bars(trial, bars), .radius = radius};
    const float *wanted = aob_trial_draw(trial, &bare), *image = aob_trial_draw(trial, &shot);
    double most = NAN;
    size_t at = 0;
    if (!wanted || !image)
        return;
    for (size_t i = 0; i < aob_exhibit_pixels(shot.exhibit); i++) {
        double darker = (double)wanted[i] - (double)image[i];
        if (!shows_wall(shot.exhibit, i) || darker <= most)
            continue;
        most = darker;
        at = i;
    }
    aob_trial_take(trial, aob_over(most), &(struct aob_seen){&shot, image, wanted},
                   "radius %g, %g radii before the wall: its pixel (%d, %d) is %.4f, %.4f without", radius,
                   bars->gap / radius, (int)at % WIDTH, (int)at / WIDTH, (double)image[at],
                   (double)wanted[at]);
}

static void ask_step_edge(struct aob_trial *trial)
{
    static const double gaps[] = {1.1, 2.2, 5};
    for (size_t i = 0; i < AOB_COUNT(gaps); i++) {
        take_halo(trial, &(struct bars){.gap = 0.5 * gaps[i]}, 0.5);
        take_halo(trial, &(struct bars){.gap = 0.1 * gaps[i]}, 0.1);
    }
}

/* A pixel is .072 units wide at the wall: bars of 1 to 3 of them. */
static void ask_fence(struct aob_trial *trial)
{
    static const double gaps[] = {1.1, 2.2, 5}, widths[] = {0.06, 0.2};
    for (size_t i = 0; i < AOB_COUNT(gaps); i++)
        for (size_t k = 0; k < AOB_COUNT(widths); k++)
            take_halo(trial, &(struct bars){.gap = 0.5 * gaps[i], .width = widths[k], .period = 0.45}, 0.5);
}

/* --- Within reach --------------------------------------------------------------------------------------------- */

/* Pixels in both directions a multiple of eight, where the fence shows the wall: all sizes of an image have such a pixel. */
static bool *sparse_pixels(struct aob_trial *trial, const struct aob_exhibit *fence)
{
    bool *mask = aob_trial_mask(trial, fence);
    for (int y = 0; y < HEIGHT; y += 8)
        for (int x = 0; x < WIDTH; x += 8)
            mask[y * WIDTH + x] = shows_wall(fence, (size_t)(y * WIDTH + x));
    return mask;
}

/* Lets a whole sheet show the wall behind it in the pixels of the mask: what they see is the sheet all around. */
static void pierce(struct aob_exhibit *sheet, const struct aob_exhibit *bare, const bool *mask)
{
    for (size_t i = 0; i < aob_exhibit_pixels(sheet); i++)
        if (mask[i]) {
            sheet->gbuffer.depth[i] = bare->gbuffer.depth[i];
            memcpy(&sheet->gbuffer.normal[4 * i], &bare->gbuffer.normal[4 * i], 4 * sizeof(float));
            memcpy(&sheet->gbuffer.shading[4 * i], &bare->gbuffer.shading[4 * i], 4 * sizeof(float));
        }
}

static void take_between(struct aob_trial *trial, double gap, double width)
{
    struct aob_exhibit *bare = show_bars(trial, &(struct bars){0}),
                       *fence = show_bars(trial, &(struct bars){gap, width, 0.37, false}),
                       *sheet = show_bars(trial, &(struct bars){.gap = gap, .whole = true});
    if (!bare || !fence || !sheet)
        return;
    bool *mask = sparse_pixels(trial, fence);
    pierce(sheet, bare, mask);
    /* Without filters: those mix what lies a small share of the radius apart, and here that is wall and sheet. */
    struct aob_shot shot = {.exhibit = fence, .radius = 0.5, .set = "blur=0 composite=off"}, open = shot,
                    closed = shot;
    open.exhibit = bare;
    closed.exhibit = sheet;
    const float *image = aob_trial_draw(trial, &shot), *none = aob_trial_draw(trial, &open),
                *all = aob_trial_draw(trial, &closed);
    if (!image || !none || !all)
        return;
    double bars = aob_mean_of(bare, image, mask), most = aob_mean_of(bare, none, mask),
           least = aob_mean_of(bare, all, mask);
    aob_trial_take(trial, aob_over(aob_worse(bars - most, least - bars)),
                   &(struct aob_seen){&shot, image, none},
                   "bars %g wide, %g before the wall: its mean is %.4f, with a sheet %.4f, with nothing %.4f",
                   width, gap, bars, least, most);
}

static void ask_in_reach(struct aob_trial *trial)
{
    static const double gaps[] = {0.05, 0.2, 0.4}, widths[] = {0.06, 0.2};
    for (size_t i = 0; i < AOB_COUNT(gaps); i++)
        for (size_t k = 0; k < AOB_COUNT(widths); k++)
            take_between(trial, gaps[i], widths[k]);
}

/* --- A pillar, and the far away ------------------------------------------------------------------------------ */

enum {
    PLAN = 192
}; /* pixels of the pillar's image in both directions; 32 a unit, so that its sides lie between pixels */

static double mean_beside(struct aob_trial *trial, const struct aob_exhibit *plan, const float *image,
                          int side, int reach)
{
    bool *mask = aob_trial_mask(trial, plan);
    for (int i = 0; i < reach; i++)
        for (int k = PLAN / 2 - 32; k < PLAN / 2 + 32; k++) {
            int away = side % 2 ? PLAN / 2 + 32 + i : PLAN / 2 - 33 - i;
            mask[side < 2 ? k * PLAN + away : away * PLAN + k] = true;
        }
    return aob_mean_of(plan, image, mask);
}

static void ask_pillar(struct aob_trial *trial)
{
    static const char *const sides[] = {"left", "right", "upper", "lower"};
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-40, 0, 40), aob_vec(80, 0, 0), aob_vec(0, 0, -80));
    aob_mesh_add_box(&mesh, aob_vec(-1, 0, -1), aob_vec(1, 0.5, 1), 0);
    const struct aob_exhibit_desc desc = {
        .mesh = &mesh, .camera = {.eye = {0, 10, 0}, .ortho_height = 6}, .width = PLAN, .height = PLAN};
    struct aob_shot shot = {.exhibit = aob_trial_exhibit(trial, &desc), .radius = 1};
    const float *image = aob_trial_draw(trial, &shot);
    double mean[4], all = 0;
    if (!image)
        return;
    for (int i = 0; i < 4; i++) {
        mean[i] = mean_beside(trial, shot.exhibit, image, i, 32);
        all += 0.25 * mean[i];
    }
    for (int i = 0; i < 4; i++)
        aob_trial_take(trial, fabs(mean[i] - all), &(struct aob_seen){&shot, image, NULL},
                       "the floor at its %s side is %.4f, around it %.4f", sides[i], mean[i], all);
}

static double wave(double x, double y)
{
    return sin(x) * sin(y);
}

/* Hills 12 pixels apart and half a pixel high, as far as the image reaches, seen at 45 degrees from `distance`; `pixel` is
 * the width of one there. */
static struct aob_exhibit *show_hills(struct aob_trial *trial, double distance, double pixel)
{
    enum { CELLS = 96 };
    struct aob_mesh mesh = {0};
    double step = 2 * pixel, turn = 2 * M_PI / (12 * pixel);
    for (int i = 0; i <= CELLS; i++)
        for (int k = 0; k <= CELLS; k++) {
            double x = step * (k - CELLS / 2), z = step * (i - CELLS / 2);
            aob_mesh_add_vertex(&mesh, aob_vec(x, 0.5 * pixel * wave(turn * x, turn * z), z));
        }
    for (uint32_t i = 0; i < CELLS; i++)
        for (uint32_t k = 0; k < CELLS; k++) {
            uint32_t a = i * (CELLS + 1) + k, below = a + CELLS + 1;
            aob_mesh_add_triangle(&mesh, a, below, below + 1);
            aob_mesh_add_triangle(&mesh, a, below + 1, a + 1);
        }
    const struct aob_camera camera = {.eye = {0, distance * M_SQRT1_2, distance * M_SQRT1_2}, .fov_deg = 20};
    return aob_trial_exhibit(
        trial, &(struct aob_exhibit_desc){.mesh = &mesh, .camera = camera, .width = 64, .height = 48});
}

static void ask_terrain(struct aob_trial *trial)
{
    static const double shares[] = {0.9, 0.5, 0.25, 0.1};
    double distance = 500, pixel = 2 * distance * tan(10 * M_PI / 180) / 48;
    struct aob_exhibit *hills = show_hills(trial, distance, pixel);
    for (size_t i = 0; i < AOB_COUNT(shares); i++) {
        struct aob_shot shot = {.exhibit = hills, .radius = shares[i] * pixel};
        const float *image = aob_trial_draw(trial, &shot),
                    *claim = aob_claim_trace(trial, &shot, AOB_CLAIM_OF_SCENE, 64);
        if (!image || !claim)
            return;
        double wanted = aob_mean_of(hills, claim, NULL), mean = aob_mean_of(hills, image, NULL);
        aob_trial_take(trial, aob_over(wanted - mean), &(struct aob_seen){&shot, image, claim},
                       "radius %g of a pixel: mean %.4f, traced %.4f", shares[i], mean, wanted);
    }
}

const struct aob_property aob_properties_halos[] = {
    {.name = "step_edge_halo",
     .sentence = "A sheet farther than the radius before a wall darkens nothing of it.",
     .measure = "largest darkening of a pixel",
     .source = "https://github.com/GameTechDev/ASSAO/pull/7",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .excuse = aob_excuse_no_radius,
     .ask = ask_step_edge},
    {.name = "thin_fence",
     .sentence = "Thin bars farther than the radius before a wall leave it as open as it is.",
     .measure = "largest darkening of a pixel",
     .source = "https://github.com/o3de/sig-graphics-audio/issues/124",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .excuse = aob_excuse_no_radius,
     .ask = ask_fence},
    {.name = "thin_in_reach",
     .sentence = "Bars before a wall darken it no more than a sheet in their place, and do not brighten it.",
     .measure = "how far the mean of the wall between them is out of that",
     .source = "https://github.com/bevyengine/bevy/pull/13454",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .excuse = aob_excuse_no_radius,
     .ask = ask_in_reach},
    {.name = "pillar_round",
     .sentence =
         "The floor around a square pillar, seen from straight above, is equally dark on its four sides.",
     .measure = "largest distance of a side's mean from the mean of all",
     .source = "https://github.com/o3de/sig-graphics-audio/issues/124",
     .group = AOB_GROUP_EDGES,
     .ask = ask_pillar},
    {.name = "distant_terrain",
     .sentence =
         "Hills so far away that the radius is less than a pixel are no darker than the technique claims: "
         "nearly open.",
     .measure = "darkening of the mean, from the traced claim",
     .source = "https://github.com/frostbone25/ShaderInjector/issues/79",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .excuse = aob_excuse_no_radius,
     .ask = ask_terrain},
    {0},
};
