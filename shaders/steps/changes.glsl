/* Two boxes for each tile of 8 x 8 pixels: one about its surfaces, and one about the places there where something has changed since the
 * frame before, other than by the camera. These are the places
 *   - of a surface that moves by itself, now and in the frame before, and of the surface that it hides now;
 *   - of a surface that is gone, and of the one that shows in its stead;
 *   - of a surface that is there and was not.
 * A surface that something hides occludes nothing in an image, so hiding it is a change. Where nothing has changed the box is empty: its low
 * end lies above its high one. */

/* How much two places may differ that are one: half floats of the velocity, and floats of the projection. */
bool apart(vec2 a, vec2 b, vec2 velocity) { return any(greaterThan(abs(a - b), 2e-3 + abs(velocity) / 512.0)); }
bool apart(float a, float b, float change) { return abs(a - b) > 1e-4 * abs(a) + abs(change) / 512.0; }

/* Whether the surface of pixel f, which was at `then`, moves by itself; `was` is that place in view space of now. */
bool moves(ivec2 f, vec3 here, vec3 then, out vec3 was)
{
    vec3 still = aob_place_before(here);
    was = aob_place_now(aob_position_at(then.xy, then.z));
    if (aob_no_depth(then.z) || (AOB_PERSPECTIVE == 1 && still.z > -1e-6))
        return false;
    return apart(then.xy, aob_project(still), vec2(f) + 0.5 - then.xy) || apart(then.z, -still.z, then.z + here.z);
}

/* Whether one sees through a place that held a surface: all four pixels about it show what lies behind. */
bool sees_through(vec3 place)
{
    vec2 q = aob_project(place) - 0.5;
    vec2 part = fract(q);
    bool through = all(greaterThanEqual(q, vec2(-0.5))) && all(lessThanEqual(q, vec2(aob_size) - 0.5));
    for (int k = 0; k < 4; k++) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        vec2 share = mix(1.0 - part, part, vec2(corner));
        bool counts = min(share.x, share.y) > 0.01;
        through = through && (!counts || aob_view_z(ivec2(floor(q)) + corner) > -1.002 * place.z);
    }
    return through;
}

/* The surface that the frame before showed in pixel f, in view space of now; false where there was none. */
bool surface_before(ivec2 f, out vec3 was)
{
    float old = length(aob_fetch_surface_before(f).xyz);
    was = aob_place_now(aob_position_at(vec2(f) + 0.5, old));
    return !aob_no_depth(old) && (AOB_PERSPECTIVE == 0 || was.z < -1e-6);
}

/* Whether the frame before shows what lies behind the place where a surface is said to have been: it was not there. */
bool is_new(vec3 then)
{
    vec2 q = then.xy - 0.5;
    vec2 part = fract(q);
    bool absent = all(greaterThanEqual(q, vec2(-0.5))) && all(lessThanEqual(q, vec2(aob_size) - 0.5)) && !aob_no_depth(then.z);
    for (int k = 0; k < 4; k++) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        vec2 share = mix(1.0 - part, part, vec2(corner));
        float z = length(aob_fetch_surface_before(ivec2(floor(q)) + corner).xyz);
        absent = absent && (min(share.x, share.y) <= 0.01 || aob_no_depth(z) || z > 1.002 * then.z);
    }
    return absent;
}

/* Whether bits of an 8 x 8 tile, row by row, hold a block of 2 x 2. */
bool has_block(uvec2 bits)
{
    uvec2 pairs = bits & (bits >> 1) & 0x7f7f7f7fu;
    return (pairs.x & (pairs.x >> 8 | pairs.y << 24)) != 0u || (pairs.y & pairs.y >> 8) != 0u;
}

void grow(inout vec3 low, inout vec3 high, vec3 place)
{
    low = min(low, place);
    high = max(high, place);
}

void grow_to_surface(inout vec3 low, inout vec3 high, ivec2 f)
{
    if (!aob_is_sky(f))
        grow(low, high, aob_position(f));
}

/* Under a camera that moves, a blade of grass may fall between the pixels for a frame, and come back: then something is gone or new in a
 * tile only where that is two pixels wide and high. */
void main()
{
    vec3 low = vec3(1e30), high = vec3(-1e30), first = low, last = high, rest_low = low, rest_high = high;
    uvec2 bits = uvec2(0u);
    bool sure = false;
    for (int i = 0; i < 64; i++) {
        ivec2 f = aob_pixel * 8 + ivec2(i & 7, i >> 3);
        if (any(greaterThanEqual(f, aob_size)))
            continue;
        vec3 here = aob_position(f), then = aob_before(f), was, from;
        bool there = !aob_is_sky(f), held = surface_before(f, was), moved = there && moves(f, here, then, from);
        bool gone = held && sees_through(was), fresh = there && is_new(then);
        vec2 q = aob_project(was), way = gone ? q - vec2(f) - 0.5 : then.xy - vec2(f) - 0.5;
        grow_to_surface(first, last, f);
        if (moved) {
            grow(low, high, here);
            grow(low, high, from);
        }
        if (moved && held)
            grow(low, high, was);
        if (fresh)
            grow(rest_low, rest_high, here);
        if (gone) {
            grow(rest_low, rest_high, was);
            grow_to_surface(rest_low, rest_high, ivec2(floor(q)));
        }
        if (gone || fresh) {
            bits |= i < 32 ? uvec2(1u << i, 0u) : uvec2(0u, 1u << (i - 32));
            sure = sure || max(abs(way.x), abs(way.y)) < 0.01;
        }
    }
    bool changed = sure || has_block(bits);
    tile_low = vec4(first, 1.0);
    tile_high = vec4(last, 1.0);
    change_low = vec4(changed ? min(low, rest_low) : low, 1.0);
    change_high = vec4(changed ? max(high, rest_high) : high, 1.0);
}
