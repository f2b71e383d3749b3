/* The modules that a job loads to see what is in them. Their paths are absolute in its message, because a module may
 * change the working folder. They are borrowed: of a read message they live as long as its JSON. */
#ifndef AOB_JOB_MODULES_H
#define AOB_JOB_MODULES_H
#include <jansson.h>
#include <stddef.h>

struct aob_modules {
    const char *const *paths; /* as the current folder sees them */
    const char *const *names; /* each as the user wrote it, no two alike; of a read message NULL */
    size_t count;
    size_t
        offered; /* so many of the first stand in where a technique is named without its module: those of --module */
};
json_t *aob_modules_to_json(const struct aob_modules *modules); /* a new array, of the paths */

/* What is no text is left out. Allocates; aob_modules_finish frees. */
void aob_modules_from_json(const json_t *array, struct aob_modules *modules);
void aob_modules_finish(struct aob_modules *modules);
#endif
