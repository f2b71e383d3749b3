/* The truth of the lit image in the near field: what a surface reflects to the camera of the light that reaches it past what is
 * within the radius, and of what that reflects. It is made of the truths of incident and of mirrored light. */
#ifndef AOB_REFERENCE_LIT_H
#define AOB_REFERENCE_LIT_H
#include "incident.h"

/* At each visible point, with the material of its triangle,
 *
 *     (1 - metalness) * base colour * I + S,
 *
 * I as aob_tracer_incident has it, and S the reflected radiance of aob_tracer_specular at the material's roughness, with
 * Schlick's factor. Both see the same light, radius and number of reflections. Diffuse and mirrored light are added up, as the
 * composite does (technique/composite.h): energy is not shared between them.
 *
 * Takes the description of incident light; fills *result as aob_tracer_incident does, in the light's unit of radiance. The
 * standard error is the root of the sum of both parts' squares: they have directions of their own. Sky is 0. False after one
 * line if the description is bad; nothing is allocated then. */
bool aob_tracer_lit(const struct aob_tracer *tracer, const struct aob_camera *camera,
                    const struct aob_hits *hits, const struct aob_incident_desc *desc,
                    struct aob_incident *result, struct aob_error *error);

/* The version is raised when the sum could change; those of its parts count beside it. It is part of cache keys. */
extern const char aob_lit_version[];
#endif
