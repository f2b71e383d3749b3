/* Light probes: distant light from an EXR file, as the nine coefficients of scene/light.h.
 *
 * The file is an equirectangular (latitude-longitude) image with the channels R, G and B, linear radiance, twice as wide
 * as high. Its first row is up (+Y) and its last one down; the middle of its width looks along -Z, as a view does, and
 * columns to the right of it turn towards +X: column x of w and row y of h begin at
 *     azimuth = 2 pi x / w - pi, polar = pi y / h, direction = (sin polar sin azimuth, cos polar, -sin polar cos azimuth).
 * Programs differ in what lies in the middle, and agree on the rest: it is +X in three.js and Blender (its own +X, with
 * its Z taken as up), and +Z in OpenEXR's library (ImfEnvmap.h). Light read from such a file is turned about +Y;
 * aob_light_turn with right = -Z, back = +X undoes it for +X in the middle, with right = -X, back = -Z for +Z. */
#ifndef AOB_GBUFFER_PROBE_H
#define AOB_GBUFFER_PROBE_H
#include <stdbool.h>
#include "base/error.h"
#include "scene/light.h"

enum { AOB_PROBE_MAX_WIDTH = 8192 }; /* texels; nine coefficients need no more than a few hundred */

/* Bounds of the mean radiance of a probe's brightest channel: what a technique writes in half floats keeps its digits. */
#define AOB_PROBE_LEAST_MEAN 1e-3
#define AOB_PROBE_MOST_MEAN  1.6e4

/* Reads and projects a probe. Each texel is one radiance over its part of the sphere, whose integrals are exact; the
 * window is that of aob_light_project. The file may be another program's, of any form that aob_image_read_layers takes,
 * so this belongs into a worker, as captures do. It takes about 12 bytes a texel. False after one line that names the
 * file, if that cannot be read, lacks one of the channels, is too large or not twice as wide as high, has a texel that is
 * negative or not finite, is black, or is too dark or bright in the mean. */
bool aob_probe_read(const char *path, struct aob_light_projection *projection, struct aob_error *error);
#endif
