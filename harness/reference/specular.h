/* The truth of specular occlusion in the near field: how much of what a rough mirror reflects to the camera is open. */
#ifndef AOB_REFERENCE_SPECULAR_H
#define AOB_REFERENCE_SPECULAR_H
#include "tracer.h"

struct aob_specular_desc {
    double radius;             /* of the near field, scene units, above 0; INFINITY allowed */
    double roughness;          /* of all surfaces, at most 1; below 0: that of each pixel's material */
    int x0, y0, width, height; /* the part of the hits to compute, the guard band cropped; 0 size: all */
    int spp;                   /* directions a pixel: two independent halves of spp/2; even, 2..65536 */
    uint32_t seed;
};

/* width * height floats each, scene part only; sky pixels are 1 with se 0. */
struct aob_specular {
    float *so; /* (A+B)/2, 0..1 */
    float *se; /* |A-B|/2: the standard error's estimate of the pixel; pool it as an RMS */
};

/* SO = integral of V f cos / integral of f cos, over the directions above the surface. f is the GGX lobe (Walter et al.
 * 2007) of alpha = roughness^2, at least 1e-3, with Smith's height-correlated masking and shadowing (Heitz 2014), and
 * with Fresnel's factor 1, as under a metal that is white. It is about the geometric normal, as the truth of the
 * visibility is, and of the view direction to the camera. V is 0 where a surface is met within the radius, else 1; what
 * that surface shines back is left out, and the distant light is taken as even.
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
