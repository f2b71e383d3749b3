/* Whether something has changed within the radius of a tile's surfaces: 1 or 0. What was seen of them before is then another scene. */
#include "common/box.glsl"

bool reaches(box own, box change) { return change.low.x <= change.high.x && gap(own, change) <= param.radius; }

bool group_reaches(box own, ivec2 group)
{
    if (!reaches(own, box(aob_fetch_group_low(group).xyz, aob_fetch_group_high(group).xyz)))
        return false;
    ivec2 last = (aob_size - 1) / 8;
    for (int i = 0; i < 64; i++) {
        ivec2 tile = min(group * 8 + ivec2(i & 7, i >> 3), last);
        if (reaches(own, box(aob_fetch_change_low(tile).xyz, aob_fetch_change_high(tile).xyz)))
            return true;
    }
    return false;
}

void main()
{
    box own = box(aob_fetch_tile_low(aob_pixel).xyz, aob_fetch_tile_high(aob_pixel).xyz);
    ivec2 first, last;
    window_of(own, param.radius, first, last);
    first /= 64;
    ivec2 size = last / 64 - first + 1;
    bool any_surface = own.low.x <= own.high.x, reached = false;
    for (int i = 0; any_surface && !reached && i < size.x * size.y; i++)
        reached = group_reaches(own, first + ivec2(i % size.x, i / size.x));
    changed = reached ? 1.0 : 0.0;
}
