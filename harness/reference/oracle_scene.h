/* Which listed scene has a visibility in closed form, and at which of its points. */
#ifndef AOB_REFERENCE_ORACLE_SCENE_H
#define AOB_REFERENCE_ORACLE_SCENE_H
#include "base/vec.h"

struct aob_oracle {
    const char *name;  /* "O2" */
    const char *scene; /* as it is listed */
    const char *claim; /* what it says, in a phrase with the formula */
    /* The truth at the surface point p with unit normal n (towards the viewer) for rays of length r. NAN where no
     * closed form holds: on surfaces that the form is not about, and at points from which the finite scene's end is
     * within r. */
    double (*visibility)(struct aob_vec3 p, struct aob_vec3 n, double r);
};

/* NULL if the scene has none; `scene` may be NULL. */
const struct aob_oracle *aob_oracle_find(const char *scene);
#endif
