#include "image_change.h"
#include <math.h>
#include <stdint.h>
#include <string.h>
#include "base/memory.h"

static const float *channel(const struct aob_image *image, const char *name)
{
    return aob_image_channel((struct aob_image *)(uintptr_t)image, name);
}

static bool judge_sizes(const struct aob_image *a, const struct aob_image *b, struct aob_error *error)
{
    if (a->width != b->width || a->height != b->height)
        return aob_fail(error, "the images are of different sizes: %dx%d and %dx%d", a->width, a->height,
                        b->width, b->height);
    return (channel(a, "technique.AO") && channel(b, "technique.AO") && channel(a, "Z")) ||
           aob_fail(error, "an image lacks its channel technique.AO or Z");
}

static bool is_sky(const float *z, size_t i)
{
    return !isfinite(z[i]);
}

/* Of the channels that both or one of them have. */
static bool differs(const struct aob_image *a, const struct aob_image *b, const char *name)
{
    const float *x = channel(a, name), *y = channel(b, name), *z = channel(a, "Z");
    if (!x || !y)
        return x != y;
    for (size_t i = 0; i < (size_t)a->width * (size_t)a->height; i++)
        if (!is_sky(z, i) && x[i] != y[i])
            return true;
    return false;
}

bool aob_image_change_measure(struct aob_image_change *change, const struct aob_image *a,
                              const struct aob_image *b, struct aob_error *error)
{
    static const char *const written[] = {"technique.AO", "technique.bent.X", "technique.bent.Y",
                                          "technique.bent.Z"};
    *change = (struct aob_image_change){0};
    if (!judge_sizes(a, b, error))
        return false;
    const float *x = channel(a, written[0]), *y = channel(b, written[0]), *z = channel(a, "Z");
    double squares = 0, beyond = 0;
    for (size_t i = 0; i < (size_t)a->width * (size_t)a->height; i++) {
        if (is_sky(z, i))
            continue;
        double difference = fabs((double)y[i] - x[i]);
        change->max = fmax(change->max, difference);
        squares += difference * difference;
        beyond += difference > 1 / 255.0;
        change->pixels++;
    }
    if (change->pixels) {
        change->rmse = sqrt(squares / (double)change->pixels);
        change->share = beyond / (double)change->pixels;
    }
    for (size_t c = 0; c < AOB_COUNT(written); c++)
        change->moved = change->moved || differs(a, b, written[c]);
    return true;
}

static void copy(struct aob_image *into, const char *name, const float *from)
{
    size_t count = (size_t)into->width * (size_t)into->height;
    memcpy(aob_image_add(into, name), from, count * sizeof *from);
}

bool aob_image_change_write(const struct aob_image *a, const struct aob_image *b, const char *path,
                            struct aob_error *error)
{
    if (!judge_sizes(a, b, error))
        return false;
    struct aob_image map = {.width = a->width, .height = a->height};
    const float *x = channel(a, "technique.AO"), *y = channel(b, "technique.AO"), *z = channel(a, "Z");
    copy(&map, "Z", z);
    copy(&map, "technique.AO", y);
    copy(&map, "reference.AO", x);
    float *difference = aob_image_add(&map, "error.AO");
    for (size_t i = 0; i < (size_t)a->width * (size_t)a->height; i++)
        difference[i] = is_sky(z, i) ? 0 : y[i] - x[i];
    bool ok = aob_image_write(&map, path, error);
    aob_image_finish(&map);
    return ok;
}
