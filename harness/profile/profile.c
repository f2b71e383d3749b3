#include "profile.h"
#include <stdlib.h>
#include "base/shelf.h"

void aob_profile_fact_finish(struct aob_profile_fact *fact)
{
    free(fact->key);
    free(fact->value);
    free(fact->source);
}

void aob_profile_finish(struct aob_profile *profile)
{
    for (size_t i = 0; i < profile->fact_count; i++)
        aob_profile_fact_finish(&profile->facts[i]);
    free(profile->name);
    free(profile->path);
    free(profile->title);
    *profile = (struct aob_profile){0};
}

bool aob_profile_find(struct aob_profile *profile, const char *name, struct aob_error *error)
{
    char *file = aob_shelf_find(AOB_PROFILE_SHELF, "profile", name, error);
    bool ok = file && aob_profile_read(profile, file, error);
    free(file);
    return ok;
}

const char *aob_layout_name(enum aob_layout layout)
{
    static const char *const names[AOB_LAYOUT_COUNT] = {"linear", "morton", "block_linear"};
    return names[layout];
}
