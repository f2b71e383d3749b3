#include <math.h>
#include <string.h>
#include "base/memory.h"
#include "instruments.h"
#include "reference/oracle.h"
#include "sets.h"

enum { WIDTH = 48, HEIGHT = 32, RAYS = 256, BANDS = 8 };

static struct aob_exhibit *show(struct aob_trial *trial, struct aob_mesh *mesh, struct aob_camera camera)
{
    const struct aob_exhibit_desc desc = {.mesh = mesh, .camera = camera, .width = WIDTH, .height = HEIGHT};
    return aob_trial_exhibit(trial, &desc);
}

/* Every pixel has one exact value. */
static void ask_exact(struct aob_trial *trial, const struct aob_exhibit *exhibit, double radius, float value)
{
    const float *image = aob_trial_trace(trial, exhibit, radius, RAYS);
    for (size_t i = 0; image && i < aob_exhibit_pixels(exhibit); i++)
        aob_trial_take(trial, fabs((double)image[i] - (double)value), NULL, "pixel %zu is %.6f, radius %g", i,
                       (double)image[i], radius);
}

void aob_ask_tracer_plane(struct aob_trial *trial)
{
    for (int tilt = 0; tilt < 80; tilt += 26)
        for (int azimuth = 0; azimuth < 360; azimuth += 77)
            ask_exact(
                trial,
                aob_set_plane(trial, &(struct aob_plane_desc){.tilt_deg = tilt, .azimuth_deg = azimuth}), 1,
                1);
}

void aob_ask_tracer_ball(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_sphere(&mesh, aob_vec(0, 0, 0), 1, 48);
    ask_exact(trial, show(trial, &mesh, (struct aob_camera){.eye = {0.3, 0.2, 3}, .fov_deg = 50}), INFINITY,
              1);
}

void aob_ask_tracer_box(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_box(&mesh, aob_vec(-1, -2, -3), aob_vec(2, 1, 3), 20);
    const struct aob_camera camera = {.eye = {0.2, -0.4, 0.9}, .target = {0.5, -0.7, -1}, .fov_deg = 100};
    ask_exact(trial, show(trial, &mesh, camera), INFINITY, 0);
}

/* The visibility of a point of the floor, which is y = 0. */
typedef double truth_fn(struct aob_vec3 at, double radius);

/* Each band of rows by itself, since what is too dark near an occluder could be made up for by what is too bright far off. */
static void compare(struct aob_trial *trial, const struct aob_exhibit *exhibit, double radius,
                    truth_fn *truth)
{
    const float *image = aob_trial_trace(trial, exhibit, radius, RAYS);
    for (size_t band = 0; image && band < BANDS; band++) {
        size_t count = aob_exhibit_pixels(exhibit) / BANDS;
        double traced = 0, known = 0;
        for (size_t i = band * count; i < (band + 1) * count; i++) {
            traced += (double)image[i] / (double)count;
            known += truth(aob_exhibit_position(exhibit, i), radius) / (double)count;
        }
        aob_trial_take(trial, fabs(traced - known), NULL, "band %zu: mean %.4f, closed form %.4f, radius %g",
                       band, traced, known, radius);
    }
}

/* The camera looks straight down, turned so that the rows go along an occluder that stands at x or at z = 0. */
static struct aob_exhibit *look_down(struct aob_trial *trial, struct aob_mesh *mesh, double x, double z)
{
    aob_mesh_add_quad(mesh, aob_vec(-200, 0, 200), aob_vec(400, 0, 0), aob_vec(0, 0, -400));
    const struct aob_camera camera = {.eye = {x, 2, z}, .target = {x, 0, z}, .fov_deg = 40};
    return show(trial, mesh, camera);
}

static double corner(struct aob_vec3 at, double radius)
{
    return aob_oracle_corner(fabs(at.z), radius);
}

void aob_ask_tracer_corner(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-200, 0, 0), aob_vec(400, 0, 0), aob_vec(0, 200, 0));
    const struct aob_exhibit *exhibit = look_down(trial, &mesh, 0, 0.8);
    compare(trial, exhibit, 0.5, corner);
    compare(trial, exhibit, 2, corner);
}

static const double wall_height = 0.7, sheet_height = 0.5, disc_height = 0.8, disc_radius = 0.5;

static double wall(struct aob_vec3 at, double radius)
{
    return aob_oracle_wall(fabs(at.z), wall_height, radius);
}

void aob_ask_tracer_wall(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-200, 0, 0), aob_vec(400, 0, 0), aob_vec(0, wall_height, 0));
    const struct aob_exhibit *exhibit = look_down(trial, &mesh, 0, 0.8);
    compare(trial, exhibit, 1.5, wall);
    compare(trial, exhibit, INFINITY, wall);
}

static double sheet(struct aob_vec3 at, double radius)
{
    return aob_oracle_sheet(at.x, sheet_height, radius);
}

void aob_ask_tracer_sheet(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-200, sheet_height, 200), aob_vec(200, 0, 0), aob_vec(0, 0, -400));
    const struct aob_exhibit *exhibit = look_down(trial, &mesh, 1.2, 0);
    compare(trial, exhibit, 0.4, sheet);
    compare(trial, exhibit, 1, sheet);
    compare(trial, exhibit, INFINITY, sheet);
}

static double disc(struct aob_vec3 at, double radius)
{
    return aob_oracle_disc(hypot(at.x, at.z), disc_radius, disc_height, radius);
}

void aob_ask_tracer_disc(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_disc(&mesh, aob_vec(0, disc_height, 0), aob_vec(0, 1, 0), disc_radius, 256);
    compare(trial, look_down(trial, &mesh, 0, 1.4), INFINITY, disc);
}

