/* The part of a message that says which build of a technique is meant: {name, module, digest}. Texts are borrowed from
 * the JSON that they were read from. */
#ifndef AOB_JOB_ADDRESS_H
#define AOB_JOB_ADDRESS_H
#include <jansson.h>
#include "base/error.h"
#include "technique/registry.h"

json_t *aob_address_to_json(const struct aob_address *address); /* a new object */
bool aob_address_from_json(const json_t *object, struct aob_address *address, struct aob_error *error);
#endif
