#include "flip.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "filter.h"
#include "flip_space.h"

enum { OPPONENTS = AOB_FLIP_SPACE_OPPONENTS };
static const double pi = 3.14159265358979323846;

/* One image as it is compared: the plane of its luminance, and where it has colours those of the other two opponents. */
struct picture {
    double *planes;
    int channels; /* 1 or OPPONENTS */
};

static struct picture grey_picture(const struct aob_score_desc *desc, const float *image)
{
    return (struct picture){aob_filter_plane(desc, image), 1};
}

static struct picture colour_picture(const struct aob_score_desc *desc, const float *image, double exposure)
{
    size_t count = (size_t)desc->width * (size_t)desc->height;
    double *planes = AOB_NEW_ARRAY(double, OPPONENTS *count);
    for (size_t i = 0; i < count; i++) {
        double rgb[3] = {1, 1, 1}, opponents[OPPONENTS];
        for (size_t k = 0; k < 3 && !aob_score_is_sky(desc, i); k++)
            rgb[k] = exposure * image[3 * i + k];
        aob_flip_space_opponents(rgb, opponents);
        for (size_t k = 0; k < OPPONENTS; k++)
            planes[k * count + i] = opponents[k];
    }
    return (struct picture){planes, OPPONENTS};
}

static double difference(double hyab)
{
    return pow(hyab, 0.7);
}

/* Differences up to 0.4 of the largest are spread over 0..0.95. */
static double colour_difference(double hyab, double largest)
{
    const double knee = 0.4 * largest, at_knee = 0.95;
    double e = difference(hyab);
    return e < knee ? at_knee * e / knee : at_knee + (1 - at_knee) * (e - knee) / (largest - knee);
}

/* The filter of an opponent: a Gaussian, or the mean of two, of which the second has that share. */
struct sensitivity {
    struct aob_kernel kernel, second;
    double share; /* 0: there is no second */
};

/* Contrast sensitivity is a Gaussian of frequency f, exp(-b f^2), so its filter is one of space, exp(-pi^2 d^2 / b). */
static struct aob_kernel sensitivity_kernel(int radius, double b)
{
    return aob_kernel_gauss(radius, sqrt(b / 2) / pi * AOB_FLIP_PIXELS_PER_DEGREE);
}

/* The weight of one term over the square that the filter covers. The paper scales a term by a sqrt(pi / b), which is
 * the transform's factor in one dimension, and applies it in two. A kernel's middle is 1 over its sum before that was
 * made 1. */
static double term_weight(double a, double b, const struct aob_kernel *kernel)
{
    double middle = kernel->weight[kernel->radius];
    return a * sqrt(pi / b) / (middle * middle);
}

/* The paper gives all filters the radius of the widest, 10 pixels. Of that of luminance less than 1e-9 of the weight
 * lies farther out than 6, and of that of Cx less than 1e-10 farther out than 7. */
static void make_sensitivities(struct sensitivity sensitivity[OPPONENTS])
{
    const double a[2] = {34.1, 13.5}, b[2] = {0.04, 0.025};
    sensitivity[0] = (struct sensitivity){.kernel = sensitivity_kernel(6, 0.0047)};
    sensitivity[1] = (struct sensitivity){.kernel = sensitivity_kernel(7, 0.0053)};
    sensitivity[2] = (struct sensitivity){sensitivity_kernel(10, b[0]), sensitivity_kernel(10, b[1]), 0};
    double first = term_weight(a[0], b[0], &sensitivity[2].kernel),
           second = term_weight(a[1], b[1], &sensitivity[2].second);
    sensitivity[2].share = second / (first + second);
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
    struct sensitivity sensitivity[OPPONENTS];
    struct aob_kernel smooth, edge, point; /* a Gaussian and its derivatives */
};

static struct kernels make_kernels(void)
{
    const double sigma = 0.5 * 0.082 * AOB_FLIP_PIXELS_PER_DEGREE;
    const int radius = (int)ceil(3 * sigma);
    struct kernels k = {.smooth = aob_kernel_gauss(radius, sigma)};
    make_sensitivities(k.sensitivity);
    k.edge = k.point = k.smooth;
    for (int i = -radius; i <= radius; i++) {
        k.edge.weight[radius + i] *= -i;
        k.point.weight[radius + i] *= i * i / (sigma * sigma) - 1;
    }
    normalise_signs(&k.edge);
    normalise_signs(&k.point);
    return k;
}

/* What is compared of one row of an image; a grey has seen[0] alone. */
struct row {
    double *seen[OPPONENTS], *edge, *point;
};
/* Memory that the filters use. */
struct scratch {
    double *column, *down;
};
enum { ROW_PARTS = OPPONENTS + 2, SCRATCH_PARTS = 2 };

static struct row divide_row(double *buffer, size_t width)
{
    struct row row = {.edge = buffer + OPPONENTS * width, .point = buffer + (OPPONENTS + 1) * width};
    for (size_t k = 0; k < OPPONENTS; k++)
        row.seen[k] = buffer + k * width;
    return row;
}

