/* What a surface mirrors of the light, as the lit composite computes it (technique/composite.h), on the processor; and how far the open
 * share of its lobe can lie from its visibility. View space. */
#ifndef AOB_EFFECTS_LOBE_H
#define AOB_EFFECTS_LOBE_H
#include "base/vec.h"
#include "scene/light.h"
#include "technique/composite.h"

enum { AOB_LOBE_COSINES = AOB_COMPOSITE_COSINES, AOB_LOBE_SHAPES = AOB_COMPOSITE_SHAPES };

struct aob_lobe_table {
    struct aob_composite_lobe moments[AOB_LOBE_SHAPES][AOB_LOBE_COSINES][2];
    float apart[AOB_LOBE_SHAPES][AOB_LOBE_COSINES];
};

/* A new table, which takes some tenths of a second; free() it. Any thread may read it. */
struct aob_lobe_table *aob_lobe_table_create(void);

struct aob_lobe_surface {
    struct aob_vec3 normal, view; /* unit vectors; view: towards the eye */
    double roughness;             /* 0..1 */
    double f0[3];                 /* what is mirrored along the normal */
};
/* What an open surface mirrors of the light, R G B, and of a light that is 1 from everywhere. */
void aob_lobe_mirror(const struct aob_lobe_table *table, const struct aob_lobe_surface *surface,
                     const struct aob_light *light, double open[3], double even[3]);

/* The total variation between the GGX lobe, Fresnel's factor 1, and the cosine's: no occluders make the open share of the one differ
 * from that of the other by more. 0..1; 1 of what is smoother than .35, which the sum over directions does not resolve. */
double aob_lobe_apart(const struct aob_lobe_table *table, double roughness, double cosine);
#endif
