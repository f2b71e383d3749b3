#include "figure.h"
#include "base/memory.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What one image asks for. */
struct wish {
    const char *group, *image, *channel;
    double limit;
};

static int by_float(const void *a, const void *b)
{
    float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

static int by_limit(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The 99.5th percentile of |error|; 0 if no pixel is finite. */
static double percentile(const float *pixels, size_t count)
{
    float *sizes = AOB_NEW_ARRAY(float, count);
    size_t used = 0;
    for (size_t i = 0; i < count; i++)
        if (isfinite(pixels[i]))
            sizes[used++] = fabsf(pixels[i]);
    qsort(sizes, used, sizeof *sizes, by_float);
    double value = used ? (double)sizes[(size_t)(0.995 * (double)(used - 1))] : 0;
    free(sizes);
    return value;
}

/* The next round number, at least 0.01. */
static double round_up(double value)
{
    static const double steps[] = {1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10};
    if (!(value > 0.01))
        return 0.01;
    double power = pow(10, floor(log10(value)));
    for (size_t i = 0; i < AOB_COUNT(steps); i++)
        if (value <= steps[i] * power * (1 + 1e-6))
            return steps[i] * power;
    return 10 * power;
}

static struct wish wish_of(const json_t *figure)
{
    const char *channel = json_string_value(json_object_get(figure, "error"));
    return (struct wish){json_string_value(json_object_get(figure, "limit_group")),
                         json_string_value(json_object_get(figure, "image")), channel ? channel : "error.AO",
                         0};
}

static bool is_known(const struct wish *wishes, size_t count, const struct wish *w)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(wishes[i].group, w->group) == 0 && strcmp(wishes[i].image, w->image) == 0 &&
            strcmp(wishes[i].channel, w->channel) == 0)
            return true;
    return false;
}

static bool measure(struct wish *w)
{
    struct aob_image image;
    if (!aob_image_read(&image, w->image, NULL))
        return false;
    const float *pixels = aob_image_channel(&image, w->channel);
    if (pixels)
        w->limit = percentile(pixels, (size_t)image.width * (size_t)image.height);
    aob_image_finish(&image);
    return pixels != NULL;
}

/* The median rather than the largest: one technique that is wrong everywhere must not bleach all others. */
static double limit_of(const struct wish *wishes, size_t count, const char *group)
{
    double *limits = AOB_NEW_ARRAY(double, count);
    size_t used = 0;
    for (size_t i = 0; i < count; i++)
        if (strcmp(wishes[i].group, group) == 0)
            limits[used++] = wishes[i].limit;
    qsort(limits, used, sizeof *limits, by_limit);
    double limit = round_up(used ? limits[used / 2] : 0);
    free(limits);
    return limit;
}

void aob_figure_limits(json_t *figures)
{
    struct wish *wishes = NULL;
    size_t count = 0, capacity = 0, i;
    json_t *figure;
    json_array_foreach(figures, i, figure)
    {
        struct wish w = wish_of(figure);
        if (w.group && w.image && !is_known(wishes, count, &w) && measure(&w))
            *AOB_PUSH(wishes, count, capacity) = w;
    }
    json_array_foreach(figures, i, figure)
    {
        const char *group = wish_of(figure).group;
        if (group)
            json_object_set_new(figure, "limit", json_real(limit_of(wishes, count, group)));
    }
    free(wishes);
}
