/* The same of 4 x 4 tiles, from their bounds. */
#include "hull.glsl"

void main()
{
    vec3 n = vec3(0.0);
    vec4 found = vec4(1e30, -1e30, 1e30, -1e30);
    for (int i = 0; i < 16; i++) {
        ivec2 tile = aob_pixel * 4 + ivec2(i & 3, i >> 2);
        if (any(greaterThanEqual(tile * 8, aob_size)))
            continue;
        vec3 of = aob_fetch_tile_plane(tile).xyz;
        vec4 own = aob_fetch_tile_ends(tile);
        if (is_empty(own))
            continue;
        n = n == vec3(0.0) ? of : n;
        hull up = hull_of(tile, 8, of, own, n), down = hull_of(tile, 8, of, own, -n);
        found = vec4(min(found.x, -down.top), max(found.y, up.top), min(found.z, own.z), max(found.w, own.w));
        if (n == vec3(0.0)) /* heights along no direction bound nothing */
            found.xy = vec2(-1e30, 1e30);
    }
    plane = vec4(n, 0.0);
    ends = found;
}
