/* The groups of properties, one file each. Each array ends with a row without a name. */
#ifndef AOB_STRESS_GROUPS_H
#define AOB_STRESS_GROUPS_H
#include "property.h"

extern const struct aob_property aob_properties_projection[], aob_properties_numbers[], aob_properties_near[],
    aob_properties_normals[], aob_properties_resolution[], aob_properties_edges[], aob_properties_halos[],
    aob_properties_faces[], aob_properties_relations[], aob_properties_directions[], aob_properties_light[],
    aob_properties_time[], aob_properties_thrift[], aob_properties_instruments[];

/* Excuses that several groups have. */
const char *aob_excuse_no_divisor(const struct aob_subject *subject);
const char *aob_excuse_no_blur(const struct aob_subject *subject);
const char *aob_excuse_no_triangles(const struct aob_subject *subject);
const char *aob_excuse_no_radius(const struct aob_subject *subject);
const char *aob_excuse_no_bent_normal(const struct aob_subject *subject);
const char *aob_excuse_no_bounces(const struct aob_subject *subject);
const char *aob_excuse_no_specular(const struct aob_subject *subject);
const char *aob_excuse_no_irradiance(const struct aob_subject *subject);
const char *aob_excuse_no_effects(const struct aob_subject *subject);
const char *aob_excuse_no_history(const struct aob_subject *subject);
#endif
