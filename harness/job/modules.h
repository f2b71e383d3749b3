/* The part of a message that names the modules to load. Every path in a message that goes with modules is absolute,
 * because a module may change the working folder. Here they are borrowed: of a read message they live as long as its
 * JSON. */
#ifndef AOB_JOB_MODULES_H
#define AOB_JOB_MODULES_H
#include <jansson.h>
#include <stddef.h>

struct aob_modules {
    const char *const *paths; /* `count` of them */
    size_t count;
};
json_t *aob_modules_to_json(const struct aob_modules *modules); /* a new array */

/* What is no text is left out. Allocates; aob_modules_finish frees. */
void aob_modules_from_json(const json_t *array, struct aob_modules *modules);
void aob_modules_finish(struct aob_modules *modules);
#endif
