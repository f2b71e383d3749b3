/* Which techniques and backends the flags --technique, --backend and --module mean. Threads: pure functions. */
#ifndef AOB_STRESS_CHOSEN_H
#define AOB_STRESS_CHOSEN_H
#include "base/text.h"
#include "gpu/gpu.h"
#include "job/modules.h"
#include "technique/registry.h"

struct aob_chosen {
    const struct aob_technique_list *techniques;
    const struct aob_modules *modules;
    const char *technique, *backend; /* NULL: all */
};
/* Whether there are such a technique and such a backend; else one line. */
bool aob_chosen_check(const struct aob_chosen *chosen, struct aob_error *error);

/* Modules that are given are what is meant, unless a technique is named. */
bool aob_chosen_technique(const struct aob_chosen *chosen, const struct aob_technique_info *technique);

/* Without a name, all that draw. */
bool aob_chosen_backend(const struct aob_chosen *chosen, const char *backend);

/* "aobudget stress --technique T --backend B --module 'FILE.so' --device 'NAME'": how a line begins that asks one subject again.
 * What is NULL is left out; the rest of the line is the caller's. */
void aob_chosen_command(const struct aob_technique_info *technique, const char *backend, const char *device,
                        struct aob_text *text);
#endif
