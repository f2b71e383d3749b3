/* The channels of a figure's image: of one file, or of two where the truth lies in another. */
#ifndef AOB_REPORTS_PLOT_FIGURE_IMAGE_H
#define AOB_REPORTS_PLOT_FIGURE_IMAGE_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "store/image.h"

/* The files read last, since the next figure often shows them again: the image and the truth. Zero it first. */
struct aob_figure_cache {
    struct {
        char *path;
        struct aob_image image;
    } files[2];
    float *error; /* technique less the truth of the other file, for the figure in hand */
};
void aob_figure_cache_finish(struct aob_figure_cache *cache);

/* Valid until the next figure. `technique`, `reference` and `error` are NULL where the image has no such channel. */
struct aob_figure_image {
    const struct aob_image *image;
    const float *technique, *reference, *error;
};

/* From the figure's members image, reference_image, technique, reference and error (figure.h). False with a line where a
 * file cannot be read, has no truth, or is of another size. */
bool aob_figure_image_load(struct aob_figure_image *from, struct aob_figure_cache *cache,
                           const json_t *figure, struct aob_error *error);

/* The text member, or `otherwise`. */
const char *aob_figure_text(const json_t *object, const char *name, const char *otherwise);
#endif
