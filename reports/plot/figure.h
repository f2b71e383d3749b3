/* Figures as JSON objects, drawn by the viz library. A job for aobudget-plot is {"figures": [FIGURE...]}; each has
 *   kind                  "map" | "triptych" | "split" | "height" | "chart" | "vti"
 *   out                   path of the file to write; a chart's must end in .svg or .png
 *   title, subtitle       all but vti; may be left out
 *   image                 path of an EXR file: all but chart
 *   technique, reference, error
 *                         names of its channels; default technique.AO, reference.AO, error.AO
 *   reference_image       path of another EXR file: its channel AO takes the place of the image's reference, and the error
 *                         is the technique less that, 0 where the image's Z is infinite. All but chart
 *   colour                true: technique and reference are three channels each of the image, NAME.R NAME.G NAME.B, linear,
 *                         drawn as sRGB, the sky grey, and their headings say the exposure. triptych; not with
 *                         reference_image
 *   exposure              what colours are multiplied by; default: the power of two that takes the reference's 99.5th
 *                         percentile, of each pixel's largest channel, to above 1/2 and at most 1
 *   quantity              what the error is of, for the label of its colours; default AO. map, triptych
 *   amount                the unit of a channel "error" that is no error but an amount from 0 up: map, vti. The .vti has
 *                         that channel only
 *   limit                 where the colours end, or
 *   limit_group           a name: figures of one name share one limit, a round number near the median of their
 *                         images' 99.5th percentiles of |error|. map, triptych, split, height
 *   parts                 three headings of a split
 *   alone                 true: the technique without reference and error, where there are none. triptych, vti
 *   technique_name, reference_name
 *                         headings of a triptych
 *   x, y                  {"label": TEXT, "log": BOOL}: chart
 *   series                [{"name": TEXT, "style": "curve" | "points" | "front", "colour": NUMBER, "x": [...],
 *                         "y": [...], "low": [...], "high": [...]}]: chart; null leaves a point out
 * A split needs definition.AO and screen.AO in the image; a .vti has the parts where they are there. */
#ifndef AOB_REPORTS_PLOT_FIGURE_H
#define AOB_REPORTS_PLOT_FIGURE_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "figure_image.h"

/* Gives every figure with a limit_group its limit. An image that cannot be read does not take part. */
void aob_figure_limits(json_t *figures);

/* The 99.5th percentile of the absolute values that are finite; 0 if there is none. */
double aob_figure_percentile(const float *pixels, size_t count);

bool aob_figure_draw(const json_t *figure, struct aob_figure_cache *cache, struct aob_error *error);
#endif
