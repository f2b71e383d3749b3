#include "tiles.h"
#include <stdlib.h>
#include "base/memory.h"
#include "embree_mesh.h"

enum { TILE = 8 };

bool aob_tiles_init(struct aob_tiles *tiles, const struct aob_hits *hits, const int part[4], int spp,
                    const char *name, struct aob_error *error)
{
    int x0 = part[0], y0 = part[1], width = part[2], height = part[3];
    if (spp < 2 || spp > 65536 || spp % 2)
        return aob_fail(error, "%s: %d rays a pixel: must be even, 2 to 65536", name, spp);
    if (x0 < 0 || y0 < 0 || width < 0 || height < 0 || width > hits->width - x0 || height > hits->height - y0)
        return aob_fail(error, "%s: part %dx%d at (%d, %d) is not within the image of %dx%d", name, width,
                        height, x0, y0, hits->width, hits->height);
    *tiles = width == 0 || height == 0 ? (struct aob_tiles){hits, 0, 0, hits->width, hits->height}
                                       : (struct aob_tiles){hits, x0, y0, width, height};
    return true;
}

static void do_tile(const struct aob_tiles *tiles, const struct aob_tiles_work *work, int tile, void *scratch)
{
    int across = (tiles->width + TILE - 1) / TILE;
    int x0 = tile % across * TILE, y0 = tile / across * TILE;
    for (int y = y0; y < y0 + TILE && y < tiles->height; y++)
        for (int x = x0; x < x0 + TILE && x < tiles->width; x++)
            work->do_pixel(work->job,
                           (size_t)(y + tiles->y0) * (size_t)tiles->hits->width + (size_t)(x + tiles->x0),
                           (size_t)y * (size_t)tiles->width + (size_t)x, scratch);
}

void aob_tiles_run(const struct aob_tiles *tiles, const struct aob_tiles_work *work)
{
    int count = ((tiles->width + TILE - 1) / TILE) * ((tiles->height + TILE - 1) / TILE);
#pragma omp parallel
    {
        unsigned mode = aob_float_mode_begin();
        void *scratch = aob_alloc(1, work->scratch_size);
        work->scratch_init(scratch, work->job);
#pragma omp for schedule(dynamic)
        for (int tile = 0; tile < count; tile++)
            do_tile(tiles, work, tile, scratch);
        work->scratch_finish(scratch);
        free(scratch);
        aob_float_mode_end(mode);
    }
}
