/* The truth of the light that falls on what a camera sees, in the near field: a surface within the radius blocks a ray
 * and reflects diffusely what falls on it, and a longer ray sees the distant light, whatever stands farther away. */
#ifndef AOB_REFERENCE_INCIDENT_H
#define AOB_REFERENCE_INCIDENT_H
#include "scene/light.h"
#include "tracer.h"

enum { AOB_MOST_BOUNCES = 64 };

struct aob_incident_desc {
    double radius; /* of the near field, scene units, above 0; INFINITY allowed: every surface blocks */
    int bounces;   /* reflections, 0..AOB_MOST_BOUNCES; with 0 what blocks is black */
    const struct aob_light *light; /* world space; NULL: radiance 1 from everywhere */
    int x0, y0, width, height;     /* the part of the hits to compute, the guard band cropped; 0 size: all */
    int spp;                       /* paths a pixel: two independent halves of spp/2; even, 2..65536 */
    uint32_t seed;
};

/* width * height pixels of R, G, B, scene part only; sky pixels are 0 with se 0. */
struct aob_incident {
    float (*rgb)[3]; /* (A+B)/2: irradiance over pi, what a white diffuse surface reflects; radiance's unit */
    float (*se)[3];  /* |A-B|/2: the standard error's estimate of the pixel; pool it as an RMS */
};

/* At each visible point x, about the geometric normal on the camera's side,
 *
 *     I(x) = mean over cosine-distributed directions w of  L(w)            if no surface is met within the radius,
 *                                                          rho(y) I(y)     if one is, at y,
 *
 * where I(y) is about the geometric normal on the side that the ray comes from (both sides of a triangle are alike),
 * with the same radius, and rho(y) is the diffuse albedo, base colour * (1 - metalness), of the triangle's material;
 * what a metal reflects is left out. A path ends in the dark once it has been reflected `bounces` times and is blocked
 * again, so light of more reflections is lost: in a white closed room of which a share p of all directions is blocked,
 * p^(bounces + 1). With 0 bounces and uniform light I is the visibility of the same radius, spp and seed to float
 * rounding, since the first rays are those of aob_tracer_visibility (with cosine terms alone). Each blocked ray goes on
 * as one path, whose directions are independent of all others. Rays from y start as robustly as those from x.
 *
 * Fills *result (its arrays are allocated here; aob_incident_finish frees). False after one line if radius, bounces,
 * light, spp or part is bad; nothing is allocated then. `camera` is the one that cast the hits. The call uses all cores,
 * and gives the same result for any number of threads; the tracer is used by one call at a time. */
bool aob_tracer_incident(const struct aob_tracer *tracer, const struct aob_camera *camera,
                         const struct aob_hits *hits, const struct aob_incident_desc *desc,
                         struct aob_incident *result, struct aob_error *error);
void aob_incident_finish(struct aob_incident *incident);

/* The version is raised when any value could change. It is part of cache keys, beside aob_tracer_version. */
extern const char aob_incident_version[];
#endif