/* The mean over the image of the open directions, as an angle from the plane's normal. */
void aob_ask_tracer_bent(struct aob_trial *trial)
{
    const struct aob_exhibit *exhibit =
        aob_set_plane(trial, &(struct aob_plane_desc){.tilt_deg = 40, .azimuth_deg = 30});
    const struct aob_visibility_term term = {.radius = 1, .bent = true};
    const struct aob_visibility_desc desc = {.terms = &term, .term_count = 1, .spp = RAYS};
    struct aob_visibility traced;
    struct aob_vec3 bent = {0, 0, 0}, normal = {0, 0, 0};
    if (!exhibit || !aob_tracer_visibility(exhibit->tracer, &exhibit->camera, &exhibit->hits, &desc, &traced,
                                           &trial->error))
        return;
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++) {
        const float *b = traced.bent[i], *n = exhibit->hits.normal[i];
        bent = aob_vec_add(bent, aob_vec((double)b[0], (double)b[1], (double)b[2]));
        normal = aob_vec_add(normal, aob_vec((double)n[0], (double)n[1], (double)n[2]));
    }
    aob_visibility_finish(&traced);
    struct aob_vec3 off = aob_vec_cross(aob_vec_normalize(bent), aob_vec_normalize(normal));
    aob_trial_take(trial, asin(fmin(aob_vec_length(off), 1)), NULL, "a plane tilted by 40 degrees");
}

/* How much brighter a pixel is than it may be. */
static void ask_no_brighter(struct aob_trial *trial, const struct aob_exhibit *exhibit, const float *image,
                            const float *most, const char *what)
{
    for (size_t i = 0; image && most && i < aob_exhibit_pixels(exhibit); i++)
        aob_trial_take(trial, aob_over((double)image[i] - (double)most[i]), NULL,
                       "pixel %zu: %.6f over %.6f, %s", i, (double)image[i], (double)most[i], what);
}

void aob_ask_tracer_radius(struct aob_trial *trial)
{
    static const double radii[] = {0.05, 0.2, 0.6, 2, INFINITY};
    const struct aob_exhibit *exhibit = aob_set_default(trial);
    const float *last = NULL;
    for (size_t i = 0; i < AOB_COUNT(radii); i++) {
        const float *image = aob_trial_trace(trial, exhibit, radii[i], 64);
        if (i > 0)
            ask_no_brighter(trial, exhibit, image, last, "a longer radius");
        last = image;
    }
}

/* What lies within the bounds leaves the tracer's scale alone, so that the same rays start at the same places. Pixels that show
 * the new box are not compared. */
void aob_ask_tracer_occluder(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    const struct aob_exhibit *bare = aob_set_default(trial);
    aob_set_still_life(&mesh, 1, aob_vec(0, 0, 0));
    aob_mesh_add_box(&mesh, aob_vec(-0.4, 0.1, 0.6), aob_vec(-0.1, 0.3, 0.8), 30);
    const struct aob_exhibit_desc desc = {
        .mesh = &mesh, .camera = aob_still_life_camera(1, aob_vec(0, 0, 0)), .width = 96, .height = 64};
    const struct aob_exhibit *full = aob_trial_exhibit(trial, &desc);
    const float *open = aob_trial_trace(trial, bare, 1, 64), *closed = aob_trial_trace(trial, full, 1, 64);
    for (size_t i = 0; open && closed && i < aob_exhibit_pixels(bare); i++)
        if (bare->hits.primitive[i] == full->hits.primitive[i] && bare->hits.depth[i] == full->hits.depth[i])
            aob_trial_take(trial, aob_over((double)closed[i] - (double)open[i]), NULL,
                           "pixel %zu: %.6f with a box more, %.6f without", i, (double)closed[i],
                           (double)open[i]);
}

static const float *trace_still_life(struct aob_trial *trial, double scale, struct aob_vec3 move,
                                     const struct aob_exhibit **exhibit)
{
    *exhibit = aob_set_still_life_at(trial, scale, move, 96, 64);
    return aob_trial_trace(trial, *exhibit, 0.8 * scale, 64);
}

void aob_ask_tracer_scaled(struct aob_trial *trial)
{
    static const int exponents[] = {-12, -3, 5, 14};
    const struct aob_exhibit *one, *other;
    const float *wanted = trace_still_life(trial, 1, aob_vec(0, 0, 0), &one);
    for (size_t i = 0; i < AOB_COUNT(exponents); i++) {
        const float *image = trace_still_life(trial, ldexp(1, exponents[i]), aob_vec(0, 0, 0), &other);
        if (image && wanted)
            aob_trial_take(trial, aob_difference_of(one, image, wanted, NULL).most, NULL, "scene times 2^%d",
                           exponents[i]);
    }
}

void aob_ask_tracer_moved(struct aob_trial *trial)
{
    static const struct aob_vec3 moves[] = {{100, 0, 0}, {-3000.7, 900.3, 77.1}, {0, 1e5, -1e5}};
    const struct aob_exhibit *one, *other;
    const float *wanted = trace_still_life(trial, 1, aob_vec(0, 0, 0), &one);
    for (size_t i = 0; i < AOB_COUNT(moves); i++) {
        const float *image = trace_still_life(trial, 1, moves[i], &other);
        if (image && wanted)
            aob_trial_take(trial, aob_difference_of(one, image, wanted, NULL).rmse, NULL,
                           "moved by (%g, %g, %g)", moves[i].x, moves[i].y, moves[i].z);
    }
}
