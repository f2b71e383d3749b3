#include "figure.h"
#include "base/memory.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What one image asks for. */
struct wish {
    const char *group, *image, *truth, *channel;
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

double aob_figure_percentile(const float *pixels, size_t count)
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
    return (struct wish){aob_figure_text(figure, "limit_group", NULL), aob_figure_text(figure, "image", NULL),
                         aob_figure_text(figure, "reference_image", ""),
                         aob_figure_text(figure, "error", "error.AO"), 0};
}

static bool is_known(const struct wish *wishes, size_t count, const struct wish *w)
{
    for (size_t i = 0; i < count; i++)
        if (strcmp(wishes[i].group, w->group) == 0 && strcmp(wishes[i].image, w->image) == 0 &&
            strcmp(wishes[i].truth, w->truth) == 0 && strcmp(wishes[i].channel, w->channel) == 0)
            return true;
    return false;
}

static bool measure(struct wish *w, const json_t *figure, struct aob_figure_cache *cache)
{
    struct aob_figure_image from;
    if (!aob_figure_image_load(&from, cache, figure, NULL) || !from.error)
        return false;
    w->limit = aob_figure_percentile(from.error, (size_t)from.image->width * (size_t)from.image->height);
    return true;
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
    struct aob_figure_cache cache = {0};
    json_t *figure;
    json_array_foreach(figures, i, figure)
    {
        struct wish w = wish_of(figure);
        if (w.group && w.image && !is_known(wishes, count, &w) && measure(&w, figure, &cache))
            *AOB_PUSH(wishes, count, capacity) = w;
    }
    json_array_foreach(figures, i, figure)
    {
        const char *group = wish_of(figure).group;
        if (group)
            json_object_set_new(figure, "limit", json_real(limit_of(wishes, count, group)));
    }
    aob_figure_cache_finish(&cache);
    free(wishes);
}
