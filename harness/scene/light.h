/* Distant light: the radiance that comes from each direction, the same at every place, as nine real spherical harmonics
 * per channel. World space, right-handed, +Y up. A direction points from the surface to where the light comes from, and
 * has unit length. Nothing here keeps state, so all of it may be called from several threads.
 *
 * Nine coefficients are enough for the irradiance of a matt surface (Ramamoorthi and Hanrahan, An Efficient
 * Representation for Irradiance Environment Maps, 2001); a light with sharp edges loses them. */
#ifndef AOB_SCENE_LIGHT_H
#define AOB_SCENE_LIGHT_H
#include "camera.h"

/* Coefficients in the order (l, m) = 00, 1-1, 10, 11, 2-2, 2-1, 20, 21, 22; columns are R, G, B. The basis is the usual
 * orthonormal real one with positive signs, in coordinates of the light's own space:
 *     Y00  = 0.5 sqrt(1/pi)          Y1-1, Y10, Y11 = sqrt(3/(4 pi)) times y, z, x
 *     Y2-2, Y2-1, Y21 = 0.5 sqrt(15/pi) times xy, yz, xz
 *     Y20  = 0.25 sqrt(5/pi) (3 z^2 - 1)      Y22 = 0.25 sqrt(15/pi) (x^2 - y^2)
 * The z of Y10 and Y20 is the +Z axis of the space and not its up. */
struct aob_light {
    double sh[9][3];
};

extern const struct aob_light aob_light_uniform; /* radiance 1 from everywhere, in all channels */

/* The nine functions at a direction, in the order above. */
void aob_light_basis(struct aob_vec3 direction, double basis[9]);

/* The radiance of the nine coefficients from a direction: linear R, G, B. */
void aob_light_radiance(const struct aob_light *light, struct aob_vec3 direction, double rgb[3]);

/* The irradiance of a surface that nothing occludes, over pi: what a white matt one reflects. It is exact; the bands l =
 * 0, 1, 2 count 1, 2/3 and 1/4 (Ramamoorthi and Hanrahan, On the Relationship between Radiance and Irradiance, 2001). */
void aob_light_irradiance(const struct aob_light *light, struct aob_vec3 normal, double rgb[3]);

/* The coefficients of the same light in view space, whose +X, +Y, +Z are right, up, back: the radiance of `turned` from a
 * view-space direction is that of `light` from the world direction. It is exact but for rounding: band 1 turns as a
 * vector, band 2 as a symmetric matrix without trace. `turned` may be `light`. */
void aob_light_turn(const struct aob_light *light, const struct aob_frame_axes *axes,
                    struct aob_light *turned);

/* What a light loses when nine coefficients stand for it. */
struct aob_light_projection {
    struct aob_light light; /* with the window */
    double held; /* share of the integral of L^2, over all channels, in the nine before the window; 0..1 */
    double factors[2]; /* of bands 1 and 2, the window; 1 where it was not needed */
};

/* The radiance from a direction, linear R, G, B: finite, not negative, and smooth but for edges. */
typedef void aob_light_radiance_fn(void *user, struct aob_vec3 direction, double rgb[3]);

/* Projects a radiance onto the nine functions, then weakens bands 1 and 2 of all channels by one window, so that the
 * result is nowhere negative (Sloan, Deringing Spherical Harmonics, 2017, does so by one window a light). The integral is
 * over 256 rings of Gauss-Legendre nodes about +Y, of 512 directions each: exact for polynomials, and an edge is right to
 * about half a degree. The window is that of diffusion on the sphere, w for band 1 and w^3 for band 2: the least radiance
 * rises as w falls. w is the largest in 0..1, found by bisection, with which no channel is below 0 in any direction. "Nowhere negative" is up to rounding, 1e-12 of the channel's mean. The mean of the radiance, and so the
 * integral, are kept. The same radiance gives the same bits. */
void aob_light_project(aob_light_radiance_fn *radiance, void *user, struct aob_light_projection *projection);

/* For what integrates by itself. Integrals over the sphere of a radiance times 1, a coordinate, or a product of two, and
 * the nine coefficients of that radiance. */
struct aob_light_moments {
    double one, x, y, z, xy, yz, xz, xx, yy, zz;
};
void aob_light_of_moments(const struct aob_light_moments *moments, double sh[9]);

/* For the same: applies the window to projection->light, whose coefficients are the raw integrals, and
 * sets the rest. `energy` is the integral of L^2 over the sphere, added up over the channels. */
void aob_light_window(struct aob_light_projection *projection, double energy);

/* The least radiance of a channel (0, 1, 2) over all directions. */
double aob_light_least(const struct aob_light *light, int channel);

/* What takes an open white matt surface that faces the light, in its brightest channel, to 1: 1 over the largest irradiance over
 * pi of any normal. It is the same in any space; 1 of a light that is black. */
double aob_light_exposure(const struct aob_light *light);

struct aob_light_info {
    const char *name, *title; /* title: one sentence with the radiances in numbers */
    aob_light_radiance_fn *radiance;
};
extern const struct aob_light_info
    aob_lights[]; /* ends with a NULL name; the first is `uniform`, the default */

const struct aob_light_info *aob_light_find(const char *name); /* NULL if unknown */

/* The named light's coefficients, by projection; it takes some milliseconds. `uniform` is aob_light_uniform to the bit. */
void aob_light_make(const struct aob_light_info *info, struct aob_light_projection *projection);
#endif
