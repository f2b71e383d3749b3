/* Whether no surface within the radius of a tile rises above its plane by enough to show: 1 or 0. */
#include "hull.glsl"

/* How steeply a surface may rise (aob_technique.clear_sine). A quarter is for steps, which begin at the next pixel: what a pixel
 * covers at its nearest is as far as they are away. Below 1e-6 of the depth all is rounding. */
const float SINE = float(SINE_MILLIONTHS) * 1e-6;
const int MOST_GROUPS = 400;

struct tile {
    hull box;
    vec3 n;
    float low, step, slope; /* of its plane; what may rise above that, and per distance */
};

/* How far apart two boxes are. */
float gap(hull a, hull b) { return length(max(max(b.low - a.high, a.low - b.high), vec3(0.0))); }

/* Whether nothing of a cell rises too far above the tile's plane within the radius. */
bool lies_low(tile t, ivec2 cell, int side, vec3 n, vec4 ends)
{
    if (is_empty(ends))
        return true;
    hull h = hull_of(cell, side, n, ends, t.n);
    float far = gap(t.box, h);
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

/* The pixels that the ball of the radius about any point of the tile can cover. */
bool window_of(hull box, out ivec2 first, out ivec2 last)
{
    vec2 low = vec2(1e30), high = vec2(-1e30);
    vec3 near = box.low - param.radius, away = box.high + param.radius;
    first = last = ivec2(0);
    if (AOB_PERSPECTIVE == 1 && away.z > -1e-6)
        return false;
    for (int k = 0; k < 8; k++) {
        vec2 q = aob_project(vec3((k & 1) == 0 ? near.x : away.x, (k & 2) == 0 ? near.y : away.y, (k & 4) == 0 ? near.z : away.z));
        low = min(low, q);
        high = max(high, q);
    }
    first = ivec2(clamp(low, vec2(0.0), vec2(aob_size - 1))) / 32;
    last = ivec2(clamp(high, vec2(0.0), vec2(aob_size - 1))) / 32;
    return true;
}

void main()
{
    vec4 plane = aob_fetch_tile_plane(aob_pixel);
    vec4 ends = aob_fetch_tile_ends(aob_pixel);
    float step = max(0.25 * SINE / aob_pixel_radius(ends.z, 1.0), 1e-6 * ends.w);
    tile t = tile(hull_of(aob_pixel, 8, plane.xyz, ends, plane.xyz), plane.xyz, ends.x, step, 0.75 * SINE - plane.w);
    ivec2 first, last;
    bool open = !is_empty(ends) && t.slope > 0.0 && ends.y - ends.x <= step
        && window_of(t.box, first, last);
    ivec2 size = last - first + 1;
    open = open && size.x * size.y <= MOST_GROUPS;
    for (int i = 0; open && i < size.x * size.y; i++)
        open = group_lies_low(t, first + ivec2(i % size.x, i / size.x));
    clear = open ? 1.0 : 0.0;
}
