#include "small.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "score/flip.h"
#include "store/image.h"

static size_t pixels_of(const struct aob_small *small)
{
    return (size_t)small->width * (size_t)small->height;
}

/* Sums, and how many surfaces each has. */
static void add(struct aob_small *small, const struct aob_seen *seen, size_t i, int shrink,
                const double rgb[3], int *surfaces)
{
    size_t x = seen->pixel[i] % (size_t)seen->width / (size_t)shrink,
           y = seen->pixel[i] / (size_t)seen->width / (size_t)shrink, p = y * (size_t)small->width + x;
    if (x >= (size_t)small->width || y >= (size_t)small->height)
        return;
    surfaces[p]++;
    for (size_t c = 0; c < 3; c++) {
        small->image[3 * p + c] += (float)rgb[c];
        small->truth[3 * p + c] += seen->surfaces[i].truth[c];
    }
}

void aob_small_init(struct aob_small *small, const struct aob_seen *seen, const struct aob_drawn *drawn,
                    unsigned set, int shrink)
{
    *small = (struct aob_small){.width = seen->width / shrink, .height = seen->height / shrink};
    size_t pixels = pixels_of(small);
    int *surfaces = AOB_NEW_ARRAY(int, pixels + 1);
    small->image = AOB_NEW_ARRAY(float, 3 * pixels + 1);
    small->truth = AOB_NEW_ARRAY(float, 3 * pixels + 1);
    small->depth = AOB_NEW_ARRAY(float, pixels + 1);
    for (size_t i = 0; i < seen->count; i++) {
        double rgb[3];
        aob_drawn_light(seen, drawn, set, i, rgb);
        add(small, seen, i, shrink, rgb, surfaces);
    }
    for (size_t p = 0; p < pixels; p++) {
        small->depth[p] = surfaces[p] ? 1 : INFINITY;
        for (size_t c = 0; c < 3 && surfaces[p]; c++) {
            small->image[3 * p + c] /= (float)surfaces[p];
            small->truth[3 * p + c] /= (float)surfaces[p];
        }
    }
    free(surfaces);
}

void aob_small_finish(struct aob_small *small)
{
    free(small->image);
    free(small->truth);
    free(small->depth);
    *small = (struct aob_small){0};
}

double aob_small_flip(const struct aob_small *small, double exposure)
{
    const struct aob_score_desc desc = {
        .width = small->width, .height = small->height, .depth = small->depth, .sky_depth = 2};
    return pixels_of(small) ? aob_flip_colour(&desc, small->image, small->truth, exposure) : NAN;
}

bool aob_small_write(const struct aob_small *small, const char *path, struct aob_error *error)
{
    static const char *const names[2][3] = {{"technique.lit.R", "technique.lit.G", "technique.lit.B"},
                                            {"reference.lit.R", "reference.lit.G", "reference.lit.B"}};
    struct aob_image file = {.width = small->width, .height = small->height};
    memcpy(aob_image_add(&file, "Z"), small->depth, pixels_of(small) * sizeof(float));
    for (size_t c = 0; c < 3; c++) {
        aob_image_add_part(&file, names[0][c], small->image + c, 3);
        aob_image_add_part(&file, names[1][c], small->truth + c, 3);
    }
    float *off = aob_image_add(&file, "error.lit");
    for (size_t i = 0; i < 3 * pixels_of(small); i++)
        off[i / 3] += (small->image[i] - small->truth[i]) / 3;
    bool ok = aob_image_write(&file, path, error);
    aob_image_finish(&file);
    return ok;
}