static void filter_seen(const struct aob_planes *plane, const struct sensitivity *s, int y,
                        const struct scratch *scratch, double *seen)
{
    aob_filter_down(plane, &s->kernel, y, scratch->column);
    aob_filter_across(scratch->column, &s->kernel, plane->width, seen);
    if (s->share == 0)
        return;
    aob_filter_down(plane, &s->second, y, scratch->column);
    aob_filter_across(scratch->column, &s->second, plane->width, scratch->down);
    for (int x = 0; x < plane->width; x++)
        seen[x] = (1 - s->share) * seen[x] + s->share * scratch->down[x];
}

/* `strength` holds a kernel's responses across, and gets the length of the vector of those and the ones down. */
static void add_down(const struct aob_planes *image, const struct aob_kernel *smooth,
                     const struct aob_kernel *kernel, int y, const struct scratch *scratch, double *strength)
{
    aob_filter_down(image, kernel, y, scratch->column);
    aob_filter_across(scratch->column, smooth, image->width, scratch->down);
    for (int x = 0; x < image->width; x++)
        strength[x] = sqrt(strength[x] * strength[x] + scratch->down[x] * scratch->down[x]);
}

/* Edges and points are features of the luminance. */
static void filter_features(const struct aob_planes *luminance, const struct kernels *k, int y,
                            const struct scratch *scratch, const struct row *row)
{
    aob_filter_down(luminance, &k->smooth, y, scratch->column);
    aob_filter_across(scratch->column, &k->edge, luminance->width, row->edge);
    aob_filter_across(scratch->column, &k->point, luminance->width, row->point);
    add_down(luminance, &k->smooth, &k->edge, y, scratch, row->edge);
    add_down(luminance, &k->smooth, &k->point, y, scratch, row->point);
}

static void look(const struct aob_score_desc *desc, const struct picture *picture, const struct kernels *k,
                 int y, const struct scratch *scratch, const struct row *row)
{
    size_t count = (size_t)desc->width * (size_t)desc->height;
    struct aob_planes plane = {picture->planes, NULL, desc->width, desc->height};
    filter_features(&plane, k, y, scratch, row);
    for (int i = 0; i < picture->channels; i++, plane.a += count)
        filter_seen(&plane, &k->sensitivity[i], y, scratch, row->seen[i]);
}

static void seen_lab(const struct row *row, int channels, int x, double lab[3])
{
    if (channels == 1) {
        aob_flip_space_lab_of_grey(row->seen[0][x], lab);
        return;
    }
    const double opponents[OPPONENTS] = {row->seen[0][x], row->seen[1][x], row->seen[2][x]};
    aob_flip_space_lab(opponents, lab);
}

static double pixel_error(const struct row *a, const struct row *b, int channels, int x, double largest)
{
    double lab_a[3], lab_b[3];
    seen_lab(a, channels, x, lab_a);
    seen_lab(b, channels, x, lab_b);
    double colour = colour_difference(aob_flip_space_hyab(lab_a, lab_b), largest);
    double feature = fmax(fabs(a->edge[x] - b->edge[x]), fabs(a->point[x] - b->point[x]));
    return pow(colour, 1 - sqrt(feature / sqrt(2)));
}

/* Two pictures of the same channels. */
static double mean_error(const struct aob_score_desc *desc, const struct picture *image,
                         const struct picture *truth, double *buffer)
{
    size_t width = (size_t)desc->width, count = 0;
    const struct row a = divide_row(buffer, width), b = divide_row(buffer + ROW_PARTS * width, width);
    const struct scratch scratch = {.down = buffer + 2 * ROW_PARTS * width,
                                    .column = buffer + (2 * ROW_PARTS + 1) * width};
    const struct kernels kernels = make_kernels();
    double largest = difference(aob_flip_space_largest()), sum = 0;
    for (int y = 0; y < desc->height; y++) {
        look(desc, image, &kernels, y, &scratch, &a);
        look(desc, truth, &kernels, y, &scratch, &b);
        for (int x = 0; x < desc->width; x++)
            if (!aob_score_is_sky(desc, (size_t)y * width + (size_t)x)) {
                sum += pixel_error(&a, &b, image->channels, x, largest);
                count++;
            }
    }
    return count ? sum / (double)count : NAN;
}

/* Frees the planes of both. */
static double compare(const struct aob_score_desc *desc, struct picture image, struct picture truth)
{
    size_t parts = 2 * ROW_PARTS + SCRATCH_PARTS;
    double *buffer = AOB_NEW_ARRAY(double, parts *(size_t)desc->width + 2 * AOB_KERNEL_RADIUS_MAX);
    double mean = mean_error(desc, &image, &truth, buffer);
    free(image.planes);
    free(truth.planes);
    free(buffer);
    return mean;
}

double aob_flip(const struct aob_score_desc *desc)
{
    return compare(desc, grey_picture(desc, desc->image), grey_picture(desc, desc->truth));
}

double aob_flip_colour(const struct aob_score_desc *desc, const float *image, const float *truth,
                       double exposure)
{
    return compare(desc, colour_picture(desc, image, exposure), colour_picture(desc, truth, exposure));
}
