#include "drawn.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "store/image.h"

static const char *const bounced[3] = {"technique.visibility_rgb.R", "technique.visibility_rgb.G",
                                       "technique.visibility_rgb.B"},
                         *const light[3] = {"technique.irradiance.R", "technique.irradiance.G",
                                            "technique.irradiance.B"},
                         *const bent[3] = {"technique.bent.X", "technique.bent.Y", "technique.bent.Z"};

/* Of the squares: what floats round. */
static const double nothing = 1e-12;

static float at(const float *plane, size_t i)
{
    return plane ? plane[i] : NAN;
}

static void take(const struct aob_image *image, const struct aob_seen *seen, struct aob_drawn *drawn)
{
    const float *visible = aob_image_channel(image, "technique.AO"),
                *lobe = aob_image_channel(image, "technique.specular"), *three[3][3];
    const char *const *const names[3] = {bounced, light, bent};
    for (int k = 0; k < 3; k++)
        for (int c = 0; c < 3; c++)
            three[k][c] = aob_image_channel(image, names[k][c]);
    for (size_t s = 0; s < seen->count; s++) {
        size_t i = seen->pixel[s];
        struct aob_drawn_surface *d = &drawn->surfaces[s];
        d->visible = at(visible, i);
        d->lobe = at(lobe, i);
        for (int c = 0; c < 3; c++) {
            d->bounced[c] = at(three[0][c], i);
            d->light[c] = at(three[1][c], i);
            d->bent[c] = at(three[2][c], i);
        }
    }
}

bool aob_drawn_read(struct aob_drawn *drawn, const struct aob_seen *seen, const char *path,
                    struct aob_error *error)
{
    struct aob_image image = {0};
    *drawn = (struct aob_drawn){0};
    if (!aob_image_read(&image, path, error))
        return false;
    bool ok = image.width == seen->width && image.height == seen->height;
    if (ok) {
        drawn->surfaces = AOB_NEW_ARRAY(struct aob_drawn_surface, seen->count + 1);
        take(&image, seen, drawn);
    }
    aob_image_finish(&image);
    return ok || aob_fail(error, "%s: not a frame of %dx%d", path, seen->width, seen->height);
}

void aob_drawn_finish(struct aob_drawn *drawn)
{
    free(drawn->surfaces);
    *drawn = (struct aob_drawn){0};
}

/* Irradiance over pi, no bounces counted. */
static void plain_light(const struct aob_seen *seen, const struct aob_drawn_surface *d, unsigned set,
                        size_t i, double rgb[3])
{
    const struct aob_seen_surface *s = &seen->surfaces[i];
    struct aob_vec3 axis = aob_vec((double)d->bent[0], (double)d->bent[1], (double)d->bent[2]);
    double open[3] = {(double)s->light[0], (double)s->light[1], (double)s->light[2]},
           length = aob_vec_length(axis);
    if (aob_effect_has(set, AOB_EFFECT_BENT_NORMAL) && length > 1e-15)
        aob_light_irradiance(&seen->light, aob_vec_scale(axis, 1 / length), open);
    for (int c = 0; c < 3; c++)
        rgb[c] =
            aob_effect_has(set, AOB_EFFECT_DIRECTIONAL) ? (double)d->light[c] : (double)d->visible * open[c];
}

void aob_drawn_light(const struct aob_seen *seen, const struct aob_drawn *drawn, unsigned set, size_t i,
                     double rgb[3])
{
    static const struct aob_drawn_surface open = {.visible = 1, .lobe = 1};
    const struct aob_seen_surface *s = &seen->surfaces[i];
    const struct aob_drawn_surface *d = set ? &drawn->surfaces[i] : &open;
    double visible = (double)d->visible, plain[3],
           share = aob_effect_has(set, AOB_EFFECT_SPECULAR) ? (double)d->lobe : visible;
    plain_light(seen, d, set, i, plain);
    for (int c = 0; c < 3; c++) {
        double gain = aob_effect_has(set, AOB_EFFECT_MULTI_BOUNCE)
                          ? (double)d->bounced[c] / fmax(visible, 1.0 / 1024)
                          : 1,
               whole = plain[c] * gain, closed = fmax(whole - plain[c], 0) / fmax(1 - visible, 1.0 / 256);
        rgb[c] = (double)s->diffuse[c] * whole + share * (double)s->mirror[c] +
                 (1 - share) * closed * (double)s->even[c];
    }
}

/* Over channels what the difference from the truth has beside the truth's noise, squared; and the variance of that by the noise. With a
 * noise of e and a difference d the square is off by 2 d e, and d se tells its mean square without bias, e's own share in d
 * included. The channels of a pixel come from the same rays, so their noise adds up. */
static double square_of(const struct aob_seen_surface *s, const double rgb[3], double *variance)
{
    double off = 0, deviation = 0;
    for (int c = 0; c < 3; c++) {
        double d = rgb[c] - (double)s->truth[c], se = (double)s->se[c];
        off += d * d - se * se;
        deviation += 2 * fabs(d) * se;
    }
    *variance = deviation * deviation;
    return off;
}

struct aob_lit_error aob_drawn_error(const struct aob_seen *seen, const struct aob_drawn *drawn, unsigned set)
{
    double sum = 0, variance = 0, count = (double)seen->count;
    for (size_t i = 0; i < seen->count; i++) {
        double rgb[3], one;
        aob_drawn_light(seen, drawn, set, i, rgb);
        sum += square_of(&seen->surfaces[i], rgb, &one);
        variance += one;
    }
    double whole = 3 * count * seen->mean_light * seen->mean_light, square_se = sqrt(variance) / whole,
           rmse = sum > nothing * whole ? sqrt(sum / whole) : 0;
    /* The root of what may be nothing is as uncertain as the root of its error. */
    return (struct aob_lit_error){.rmse = rmse,
                                  .rmse_se = square_se > 0 ? square_se / fmax(2 * rmse, sqrt(square_se)) : 0,
                                  .flip = NAN};
}
