/* The defaults of parameters and run options, as a record writes values, and what is at its default. */
#ifndef AOB_TECHNIQUE_USUAL_H
#define AOB_TECHNIQUE_USUAL_H
#include <jansson.h>
#include <stdbool.h>

/* Of a technique's parameters; `technique` is an entry of run.json's list. decref it. A length is {"metres": number}, since
 * its value depends on the scene: aob_usual_is compares one of these with a value of a record. */
json_t *aob_usual_params(const json_t *technique);
json_t *aob_usual_options(void); /* of the run options; decref it */

/* Whether `value`, of a record in whose scene `metre` units stand for a metre (NAN: one), is the default `usual`. */
bool aob_usual_is(const json_t *usual, const json_t *value, double metre);

/* Whether two values of a record are the same: a float's text is its shortest, so the last bits may differ. */
bool aob_usual_same(const json_t *a, const json_t *b);
#endif
