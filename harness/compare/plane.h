/* What changed its image, on the plane of cost and error: a picture, with a line from each case of A to that of B. */
#ifndef AOB_COMPARE_PLANE_H
#define AOB_COMPARE_PLANE_H
#include "compared.h"
#include "reports/page/gallery.h"

/* A place on the plane, lower left is better. */
struct aob_place_on_plane {
    double cost;  /* fixed passes; B's is A's times the ratio of the comparison */
    double error; /* RMSE without the noise of its truth */
};

/* False where one is not known. */
bool aob_plane_find(const struct aob_compared *item, struct aob_place_on_plane *a,
                    struct aob_place_on_plane *b);

#define AOB_PLANE_NAME "maps/plane" /* below the table's folder */
#define AOB_PLANE_FILE AOB_PLANE_NAME ".svg"

/* Whether a case moved between two places that are known; then there is a picture, which is added to the gallery. */
bool aob_plane_any(const struct aob_compared_table *table);
void aob_plane_add(struct aob_gallery *gallery, const struct aob_compared_table *table);
#endif
