/* Parameter tables and values. A value travels as a double (or a choice's index) until it is packed into the
 * technique's own struct. */
#ifndef AOB_TECHNIQUE_PARAM_H
#define AOB_TECHNIQUE_PARAM_H
#include <aobudget/technique.h>
#include "base/error.h"
#include "base/text.h"

const struct aob_param *aob_param_find(const struct aob_param *params, size_t count,
                                       const char *name); /* or NULL */

/* Whether a value keeps the parameter's rule; aob_param_rule says it: "odd, or 0", NULL where there is none. */
bool aob_param_obeys(const struct aob_param *param, double value);
const char *aob_param_rule(const struct aob_param *param);

/* Strictly: the whole text one number within bounds (whole for an int) that keeps the rule, or one of the choices. The
 * error line says what is allowed; it does not name technique or file. */
bool aob_param_parse(const struct aob_param *param, const char *text, double *value, struct aob_error *error);

/* Shortest text that parses back to the same float or int; a choice by its name. */
void aob_param_print(const struct aob_param *param, double value, struct aob_text *text);

/* A default length is in metres; `metre` says how many scene units stand for one (scene.h). */
void aob_param_defaults(const struct aob_param *params, size_t count, double metre, double *values);

/* Into the struct that the table's offsets index; `size` bytes, zeroed first. */
void aob_param_pack(const struct aob_param *params, size_t count, const double *values, void *into,
                    size_t size);

const char *aob_unit_name(enum aob_unit unit); /* "scene units", "pixels", "rad", "" */
#endif
