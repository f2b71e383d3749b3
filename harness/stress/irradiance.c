#include <math.h>
#include <stdio.h>
#include "base/memory.h"
#include "effects.h"
#include "sets.h"

static const char wanted_set[] = "irradiance=on";

/* Takes each channel against the light of an open surface with this normal (world space); NULL: with the normals of the
 * exhibit, whose view space lies as the world does. */
static void take_open(struct aob_trial *trial, const struct aob_shot *shot, const struct aob_vec3 *normal,
                      const char *text)
{
    const struct aob_exhibit *exhibit = shot->exhibit;
    const float *light = aob_trial_read(trial, shot).of[AOB_OUT_IRRADIANCE];
    for (int c = 0; light && c < 3; c++) {
        float *wanted = aob_trial_image(trial, exhibit);
        for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++) {
            const float *n = exhibit->gbuffer.normal + 4 * aob_exhibit_place(exhibit, i);
            double open[3];
            aob_light_irradiance(shot->light,
                                 normal ? *normal : aob_vec((double)n[0], (double)n[1], (double)n[2]), open);
            wanted[i] = (float)open[c];
        }
        aob_effects_take(trial, shot, aob_effects_channel(trial, exhibit, light, c, 1), wanted, text);
    }
}

static void take_plane(struct aob_trial *trial, struct aob_exhibit *exhibit, const char *text, void *user)
{
    const struct aob_light light = aob_effects_light(user);
    const struct aob_shot shot = {.exhibit = exhibit, .radius = 0.5, .set = wanted_set, .light = &light};
    take_open(trial, &shot, NULL, text);
}

void aob_ask_irradiance_on_plane(struct aob_trial *trial)
{
    struct aob_chance chance = aob_chance_of("irradiance_on_plane");
    aob_effects_planes(trial, take_plane, &chance);
}

/* One plane and one light; the camera goes round them, and its axes with it. */
void aob_ask_irradiance_turned(struct aob_trial *trial)
{
    struct aob_chance chance = aob_chance_of("irradiance_turned");
    const struct aob_light light = aob_effects_light(&chance);
    const struct aob_vec3 n = aob_vec(1.0 / 3, 2.0 / 3, 2.0 / 3), u = aob_vec(2.0 / 3, 1.0 / 3, -2.0 / 3),
                          v = aob_vec_cross(n, u);
    for (int around = 0; around < 360; around += 45) {
        struct aob_mesh mesh = {0};
        double a = around * M_PI / 180;
        struct aob_vec3 out = aob_vec_add(aob_vec_scale(u, cos(a)), aob_vec_scale(v, sin(a)));
        aob_mesh_add_quad(&mesh, aob_vec_scale(aob_vec_add(u, v), -200), aob_vec_scale(u, 400),
                          aob_vec_scale(v, 400));
        const struct aob_exhibit_desc desc = {
            .mesh = &mesh,
            .camera = {.eye = aob_vec_add(aob_vec_scale(n, 3), aob_vec_scale(out, 2)),
                       .fov_deg = 40,
                       .ortho_height = around % 90 ? 3 : 0},
            .width = 48,
            .height = 32,
            .guard = 16};
        const struct aob_shot shot = {
            .exhibit = aob_trial_exhibit(trial, &desc), .radius = 0.3, .set = wanted_set, .light = &light};
        char text[80];
        snprintf(text, sizeof text, "the camera at %d degrees", around);
        take_open(trial, &shot, &n, text);
    }
}

void aob_ask_irradiance_uniform(struct aob_trial *trial)
{
    static const double radiances[3] = {0.25, 1, 40};
    struct aob_light light = aob_light_uniform;
    for (int c = 0; c < 3; c++)
        light.sh[0][c] *= radiances[c];
    const struct aob_shot shot = {
        .exhibit = aob_set_default(trial), .radius = 0.5, .set = wanted_set, .light = &light};
    struct aob_reading reading = aob_trial_read(trial, &shot);
    const float *pixels = reading.of[AOB_OUT_IRRADIANCE];
    for (int c = 0; pixels && c < 3; c++) {
        char text[80];
        snprintf(text, sizeof text, "a radiance of %g", radiances[c]);
        aob_effects_take(trial, &shot, aob_effects_channel(trial, shot.exhibit, pixels, c, radiances[c]),
                         reading.of[AOB_OUT_VISIBILITY], text);
    }
}

