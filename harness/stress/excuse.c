#include "groups.h"

const char *aob_excuse_no_divisor(const struct aob_subject *subject)
{
    return aob_subject_has(subject, "divisor") ? NULL : "it has one size only";
}

const char *aob_excuse_no_blur(const struct aob_subject *subject)
{
    return aob_subject_has(subject, "blur") ? NULL : "it has no filter";
}

const char *aob_excuse_no_triangles(const struct aob_subject *subject)
{
    return aob_subject_draws_triangles(subject) ? NULL : "it draws no triangles";
}

const char *aob_excuse_no_radius(const struct aob_subject *subject)
{
    return aob_subject_has(subject, "radius") ? NULL : "it has no radius";
}

const char *aob_excuse_no_bent_normal(const struct aob_subject *subject)
{
    return aob_subject_gives(subject, AOB_OUT_BENT_NORMAL) ? NULL : "it gives no bent normal";
}
