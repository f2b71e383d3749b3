/* The rectangle in the image around a triangle's volume. What it reaches lies within the radius of the triangle, and on
 * its front: so both in a box along the triangle and in one along the view. A rectangle covers each pixel once, whatever
 * the eye is in. */
#include "volume_size.glsl"
#include "tile_size.glsl"

const vec4 NOTHING = vec4(0.0, 0.0, 0.0, 1.0);

/* Places of the corners of an oriented box in the image, and its depths; unbounded towards a side where it passes the
 * eye's plane. */
void image_bounds(vec3 low, vec3 high, vec3 axis[3], out vec2 first, out vec2 last, out vec2 depths, out bool seen)
{
    vec2 least = vec2(1e30), most = vec2(-1e30);
    bool passes = false;
    first = vec2(1e30);
    last = vec2(-1e30);
    depths = vec2(1e30, -1e30);
    seen = false;
    for (int i = 0; i < 8; i++) {
        vec3 part = vec3(i & 1, i >> 1 & 1, i >> 2);
        vec3 w = low * (1.0 - part) + high * part;
        vec3 corner = w.x * axis[0] + w.y * axis[1] + w.z * axis[2];
        depths = vec2(min(depths.x, -corner.z), max(depths.y, -corner.z));
        bool before = AOB_PERSPECTIVE == 0 || corner.z < -1e-6 * RADIUS_OUT;
        vec2 q = aob_project(vec3(corner.xy, before ? corner.z : -1.0));
        least = min(least, vec2(corner.x, -corner.y));
        most = max(most, vec2(corner.x, -corner.y));
        first = before ? min(first, q) : first;
        last = before ? max(last, q) : last;
        seen = seen || before;
        passes = passes || !before;
    }
    if (passes) {
        first = mix(first, vec2(-1e30), lessThan(least, vec2(0.0)));
        last = mix(last, vec2(1e30), greaterThan(most, vec2(0.0)));
    }
}

#if CULL == 1
/* From image positions to pixels of the occlusion's size and back. */
vec2 to_target(vec2 q) { return (q - 0.5) / float(AOB_DIVISOR) + 0.5; }
vec2 from_target(vec2 t) { return (t - 0.5) * float(AOB_DIVISOR) + 0.5; }

/* Leaves of the rectangle what lies about the tiles that hold a surface within these depths. */
void cull(inout vec2 first, inout vec2 last, vec2 depths)
{
    ivec2 tiles = (aob_target_size + TILE - 1) / TILE;
    ivec2 from = max(ivec2(floor(to_target(first))) / TILE, ivec2(0)),
          to = min(ivec2(floor(to_target(last))) / TILE, tiles - 1), least = tiles, most = ivec2(-1);
    depths += vec2(-1e-5, 1e-5) * abs(depths);
    for (int y = from.y; y <= to.y; y++)
        for (int x = from.x; x <= to.x; x++) {
            vec2 range = aob_fetch_tiles(ivec2(x, y));
            bool meets = range.x <= depths.y && range.y >= depths.x;
            least = meets ? min(least, ivec2(x, y)) : least;
            most = meets ? max(most, ivec2(x, y)) : most;
        }
    first = max(first, from_target(vec2(least * TILE)));
    last = min(last, from_target(vec2((most + 1) * TILE)));
}
#endif

vec4 place(int triangle, int vertex)
{
    vec3 p[3] = vec3[3](aob_corner(triangle, 0), aob_corner(triangle, 1), aob_corner(triangle, 2));
    vec3 axis[3], low = vec3(1e30), high = vec3(-1e30);
    axis[2] = aob_front(triangle);
    vec3 a = p[1] - p[0], b = p[2] - p[1], c = p[0] - p[2];
    vec3 side = dot(a, a) > dot(b, b) ? a : b;
    side = dot(c, c) > dot(side, side) ? c : side;
    if (dot(axis[2], axis[2]) == 0.0 || dot(side, side) == 0.0)
        return NOTHING;
    axis[0] = normalize(side);
    axis[1] = cross(axis[2], axis[0]);
    for (int k = 0; k < 3; k++) {
        vec3 w = vec3(dot(p[k], axis[0]), dot(p[k], axis[1]), dot(p[k], axis[2]));
        low = min(low, w);
        high = max(high, w);
    }
    /* volume.glsl counts pixels behind the plane by the rounding of its extent. */
    float extent = max(length(p[0]), max(length(p[1]), length(p[2]))) + length(side) + 2.0 * RADIUS_OUT;
    low -= vec3(RADIUS_OUT, RADIUS_OUT, 1e-6 * extent);
    high += vec3(RADIUS_OUT, RADIUS_OUT, param.radius);
    vec3 along[3] = vec3[3](vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0));
    vec2 first, last, depths, first_along, last_along, depths_along;
    bool seen, seen_along;
    image_bounds(low, high, axis, first, last, depths, seen);
    image_bounds(min(p[0], min(p[1], p[2])) - RADIUS_OUT, max(p[0], max(p[1], p[2])) + RADIUS_OUT, along,
                 first_along, last_along, depths_along, seen_along);
    seen = seen && seen_along;
    first = max(max(first, first_along) - 1.0, vec2(-2.0));
    last = min(min(last, last_along) + 1.0, vec2(aob_size) + 2.0);
    depths = vec2(max(depths.x, depths_along.x), min(depths.y, depths_along.y));
#if CULL == 1
    if (seen)
        cull(first, last, depths);
#endif
    if (!seen || any(greaterThanEqual(first, last)))
        return NOTHING;
    vec2 corner = vec2(vertex == 1 || vertex == 2 || vertex == 4, vertex == 2 || vertex == 4 || vertex == 5);
    return aob_clip(first * (1.0 - corner) + last * corner);
}