static struct aob_light scaled(const struct aob_light *light, double factor)
{
    struct aob_light product;
    for (int i = 0; i < 9; i++)
        for (int c = 0; c < 3; c++)
            product.sh[i][c] = factor * light->sh[i][c];
    return product;
}

static const float *draw_light(struct aob_trial *trial, struct aob_shot *shot, const struct aob_light *light)
{
    shot->light = light;
    return aob_trial_read(trial, shot).of[AOB_OUT_IRRADIANCE];
}

/* A technique may cut off at 0 what came out negative. Where it did, sums are no sums. */
static void take_sum(struct aob_trial *trial, const struct aob_shot *shot, const float *const lights[3])
{
    double most = 0;
    size_t at = 0, count = 0;
    for (size_t i = 0; i < 3 * aob_exhibit_pixels(shot->exhibit); i++) {
        double a = (double)lights[0][i], b = (double)lights[1][i];
        if (!aob_exhibit_is_surface(shot->exhibit, i / 3) || a == 0 || b == 0)
            continue;
        double off = fabs(a + b - (double)lights[2][i]) / 2;
        at = off > most ? i : at;
        most = fmax(most, off);
        count++;
    }
    aob_trial_take(trial, count ? most : NAN, &(struct aob_seen){shot, NULL, NULL},
                   "pixel %zu has %g and %g of two lights, and %g of both", at / 3, (double)lights[0][at],
                   (double)lights[1][at], (double)lights[2][at]);
}

void aob_ask_irradiance_linear(struct aob_trial *trial)
{
    static const double factors[] = {1e4, 1e-4};
    struct aob_chance chance = aob_chance_of("irradiance_linear");
    const struct aob_light one = aob_effects_light(&chance), other = aob_effects_light(&chance);
    struct aob_light sum = one;
    for (int i = 0; i < 27; i++)
        sum.sh[i / 3][i % 3] += other.sh[i / 3][i % 3];
    struct aob_shot shot = {.exhibit = aob_set_default(trial), .radius = 0.5, .set = wanted_set};
    const float *lights[3] = {draw_light(trial, &shot, &one), draw_light(trial, &shot, &other),
                              draw_light(trial, &shot, &sum)};
    if (!lights[0] || !lights[1] || !lights[2])
        return;
    take_sum(trial, &shot, lights);
    for (size_t f = 0; f < AOB_COUNT(factors); f++) {
        const struct aob_light strong = scaled(&one, factors[f]);
        const float *pixels = draw_light(trial, &shot, &strong);
        char text[80];
        snprintf(text, sizeof text, "the light times %g", factors[f]);
        for (int c = 0; pixels && c < 3; c++)
            aob_effects_take(trial, &shot, aob_effects_channel(trial, shot.exhibit, pixels, c, factors[f]),
                             aob_effects_channel(trial, shot.exhibit, lights[0], c, 1), text);
    }
}

struct sun {
    struct aob_vec3 at;
    double cosine;
};

static void radiance_of_sun(void *user, struct aob_vec3 direction, double rgb[3])
{
    const struct sun *sun = user;
    bool inside = aob_vec_dot(direction, sun->at) > sun->cosine;
    for (int c = 0; c < 3; c++)
        rgb[c] = inside ? 1e6 : 0.01 * c;
}

/* One degree wide is the sun in the sky of a probe; 30 degrees are what a lamp before a camera is. What is asked is whether
 * aob_trial_read finds anything. */
void aob_ask_irradiance_of_sun(struct aob_trial *trial)
{
    static const double degrees[] = {1, 8, 30, 90};
    struct aob_chance chance = aob_chance_of("irradiance_of_sun");
    struct aob_shot shot = {.exhibit = aob_set_default(trial), .radius = 0.5, .set = wanted_set};
    for (size_t d = 0; d < AOB_COUNT(degrees); d++) {
        struct sun sun = {aob_chance_direction(&chance), cos(degrees[d] * M_PI / 180)};
        sun.at.y = fabs(sun.at.y);
        struct aob_light_projection projection;
        aob_light_project(radiance_of_sun, &sun, &projection);
        if (!draw_light(trial, &shot, &projection.light))
            return;
        aob_trial_take(trial, 0, &(struct aob_seen){&shot, NULL, NULL}, "a sun of %g degrees", degrees[d]);
    }
}
