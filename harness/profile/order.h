/* The order of pixels within a tile of a profile: blocks row by row, in each warps, in each quads, in each the four pixels,
 * always left to right, then downward. */
#ifndef AOB_PROFILE_ORDER_H
#define AOB_PROFILE_ORDER_H
#include "profile.h"

struct aob_order {
    int pixels;     /* of a tile; the first `lanes` are the first warp */
    int lanes;      /* of a warp */
    uint8_t *x, *y; /* of each pixel within the tile */
};
struct aob_order aob_order_create(const struct aob_profile *profile);
void aob_order_finish(struct aob_order *order);
#endif
