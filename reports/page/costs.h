/* What a record says that its case costs a frame. The three columns answer three questions, so none stands for another:
 * time measured here, time in frames of `none` measured here, and time modelled on a named device. */
#ifndef AOB_REPORTS_PAGE_COSTS_H
#define AOB_REPORTS_PAGE_COSTS_H
#include <jansson.h>
#include <stdbool.h>

struct aob_interval {
    double at, low, high; /* at NAN: not known; low 0, high INFINITY: no interval is known */
};

/* Milliseconds by the clock that the case is judged by: processor time on a software driver, the device's own on a GPU that
 * has one, else wall time. NAN: not known. `time` is the record's member and may be NULL. */
double aob_costs_ms(const json_t *time);
const char *aob_costs_clock(const json_t *time);  /* "processor time", "device time", "wall time" */
const char *aob_costs_member(const json_t *time); /* of `time` and of its passes: "cpu_ms" */

/* The same with an interval of 95 %: as far about it, as a share, as the interval of its ratio to the fixed pass. */
struct aob_interval aob_costs_measured(const json_t *record);

/* In frames of `none`, whose record is given (NULL: not known): the quotient of both ratios to the fixed pass. */
struct aob_interval aob_costs_to_none(const json_t *record, const json_t *none);

/* Modelled milliseconds on a profile: the point and its band (docs/model.md). */
struct aob_interval aob_costs_modelled(const json_t *record, const char *profile);

/* The figures that the model gives a record on a profile: {frame, passes}; NULL: none. */
const json_t *aob_costs_model(const json_t *record, const char *profile);

/* How far an image is from a target, of an entry of `errors`: RMSE where the target is occluded, over all pixels if it is so
 * nowhere. NAN: not known. */
double aob_costs_error(const json_t *entry);
#endif
