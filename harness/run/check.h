/* Whether the geometry of a view is as the techniques that draw its triangles presuppose: closed solids that face
 * outwards, each face once (technique.h, AOB_TRIANGLES). */
#ifndef AOB_RUN_CHECK_H
#define AOB_RUN_CHECK_H
#include "measurement.h"

/* Prints one warning if the view of case `index` is not so, once for each view of the plan and only where a case of it
 * draws triangles. Nothing else depends on it. */
void aob_check_view(struct aob_measurement *m, size_t index, const struct aob_view_files *files);
#endif
