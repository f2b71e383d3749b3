/* One image that a case is compared with, as it travels between processes: {radius, uniform, falloff, of_triangle, screen,
 * bent, output, bounces, light}. `screen` is there for what is traced against the screen-space bound only, `bent` where the mean
 * open direction is wanted too, `output` for the truth of another output than visibility, `light` for one that depends on
 * it. The text of this object, keys in this order, is a part of the name of the cached file, so the run hands it on as it
 * is. */
#ifndef AOB_JOB_TERM_H
#define AOB_JOB_TERM_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "scene/light.h"
#include "technique/graph.h"

struct aob_term {
    double radius; /* scene units; INFINITY allowed */
    bool uniform,
        of_triangle;      /* weighting of directions; how the distance of an occluder is meant (tracer.h) */
    const float *falloff; /* what an occluder counts, over the root of its share of the radius; NULL: 1 */
    size_t falloff_count; /* rows of that table, 2 or more */
    bool bent;            /* the mean open direction is wanted too: channels B.X B.Y B.Z of its file */
    bool bound;           /* traced against the screen-space bound, */
    double thickness;     /* whose surfaces are so thick; 0: thin, INFINITY: as far as they go */
    /* Whose truth it is. Of visibility after bounces, specular, irradiance and the lit image only the radius counts besides: their
     * files have the channels R G B (specular: R) and SE.R SE.G SE.B (SE.R). Irradiance and lit image are those of `light`. */
    enum aob_output output;
    int bounces;            /* of visibility after bounces and of the lit image: how many reflections count */
    struct aob_light light; /* world space */
};
enum { AOB_TRUTH_BOUNCES = 8 }; /* that a run asks for */

/* Whether one set of rays serves both: same weighting, distance and surface. A cosine term that is traced beside a
 * uniform one has other noise, and a cached file must not depend on what else was wanted when it was made. */
bool aob_term_same_trace(const struct aob_term *a, const struct aob_term *b);

/* Whether `light` decides it. */
bool aob_term_has_light(const struct aob_term *term);

json_t *aob_term_to_json(const struct aob_term *term); /* a new object */
void aob_term_set_bound(json_t *term, double thickness);

/* False with a line unless it has a radius above 0, a known output, and tables of numbers where there are any. Allocates the table;
 * aob_term_finish frees it. */
bool aob_term_from_json(const json_t *object, struct aob_term *term, struct aob_error *error);
void aob_term_finish(struct aob_term *term);

/* What an occluder at a share t of the radius counts, t in [0, 1]; linear in the root of t between the rows. */
double aob_term_falloff(const struct aob_term *term, double t);
#endif
