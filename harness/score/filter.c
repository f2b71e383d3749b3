#include "filter.h"
#include <math.h>
#include <string.h>
#include "base/memory.h"

struct aob_kernel aob_kernel_gauss(int radius, double sigma)
{
    struct aob_kernel kernel = {.radius = radius};
    double sum = 0;
    for (int i = -radius; i <= radius; i++)
        sum += kernel.weight[radius + i] = exp(-0.5 * i * i / (sigma * sigma));
    for (int i = 0; i <= 2 * radius; i++)
        kernel.weight[i] /= sum;
    return kernel;
}

double *aob_filter_plane(const struct aob_score_desc *desc, const float *image)
{
    size_t count = (size_t)desc->width * (size_t)desc->height;
    double *plane = AOB_NEW_ARRAY(double, count);
    for (size_t i = 0; i < count; i++)
        plane[i] = aob_score_is_sky(desc, i) ? 1 : image[i];
    return plane;
}

static int clamp(int value, int high)
{
    return value < 0 ? 0 : value > high ? high : value;
}

/* Sums of a few neighbouring pixels stay in registers over all of a kernel's weights. */
enum { BLOCK = 8 };

static void sum_down(const struct aob_planes *planes, const struct aob_kernel *kernel, const size_t *rows,
                     int count, double *into)
{
    double sum[BLOCK] = {0};
    for (int i = 0; i <= 2 * kernel->radius; i++) {
        const double weight = kernel->weight[i];
        const double *a = planes->a + rows[i], *b = planes->b ? planes->b + rows[i] : NULL;
        if (b)
            for (int k = 0; k < count; k++)
                sum[k] += weight * (a[k] * b[k]);
        else
            for (int k = 0; k < count; k++)
                sum[k] += weight * a[k];
    }
    memcpy(into, sum, (size_t)count * sizeof *sum);
}

static void sum_across(const double *from, const struct aob_kernel *kernel, int count, double *into)
{
    double sum[BLOCK] = {0};
    for (int i = 0; i <= 2 * kernel->radius; i++) {
        const double weight = kernel->weight[i];
        for (int k = 0; k < count; k++)
            sum[k] += weight * from[i + k];
    }
    memcpy(into, sum, (size_t)count * sizeof *sum);
}

/* Down comes first. What repeats beyond an edge is the same before and after it, so no plane is kept between the two.
 */
void aob_filter_down(const struct aob_planes *planes, const struct aob_kernel *kernel, int y, double *column)
{
    size_t rows[2 * AOB_KERNEL_RADIUS_MAX + 1];
    int width = planes->width, whole = width - width % BLOCK;
    double *pixels = column + AOB_KERNEL_RADIUS_MAX;
    for (int i = 0; i <= 2 * kernel->radius; i++)
        rows[i] = (size_t)clamp(y + i - kernel->radius, planes->height - 1) * (size_t)width;
    for (int x = 0; x < whole; x += BLOCK) {
        sum_down(planes, kernel, rows, BLOCK, pixels + x);
        for (int i = 0; i <= 2 * kernel->radius; i++)
            rows[i] += BLOCK;
    }
    sum_down(planes, kernel, rows, width - whole, pixels + whole);
    for (int i = 1; i <= AOB_KERNEL_RADIUS_MAX; i++) {
        pixels[-i] = pixels[0];
        pixels[width - 1 + i] = pixels[width - 1];
    }
}

void aob_filter_across(const double *column, const struct aob_kernel *kernel, int width, double *row)
{
    const double *first = column + AOB_KERNEL_RADIUS_MAX - kernel->radius;
    int whole = width - width % BLOCK;
    for (int x = 0; x < whole; x += BLOCK)
        sum_across(first + x, kernel, BLOCK, row + x);
    sum_across(first + whole, kernel, width - whole, row + whole);
}
