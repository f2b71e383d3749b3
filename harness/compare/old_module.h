/* The old module of a stored run, beside which a new build of it is measured. */
#ifndef AOB_COMPARE_OLD_MODULE_H
#define AOB_COMPARE_OLD_MODULE_H
#include <jansson.h>
#include "compare.h"

struct aob_old_module { /* zero it first; aob_old_module_finish frees */
    char *name;         /* of the module, as the run's records have it */
    char *file;         /* the same as the current folder sees it */
    bool in_config;     /* the run's config names it; else it was a --module */
    char *place;        /* where the config lay, and the copy that the run has of it; NULL: there is none */
    char *copy;
    json_t *records; /* of the module's techniques that the new one has */
};

/* Of the run sides[0], for the module sides[1]: the one that its records call `module`; NULL: the first that has a technique of
 * a name that sides[1] has. False after a line if the run has none of its techniques from a module, has
 * no copy of its config where none is given, or if the old module's file is not there any more or is another build now. */
bool aob_old_module_find(struct aob_old_module *stored, const struct aob_compare_desc *desc,
                         const char *module, struct aob_error *error);
void aob_old_module_finish(struct aob_old_module *stored);
#endif
