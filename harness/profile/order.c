#include "order.h"
#include <stdlib.h>
#include "base/memory.h"

enum { DEPTH = 4 };

/* The pixel with number `n` in a grid of grids: sides[0] is the whole, each next one a part of the one before. */
static struct aob_size2 locate(const struct aob_size2 sides[DEPTH + 1], int n)
{
    struct aob_size2 at = {0, 0};
    for (int d = 0; d < DEPTH; d++) {
        int part = sides[d + 1].width * sides[d + 1].height, columns = sides[d].width / sides[d + 1].width;
        int index = n / part;
        at.width += index % columns * sides[d + 1].width;
        at.height += index / columns * sides[d + 1].height;
        n %= part;
    }
    return at;
}

struct aob_order aob_order_create(const struct aob_profile *profile)
{
    const struct aob_size2 sides[DEPTH + 1] = {profile->tile, profile->block, profile->warp, {2, 2}, {1, 1}};
    struct aob_order order = {.pixels = profile->tile.width * profile->tile.height,
                              .lanes = profile->warp.width * profile->warp.height};
    order.x = AOB_NEW_ARRAY(uint8_t, (size_t)order.pixels);
    order.y = AOB_NEW_ARRAY(uint8_t, (size_t)order.pixels);
    for (int n = 0; n < order.pixels; n++) {
        struct aob_size2 at = locate(sides, n);
        order.x[n] = (uint8_t)at.width;
        order.y[n] = (uint8_t)at.height;
    }
    return order;
}

void aob_order_finish(struct aob_order *order)
{
    free(order->x);
    free(order->y);
    *order = (struct aob_order){0};
}
