/* Nearest and farthest surface among the pixels that are drawn to in a tile; of the sky alone a range without depths. */
#include "tile_size.glsl"

void main()
{
    range = vec2(1e30, -1e30);
    for (int i = 0; i < TILE * TILE; i++) {
        ivec2 p = (aob_pixel * TILE + ivec2(i % TILE, i / TILE)) * (AOB_DIVISOR / TILE);
        float z = aob_view_z(p);
        range = aob_is_sky(p) ? range : vec2(min(range.x, z), max(range.y, z));
    }
}
