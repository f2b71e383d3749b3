#include "flip.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "filter.h"

/* The curve of CIE L*a*b* is a cube root with a straight line near black. */
static double lab_curve(double t)
{
    const double delta = 6.0 / 29;
    return t > delta * delta * delta ? cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

static double lightness(double luminance)
{
    return 116 * lab_curve(fmin(fmax(luminance, 0), 1)) - 16;
}

/* L*a*b* of one primary of sRGB at full strength, relative to the white of all three, adjusted after Hunt. */
static void hunt_lab_of_primary(int primary, double lab[3])
{
    static const double xyz[3][3] = {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                     {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                     {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};
    double f[3];
    for (int i = 0; i < 3; i++)
        f[i] = lab_curve(xyz[i][primary] / (xyz[i][0] + xyz[i][1] + xyz[i][2]));
    lab[0] = 116 * f[1] - 16;
    lab[1] = 0.01 * lab[0] * 500 * (f[0] - f[1]);
    lab[2] = 0.01 * lab[0] * 200 * (f[1] - f[2]);
}

static const double colour_exponent = 0.7;

static double largest_difference(void)
{
    double green[3], blue[3];
    hunt_lab_of_primary(1, green);
    hunt_lab_of_primary(2, blue);
    double hyab = fabs(green[0] - blue[0]) + hypot(green[1] - blue[1], green[2] - blue[2]);
    return pow(hyab, colour_exponent);
}

/* Differences up to 0.4 of the largest are spread over 0..0.95. */
static double colour_difference(double hyab, double largest)
{
    const double knee = 0.4 * largest, at_knee = 0.95;
    double e = pow(hyab, colour_exponent);
    return e < knee ? at_knee * e / knee : at_knee + (1 - at_knee) * (e - knee) / (largest - knee);
}

/* The contrast sensitivity of luminance is a Gaussian of frequency, so its filter is one of space. The paper gives all
 * filters the radius of the widest, 10 pixels; of this one, less than 1e-9 of the weight lies farther out than 6. */
static struct aob_kernel sensitivity_kernel(void)
{
    return aob_kernel_gauss(6, sqrt(0.0047 / 2) / 3.14159265358979323846 * AOB_FLIP_PIXELS_PER_DEGREE);
}

static void normalise_signs(struct aob_kernel *kernel)
{
    double positive = 0, negative = 0;
    for (int i = 0; i <= 2 * kernel->radius; i++)
        *(kernel->weight[i] > 0 ? &positive : &negative) += fabs(kernel->weight[i]);
    for (int i = 0; i <= 2 * kernel->radius; i++)
        kernel->weight[i] /= kernel->weight[i] > 0 ? positive : negative;
}

struct kernels {
    struct aob_kernel sensitivity, smooth, edge, point; /* the last three: a Gaussian and its derivatives */
};

static struct kernels make_kernels(void)
{
    const double sigma = 0.5 * 0.082 * AOB_FLIP_PIXELS_PER_DEGREE;
    const int radius = (int)ceil(3 * sigma);
    struct kernels k = {.sensitivity = sensitivity_kernel(), .smooth = aob_kernel_gauss(radius, sigma)};
    k.edge = k.point = k.smooth;
    for (int i = -radius; i <= radius; i++) {
        k.edge.weight[radius + i] *= -i;
        k.point.weight[radius + i] *= i * i / (sigma * sigma) - 1;
    }
    normalise_signs(&k.edge);
    normalise_signs(&k.point);
    return k;
}

/* What is compared of one row of an image. */
struct row {
    double *seen, *edge, *point;
};
/* Memory that the filters use. */
struct scratch {
    double *column, *down;
};

/* `strength` holds a kernel's responses across, and gets the length of the vector of those and the ones down. */
static void add_down(const struct aob_planes *image, const struct aob_kernel *smooth,
                     const struct aob_kernel *kernel, int y, const struct scratch *scratch, double *strength)
{
    aob_filter_down(image, kernel, y, scratch->column);
    aob_filter_across(scratch->column, smooth, image->width, scratch->down);
    for (int x = 0; x < image->width; x++)
        strength[x] = sqrt(strength[x] * strength[x] + scratch->down[x] * scratch->down[x]);
}

static void look(const struct aob_planes *image, const struct kernels *k, int y,
                 const struct scratch *scratch, const struct row *row)
{
    aob_filter_down(image, &k->sensitivity, y, scratch->column);
    aob_filter_across(scratch->column, &k->sensitivity, image->width, row->seen);
    aob_filter_down(image, &k->smooth, y, scratch->column);
    aob_filter_across(scratch->column, &k->edge, image->width, row->edge);
    aob_filter_across(scratch->column, &k->point, image->width, row->point);
    add_down(image, &k->smooth, &k->edge, y, scratch, row->edge);
    add_down(image, &k->smooth, &k->point, y, scratch, row->point);
}

static double pixel_error(const struct row *a, const struct row *b, int x, double largest)
{
    double colour = colour_difference(fabs(lightness(a->seen[x]) - lightness(b->seen[x])), largest);
    double feature = fmax(fabs(a->edge[x] - b->edge[x]), fabs(a->point[x] - b->point[x]));
    return pow(colour, 1 - sqrt(feature / sqrt(2)));
}

static double mean_error(const struct aob_score_desc *desc, const double *image, const double *truth,
                         double *buffer)
{
    size_t width = (size_t)desc->width, count = 0;
    const struct aob_planes one = {image, NULL, desc->width, desc->height},
                            other = {truth, NULL, desc->width, desc->height};
    const struct row a = {buffer, buffer + width, buffer + 2 * width},
                     b = {buffer + 3 * width, buffer + 4 * width, buffer + 5 * width};
    const struct scratch scratch = {buffer + 7 * width, buffer + 6 * width};
    const struct kernels kernels = make_kernels();
    double largest = largest_difference(), sum = 0;
    for (int y = 0; y < desc->height; y++) {
        look(&one, &kernels, y, &scratch, &a);
        look(&other, &kernels, y, &scratch, &b);
        for (int x = 0; x < desc->width; x++)
            if (!aob_score_is_sky(desc, (size_t)y * width + (size_t)x)) {
                sum += pixel_error(&a, &b, x, largest);
                count++;
            }
    }
    return count ? sum / (double)count : NAN;
}

double aob_flip(const struct aob_score_desc *desc)
{
    double *image = aob_filter_plane(desc, desc->image), *truth = aob_filter_plane(desc, desc->truth);
    double *buffer = AOB_NEW_ARRAY(double, 8 * (size_t)desc->width + 2 * AOB_KERNEL_RADIUS_MAX);
    double mean = mean_error(desc, image, truth, buffer);
    free(image);
    free(truth);
    free(buffer);
    return mean;
}
