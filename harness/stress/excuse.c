#include "groups.h"

const char *aob_excuse_no_divisor(const struct aob_subject *subject)
{
    return aob_subject_has(subject, "divisor") ? NULL : "it has one size only";
}

const char *aob_excuse_no_radius(const struct aob_subject *subject)
{
    return aob_subject_has(subject, "radius") ? NULL : "it has no radius";
}
