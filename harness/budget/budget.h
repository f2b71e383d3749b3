/* The budget of a frame: what ambient occlusion may take of it. A budget is a YAML file; docs/budget.md says how to write
 * one. */
#ifndef AOB_BUDGET_BUDGET_H
#define AOB_BUDGET_BUDGET_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"

#define AOB_BUDGET_SHELF "budgets" /* where those lie that come with the program (base/shelf.h) */

struct aob_budget {
    char *name; /* of the file, without folder and ending */
    char *path, *title;
    char *source;      /* where its times are from, in a sentence */
    double frame_ms;   /* of the whole frame */
    double rest_ms;    /* that all else in the frame takes, without G-buffer and composite; 0: not known */
    double ao_ms;      /* the slice of ambient occlusion; INFINITY: what the rest leaves */
    double error;      /* that a case may have at most; INFINITY: any */
    int width, height; /* of the picture, pixels; 0: any */
    char *device;      /* the profile that times are modelled on; NULL: this machine's own count */
};

/* Reads a budget by its name or path. False: one line, FILE:LINE:COLUMN where the file is at fault, and nothing to
 * finish. */
bool aob_budget_find(struct aob_budget *budget, const char *name, struct aob_error *error);
void aob_budget_finish(struct aob_budget *budget); /* frees; a zeroed one too */

/* {name, title, source, frame_ms, rest_ms, ao_ms, error, width, height, device}: ao_ms and error "inf" where they are
 * not limited, device null. */
json_t *aob_budget_to_json(const struct aob_budget *budget);

/* False: the object, which may be NULL, is none of these, and there is nothing to finish. */
bool aob_budget_from_json(struct aob_budget *budget, const json_t *object);

/* Milliseconds for ambient occlusion: its slice, or what the frame has left where that is less. `other_ms` is what
 * G-buffer and composite take; 0: not known. It may be 0 or less. */
double aob_budget_left(const struct aob_budget *budget, double other_ms);
#endif
