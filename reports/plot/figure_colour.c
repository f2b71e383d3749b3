#include "figure_colour.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "base/memory.h"
#include "figure.h"

static bool take_picture(struct aob_viz_picture *picture, const struct aob_figure_image *from,
                         const json_t *figure, const char *role, struct aob_error *error)
{
    const char *name = aob_figure_text(figure, role, "?");
    picture->depth = aob_image_channel(from->image, "Z"); /* the sky is not judged */
    for (int c = 0; c < 3; c++) {
        char channel[80];
        snprintf(channel, sizeof channel, "%.64s.%c", name, "RGB"[c]);
        picture->channels[c] = aob_image_channel(from->image, channel);
        if (!picture->channels[c])
            return aob_fail(error, "%s: has no channel %s", aob_figure_text(figure, "image", "?"), channel);
    }
    return true;
}

/* The largest channel of each pixel where there is a surface. */
static double bright_end(const struct aob_viz_picture *picture, const struct aob_image *image)
{
    const float *z = picture->depth;
    size_t count = (size_t)image->width * (size_t)image->height;
    float *largest = AOB_NEW_ARRAY(float, count);
    for (size_t i = 0; i < count; i++) {
        largest[i] = z && isinf(z[i]) ? NAN : picture->channels[0][i];
        for (int c = 1; c < 3 && isfinite(largest[i]); c++)
            largest[i] = fmaxf(largest[i], picture->channels[c][i]);
    }
    double end = aob_figure_percentile(largest, count);
    free(largest);
    return end;
}

/* Whole stops, so that images of nearly the same truth have the same. */
static double exposure_of(const struct aob_viz_picture *picture, const struct aob_image *image)
{
    double end = bright_end(picture, image);
    return end > 1e-6 && end < 1e6 ? exp2(-ceil(log2(end) - 1e-6)) : 1;
}

bool aob_figure_take_colours(struct aob_viz_triptych *triptych, const struct aob_figure_image *from,
                             const json_t *figure, struct aob_error *error)
{
    bool alone = json_is_true(json_object_get(figure, "alone"));
    const json_t *given = json_object_get(figure, "exposure");
    if (!take_picture(&triptych->technique, from, figure, "technique", error) ||
        (!alone && !take_picture(&triptych->reference, from, figure, "reference", error)))
        return false;
    triptych->exposure = given
                             ? json_number_value(given)
                             : exposure_of(alone ? &triptych->technique : &triptych->reference, from->image);
    return true;
}
