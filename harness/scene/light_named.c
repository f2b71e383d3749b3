#include <string.h>
#include "light.h"

static void set(double rgb[3], double r, double g, double b)
{
    rgb[0] = r;
    rgb[1] = g;
    rgb[2] = b;
}

static void uniform(void *user, struct aob_vec3 direction, double rgb[3])
{
    (void)user;
    (void)direction;
    set(rgb, 1, 1, 1);
}

/* Squared, so that the bright band is the horizon's and not half the sky's. */
static void sky(void *user, struct aob_vec3 direction, double rgb[3])
{
    (void)user;
    if (direction.y < 0) {
        set(rgb, 0.2, 0.18, 0.15);
        return;
    }
    const double zenith[3] = {0.6, 0.8, 1.2}, horizon[3] = {1.1, 1.25, 1.4}, glow[3] = {1.8, 1.3, 0.7};
    double low = (1 - direction.y) * (1 - direction.y);
    double towards = aob_vec_dot(direction, aob_vec(0.64, 0.6, 0.48));
    double near = towards > 0 ? pow(towards, 4) : 0;
    for (int channel = 0; channel < 3; channel++)
        rgb[channel] = zenith[channel] + low * (horizon[channel] - zenith[channel]) + near * glow[channel];
}

static void window(void *user, struct aob_vec3 direction, double rgb[3])
{
    (void)user;
    /* Tangents of 25, 20 and 40 degrees: the rectangle lies in the plane x = -1. */
    const double half = 0.46630765815499858, below = 0.36397023426620234, above = 0.83909963117728;
    double away = -direction.x;
    bool through = away > 0 && fabs(direction.z) <= half * away && direction.y >= -below * away &&
                   direction.y <= above * away;
    if (through)
        set(rgb, 11, 12, 13.5);
    else
        set(rgb, 0.08, 0.08, 0.08);
}

const struct aob_light_info aob_lights[] = {
    {"uniform", "Radiance 1 from every direction in every channel", uniform},
    {"sky",
     "Clear sky of 0.6 0.8 1.2 at the zenith and 1.1 1.25 1.4 at the horizon, ground of 0.2 0.18 0.15 "
     "below, and about (0.64, 0.6, 0.48) a glow of 1.8 1.3 0.7 times the 4th power of the cosine",
     sky},
    {"window",
     "Dim room of 0.08 with a window of 11 12 13.5 towards -X, 50 degrees wide, from 20 degrees below the "
     "horizon to 40 above",
     window},
    {0},
};

const struct aob_light_info *aob_light_find(const char *name)
{
    for (const struct aob_light_info *light = aob_lights; light->name; light++)
        if (!strcmp(light->name, name))
            return light;
    return NULL;
}

void aob_light_make(const struct aob_light_info *info, struct aob_light_projection *projection)
{
    if (info->radiance == uniform)
        *projection = (struct aob_light_projection){.light = aob_light_uniform, .held = 1, .factors = {1, 1}};
    else
        aob_light_project(info->radiance, NULL, projection);
}
