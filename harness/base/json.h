/* Numbers and vectors in JSON (jansson). JSON has no infinity: it travels as the text "inf"; NAN as null. */
#ifndef AOB_BASE_JSON_H
#define AOB_BASE_JSON_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "error.h"

json_t *aob_json_number(double value);
double aob_json_to_number(const json_t *value); /* NAN unless a number or "inf" */
json_t *aob_json_vector(const double *values, size_t count);
bool aob_json_to_vector(const json_t *array, double *values,
                        size_t count); /* false: the array has not exactly `count` finite numbers */

/* A text from outside, such as a driver's name: as aob_text_add_shown shows it where it is no UTF-8, which JSON cannot
 * hold. */
json_t *aob_json_text(const char *text);

/* A path that means the same wherever its reader works: absolute (as it is where the working folder's name is no
 * UTF-8). NULL gives null. */
json_t *aob_json_path(const char *path);

/* Returns the value as one compact line, with `digits` digits for each real (17 keep a double exactly, 9 a float);
 * free() it. */
char *aob_json_line(const json_t *value, int digits);

/* Writes the value into an open file as one line that keeps doubles exactly. False: it cannot be written, as to a pipe
 * that nobody reads. */
bool aob_json_send(int file, const json_t *value);

/* Writes one indented document into a file, whole or not at all; "-" is standard output. */
bool aob_json_write(const json_t *document, const char *path, struct aob_error *error);

/* Checks that `path` can be written, before the work for the document is done. NULL passes: no document is wanted. */
bool aob_json_check(const char *path, struct aob_error *error);
#endif
