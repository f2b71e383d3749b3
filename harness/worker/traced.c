#include "traced.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "store/image.h"

static float *copy_channel(const struct aob_image *image, const char *name, size_t count)
{
    const float *channel = aob_image_channel(image, name);
    float *pixels = channel ? AOB_NEW_ARRAY(float, count) : NULL;
    if (channel)
        memcpy(pixels, channel, count * sizeof *pixels);
    return pixels;
}

void aob_traced_finish(struct aob_traced *traced)
{
    free(traced->ao);
    free(traced->se);
    free(traced->open);
    *traced = (struct aob_traced){0};
}

bool aob_traced_load(const char *path, const struct aob_block *block, bool bent, struct aob_traced *traced,
                     struct aob_error *error)
{
    static const char *const names[3] = {"B.X", "B.Y", "B.Z"};
    struct aob_image image = {0};
    const struct aob_job_view *view = &block->job.drawing.view;
    size_t count = (size_t)view->width * (size_t)view->height;
    if (!aob_image_read(&image, path, error))
        return false;
    bool fits = image.width == view->width && image.height == view->height;
    if (fits)
        *traced = (struct aob_traced){copy_channel(&image, "AO", count), copy_channel(&image, "SE", count),
                                      bent ? (float(*)[3])aob_image_interleaved(&image, names, 3, 3) : NULL};
    aob_image_finish(&image);
    return (traced->ao && traced->se && (!bent || traced->open)) ||
           aob_fail(error, "%s: not a reference of %dx%d", path, view->width, view->height);
}
