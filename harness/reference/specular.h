/* The truth of specular occlusion in the near field: how much of what a rough mirror reflects to the camera is open, and
 * what light it reflects. */
#ifndef AOB_REFERENCE_SPECULAR_H
#define AOB_REFERENCE_SPECULAR_H
#include "incident.h"

struct aob_specular_desc {
    double radius;    /* of the near field, scene units, above 0; INFINITY allowed */
    double roughness; /* of all surfaces, at most 1; below 0: that of each pixel's material */
    bool radiance;    /* the reflected light is wanted too; the next three are of it alone */
    bool fresnel;     /* it has Schlick's factor of each pixel's material; else the factor is 1 */
    int bounces;      /* diffuse reflections before it, 0..AOB_MOST_BOUNCES; with 0 what blocks is black */
    const struct aob_light *light; /* world space; NULL: radiance 1 from everywhere */
    int x0, y0, width, height;     /* the part of the hits to compute, the guard band cropped; 0 size: all */
    int spp;                       /* directions a pixel: two independent halves of spp/2; even, 2..65536 */
    uint32_t seed;
};

/* width * height pixels each, scene part only. se and rgb_se are |A-B|/2, the standard error's estimate of the pixel: pool
 * them as an RMS. rgb and rgb_se are NULL unless they were wanted. */
struct aob_specular {
    float *so; /* (A+B)/2, 0..1; sky pixels are 1 with se 0 */
    float *se;
    float (*rgb)[3]; /* the reflected radiance; sky pixels are 0 with rgb_se 0 */
    float (*rgb_se)[3];
};

/* SO = integral of V f cos / integral of f cos, over the directions above the surface. f is the GGX lobe (Walter et al.
 * 2007) of alpha = roughness^2, at least 1e-3, with Smith's height-correlated masking and shadowing (Heitz 2014), and
 * with Fresnel's factor 1, as of a white metal. It is about the geometric normal, as the truth of the visibility is, and of
 * the view direction to the camera. V is 0 where a surface is met within the radius, else 1.
 *
 * The reflected radiance is the integral of L f cos, where L is the distant light if no surface is met within the radius,
 * and else what the surface reflects diffusely, as aob_tracer_incident has it: its albedo times its incident light, of
 * `bounces` - 1 reflections more. It is no quotient, so it lacks what the lobe loses: a single reflection by a rough
 * surface does not give back all light. Under uniform light and without bounces it is SO times what is given back. With
 * `fresnel` f has the factor F0 + (1 - F0)(1 - h.v)^5 (Schlick 1994), where F0 is .04 of what is no metal and the base colour of
 * a metal, mixed by the metalness (glTF 2.0, appendix B).
 *
 * Half vectors are drawn from those visible to the camera (Heitz 2018), by the same scrambled Sobol points as the
 * directions of the visibility. Each direction then weighs G2/G1, and one below the surface weighs nothing. A half is the
 * quotient of the sums of weight * V and of weight, so its bias falls as 1/spp, and an open surface is exactly 1. A half
 * of which every direction is below the surface takes the other half's value; if both are so, the pixel is 1.
 *
 * Fills *result (its arrays are allocated here; aob_specular_finish frees). False after one line if radius, roughness,
 * spp or part is bad; nothing is allocated then. `camera` is the one that cast the hits. The call uses all cores, and
 * gives the same result for any number of threads; the tracer is used by one call at a time. */
bool aob_tracer_specular(const struct aob_tracer *tracer, const struct aob_camera *camera,
                         const struct aob_hits *hits, const struct aob_specular_desc *desc,
                         struct aob_specular *result, struct aob_error *error);
void aob_specular_finish(struct aob_specular *specular);

/* The version is raised when any value could change. It is part of cache keys, beside aob_tracer_version. */
extern const char aob_specular_version[];
#endif
