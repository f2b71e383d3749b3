/* Whether no surface within the radius of a tile rises above its plane by enough to show: 1 or 0. */
#include "common/box.glsl"
#include "hull.glsl"

/* How steeply a surface may rise (aob_technique.clear_sine). A quarter is for steps, which begin at the next pixel: what a pixel
 * covers at its nearest is as far as they are away. Below 1e-6 of the depth all is rounding. */
const float SINE = float(SINE_MILLIONTHS) * 1e-6;
const int MOST_GROUPS = 400;

struct tile {
    box own;
    vec3 n;
    float low, step, slope; /* of its plane; what may rise above that, and per distance */
};

/* Whether nothing of a cell rises too far above the tile's plane within the radius. */
bool lies_low(tile t, ivec2 cell, int side, vec3 n, vec4 ends)
{
    if (is_empty(ends))
        return true;
    hull h = hull_of(cell, side, n, ends, t.n);
    float far = gap(t.own, box(h.low, h.high));
    return (far > param.radius || h.top - t.low <= t.slope * far + t.step);
}

bool group_lies_low(tile t, ivec2 group)
{
    vec4 ends = aob_fetch_group_ends(group);
    if (lies_low(t, group, 32, aob_fetch_group_plane(group).xyz, ends))
        return true;
    for (int i = 0; i < 16; i++) {
        ivec2 cell = group * 4 + ivec2(i & 3, i >> 2);
        if (any(greaterThanEqual(cell * 8, aob_size)))
            continue;
        if (!lies_low(t, cell, 8, aob_fetch_tile_plane(cell).xyz, aob_fetch_tile_ends(cell)))
            return false;
    }
    return true;
}

void main()
{
    vec4 plane = aob_fetch_tile_plane(aob_pixel);
    vec4 ends = aob_fetch_tile_ends(aob_pixel);
    float step = max(0.25 * SINE / aob_pixel_radius(ends.z, 1.0), 1e-6 * ends.w);
    hull h = hull_of(aob_pixel, 8, plane.xyz, ends, plane.xyz);
    tile t = tile(box(h.low, h.high), plane.xyz, ends.x, step, 0.75 * SINE - plane.w);
    ivec2 first, last;
    bool open = !is_empty(ends) && t.slope > 0.0 && ends.y - ends.x <= step
        && window_of(t.own, param.radius, first, last);
    first /= 32;
    ivec2 size = last / 32 - first + 1;
    open = open && size.x * size.y <= MOST_GROUPS;
    for (int i = 0; open && i < size.x * size.y; i++)
        open = group_lies_low(t, first + ivec2(i % size.x, i / size.x));
    clear = open ? 1.0 : 0.0;
}
