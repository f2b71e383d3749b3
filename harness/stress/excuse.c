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

const char *aob_excuse_no_bounces(const struct aob_subject *subject)
{
    return aob_subject_gives(subject, AOB_OUT_VISIBILITY_RGB) ? NULL : "it gives no visibility after bounces";
}

const char *aob_excuse_no_specular(const struct aob_subject *subject)
{
    return aob_subject_gives(subject, AOB_OUT_SPECULAR) ? NULL : "it gives no specular occlusion";
}

const char *aob_excuse_no_irradiance(const struct aob_subject *subject)
{
    return aob_subject_gives(subject, AOB_OUT_IRRADIANCE) ? NULL : "it gives no irradiance";
}

const char *aob_excuse_no_effects(const struct aob_subject *subject)
{
    bool any = aob_subject_gives(subject, AOB_OUT_VISIBILITY_RGB) ||
               aob_subject_gives(subject, AOB_OUT_SPECULAR) || aob_subject_gives(subject, AOB_OUT_IRRADIANCE);
    return any ? NULL : "it gives no light, nor a share of it, besides visibility";
}

const char *aob_excuse_no_history(const struct aob_subject *subject)
{
    return aob_subject_has(subject, "history") ? NULL : "it keeps no history";
}
