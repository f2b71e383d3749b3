#include "probe.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "store/image.h"

static const char *const names[3] = {"R", "G", "B"};

static bool choose(void *user, const char *const *all, size_t count, bool *wanted, struct aob_error *error)
{
    for (int channel = 0; channel < 3; channel++) {
        size_t i = 0;
        while (i < count && strcmp(all[i], names[channel]))
            i++;
        if (i == count)
            return aob_fail(error,
                            "%s: no light probe: it has no channel %s; store the radiance as R, G and B",
                            (const char *)user, names[channel]);
        wanted[i] = true;
    }
    return true;
}

static bool check_size(const struct aob_image *image, const char *path, struct aob_error *error)
{
    if (image->width > AOB_PROBE_MAX_WIDTH)
        return aob_fail(error,
                        "%s: no light probe: %d x %d texels are too many; scale it down to %d x %d at most",
                        path, image->width, image->height, AOB_PROBE_MAX_WIDTH, AOB_PROBE_MAX_WIDTH / 2);
    if (image->width != 2 * image->height)
        return aob_fail(error,
                        "%s: no light probe: it is %d x %d texels; an equirectangular image is twice as wide "
                        "as high",
                        path, image->width, image->height);
    return true;
}

/* The planes are in the order of `names`, whatever the file's is. */
static bool check_texels(const struct aob_image *image, float *const planes[3], const char *path,
                         struct aob_error *error)
{
    bool light = false;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++)
            for (int channel = 0; channel < 3; channel++) {
                float value = planes[channel][(size_t)y * (size_t)image->width + (size_t)x];
                if (!isfinite(value) || value < 0)
                    return aob_fail(error,
                                    "%s: no light probe: %s is %g at column %d, row %d (from 0, at the top "
                                    "left); a radiance is finite and not negative: mend that texel",
                                    path, names[channel], (double)value, x, y);
                light = light || value > 0;
            }
    return light ||
           aob_fail(error, "%s: no light probe: every texel is black; take an image that gives light", path);
}

/* Integrals over the azimuths of a column, of products of a = sin and b = -cos, which are x and z at the horizon. */
struct column {
    double one, a, b, ab, aa, bb;
};

static void set_columns(struct column *columns, int width)
{
    for (int i = 0; i < width; i++) {
        double left = 2 * M_PI * i / width - M_PI, right = 2 * M_PI * (i + 1) / width - M_PI;
        double half = (right - left) / 2, bend = (sin(2 * right) - sin(2 * left)) / 4;
        columns[i] = (struct column){
            .one = right - left,
            .a = cos(left) - cos(right),
            .b = sin(left) - sin(right),
            .ab = (sin(left) * sin(left) - sin(right) * sin(right)) / 2,
            .aa = half - bend,
            .bb = half + bend,
        };
    }
}

/* The integral of a row, from those of its columns. */
static struct aob_light_moments row_moments(const struct column *sum, int row, int height)
{
    double top = M_PI * row / height, bottom = M_PI * (row + 1) / height;
    double c = cos(top), d = cos(bottom), s = sin(top), t = sin(bottom);
    double plain = c - d, cosine = (t * t - s * s) / 2, square = (c * c * c - d * d * d) / 3;
    double sine = (bottom - top) / 2 - (sin(2 * bottom) - sin(2 * top)) / 4;
    double both = (t * t * t - s * s * s) / 3, cube = plain - square;
    return (struct aob_light_moments){
        .one = plain * sum->one,
        .x = sine * sum->a,
        .y = cosine * sum->one,
        .z = sine * sum->b,
        .xy = both * sum->a,
        .yz = both * sum->b,
        .xz = cube * sum->ab,
        .xx = cube * sum->aa,
        .yy = square * sum->one,
        .zz = cube * sum->bb,
    };
}

static struct column add_columns(const float *texels, const struct column *columns, int width,
                                 double *squares)
{
    struct column sum = {0};
    *squares = 0;
    for (int i = 0; i < width; i++) {
        double value = texels[i];
        sum.one += value * columns[i].one;
        sum.a += value * columns[i].a;
        sum.b += value * columns[i].b;
        sum.ab += value * columns[i].ab;
        sum.aa += value * columns[i].aa;
        sum.bb += value * columns[i].bb;
        *squares += value * value * columns[i].one;
    }
    return sum;
}

static void project(const struct aob_image *image, float *const planes[3],
                    struct aob_light_projection *projection)
{
    struct column *columns = AOB_NEW_ARRAY(struct column, (size_t)image->width);
    double energy = 0, row[9];
    *projection = (struct aob_light_projection){0};
    set_columns(columns, image->width);
    for (int channel = 0; channel < 3; channel++)
        for (int y = 0; y < image->height; y++) {
            double squares;
            struct column sum = add_columns(planes[channel] + (size_t)y * (size_t)image->width, columns,
                                            image->width, &squares);
            struct aob_light_moments moments = row_moments(&sum, y, image->height);
            aob_light_of_moments(&moments, row);
            for (int k = 0; k < 9; k++)
                projection->light.sh[k][channel] += row[k];
            energy += squares * (cos(M_PI * y / image->height) - cos(M_PI * (y + 1) / image->height));
        }
    free(columns);
    aob_light_window(projection, energy);
}

/* Half floats hold what a technique writes of it. A surface that faces all of the light has 4 times its mean. */
static bool check_scale(const struct aob_light *light, const char *path, struct aob_error *error)
{
    double most = 0;
    for (int channel = 0; channel < 3; channel++)
        most = fmax(most, light->sh[0][channel] * 0.5 / sqrt(M_PI));
    return (most >= AOB_PROBE_LEAST_MEAN && most <= AOB_PROBE_MOST_MEAN) ||
           aob_fail(
               error,
               "%s: no light probe: its mean radiance is %.3g, and techniques write half floats: scale it by "
               "%.1g, so that it lies within %g .. %g",
               path, most, 1 / most, AOB_PROBE_LEAST_MEAN, AOB_PROBE_MOST_MEAN);
}

bool aob_probe_read(const char *path, struct aob_light_projection *projection, struct aob_error *error)
{
    struct aob_image image;
    float *planes[3];
    if (!aob_image_read_layers(&image, path, choose, (void *)(uintptr_t)path, error))
        return false;
    for (int channel = 0; channel < 3; channel++)
        planes[channel] = aob_image_channel(&image, names[channel]);
    bool ok = check_size(&image, path, error) && check_texels(&image, planes, path, error);
    if (ok)
        project(&image, planes, projection);
    ok = ok && check_scale(&projection->light, path, error);
    aob_image_finish(&image);
    return ok;
}
