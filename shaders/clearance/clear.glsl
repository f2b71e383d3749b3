/* Whether no surface that may darken a tile rises above its plane by enough to show: 1 or 0. With IN_FRONT those may that are drawn
 * where the ball of the radius is, unless they lie behind it; without, those within the radius (struct aob_clearance). */
#include "common/box.glsl"
#include "hull.glsl"

/* How steeply a surface may rise. A quarter is for steps, which begin at the next pixel: what a pixel
 * covers at its nearest is as far as they are away. Below this share of the depth all is rounding. */
const float SINE = float(SINE_MILLIONTHS) * 1e-6;
const float ROUNDING = IN_FRONT == 1 ? 5e-7 : 1e-6;
const int MOST_GROUPS = 400;
/* Texels of a divided depth begin at their edges, and places are rounded to them. */
const int AROUND = IN_FRONT == 1 ? 4 : 0;

struct tile {
    box own;
    vec3 n;
    float low, step, slope; /* of its plane; what may rise above that, and per distance */
    float most, lean;       /* what may rise at most; how far the G-buffer's normals lean from n */
    float behind;           /* z of what lies behind the ball */
    ivec2 first, last;      /* pixels of the ball */
};

/* Whether nothing of a cell rises too far above the tile's plane. */
bool lies_low(tile t, ivec2 cell, int side, vec3 n, vec4 ends)
{
    if (is_empty(ends) || any(lessThan(cell * side + side, t.first)) || any(greaterThan(cell * side, t.last)))
        return true;
    hull h = hull_of(cell, side, n, ends, t.n);
    box all = box(h.low, h.high);
    float far = gap(t.own, all), rise = h.top - t.low;
    bool away = IN_FRONT == 1 ? h.high.z <= t.behind : far > param.radius;
    return (away || (rise <= t.slope * far + t.step && rise <= t.most - t.lean * farthest(t.own, all)));
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

/* How far a surface may rise along the normal so that it is no more than RISE in front: the plane is seen aslant, and is the nearer
 * to the eye the farther it comes up. Beyond that there must be more than rounding. Every test passes without
 * `nearer`: none has a rise that is so near to the limit. */
float most_of(vec3 n, float lean, vec4 ends)
{
#if RISE_MILLIONTHS > 0
    float facing = 1.0, nearer = AOB_PERSPECTIVE == 1 ? 1.0 + param.radius / ends.z : 1.0;
    for (int k = 0; k < 4; k++) {
        ivec2 q = min(8 * (aob_pixel + ivec2(k & 1, k >> 1)), aob_size);
        vec3 ray = AOB_PERSPECTIVE == 1 ? aob_position_at(vec2(q), 1.0) : vec3(0.0, 0.0, -1.0);
        facing = min(facing, -dot(n, ray) - lean * length(ray));
    }
    return float(RISE_MILLIONTHS) * 1e-6 * param.radius * facing / nearer - 1e-6 * ends.w;
#else
    return 1e30;
#endif
}

/* The depth from which on all lies behind the ball, by a difference of depths that is as large as the radius to first order. */
float behind_ball(float z) { return z + param.radius * (AOB_PERSPECTIVE == 1 ? z / (z - param.radius) : 1.0); }

/* False where the ball may reach the eye, or covers too little of the image or too much, or leaves it where it must not. */
bool covers(inout tile t, vec4 ends)
{
    ivec2 first, last;
    bool whole = window_of(t.own, param.radius, first, last);
    t.first = max(first - AROUND, ivec2(0));
    t.last = min(last + AROUND, aob_size - 1);
#if INSIDE == 1
    whole = whole && all(greaterThan(t.first, ivec2(0))) && all(lessThan(t.last, aob_size - 1));
#endif
    ivec2 groups = t.last / 32 - t.first / 32 + 1;
    return whole && groups.x * groups.y <= MOST_GROUPS
        && aob_pixel_radius(ends.w, param.radius) >= float(LEAST_PIXELS);
}

void main()
{
    vec4 plane = aob_fetch_tile_plane(aob_pixel);
    vec4 ends = aob_fetch_tile_ends(aob_pixel);
    float step = max(0.25 * SINE / aob_pixel_radius(ends.z, 1.0), ROUNDING * (IN_FRONT == 1 ? ends.z : ends.w));
    hull h = hull_of(aob_pixel, 8, plane.xyz, ends, plane.xyz);
    tile t = tile(box(h.low, h.high), plane.xyz, ends.x, step, 0.75 * SINE - plane.w, most_of(plane.xyz, plane.w, ends), plane.w,
                  -max(behind_ball(ends.z), behind_ball(ends.w)), ivec2(0), ivec2(0));
    bool open = !is_empty(ends) && t.slope > 0.0 && t.most > 0.0 && ends.y - ends.x <= step && covers(t, ends);
    ivec2 first = t.first / 32, size = t.last / 32 - first + 1;
    for (int i = 0; open && i < size.x * size.y; i++)
        open = group_lies_low(t, first + ivec2(i % size.x, i / size.x));
    clear = open ? 1.0 : 0.0;
}
