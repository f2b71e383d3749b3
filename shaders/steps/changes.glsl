/* Of each tile of 8 x 8 pixels: a box about its surfaces, and one about what has changed there since the frame before, but for the
 * camera: places where something that moves is, where it was and what it hides, and where something is gone and what that shows.
 * What hides behind a thing that moves occludes nothing in an image. Where nothing has changed the box is empty, its low end above
 * its high one. */

/* How much two places may differ that are one: half floats of the velocity, and floats of the projection. */
bool apart(vec2 a, vec2 b, vec2 velocity) { return any(greaterThan(abs(a - b), 2e-3 + abs(velocity) / 512.0)); }
bool apart(float a, float b, float change) { return abs(a - b) > 1e-4 * abs(a) + abs(change) / 512.0; }

/* Whether the surface of pixel f moves by itself; `was` is where it came from, in view space of now. */
bool moves(ivec2 f, vec3 here, out vec3 was)
{
    vec3 then = aob_before(f), still = aob_place_before(here);
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

/* Under a camera that moves, a blade of grass may fall between the pixels for a frame: then something is gone of a tile only where
 * what was two pixels wide and high is. */
void main()
{
    vec3 low = vec3(1e30), high = vec3(-1e30), first = low, last = high, gone_low = low, gone_high = high;
    uvec2 gone_bits = uvec2(0u);
    bool sure = false;
    for (int i = 0; i < 64; i++) {
        ivec2 f = aob_pixel * 8 + ivec2(i & 7, i >> 3);
        if (any(greaterThanEqual(f, aob_size)))
            continue;
        vec3 here = aob_position(f), was, from;
        bool held = surface_before(f, was), moved = !aob_is_sky(f) && moves(f, here, from), gone = held && sees_through(was);
        grow_to_surface(first, last, f);
        if (moved) {
            grow(low, high, here);
            grow(low, high, from);
        }
        if (moved && held)
            grow(low, high, was);
        if (gone) {
            vec2 q = aob_project(was), way = abs(q - vec2(f) - 0.5);
            grow(gone_low, gone_high, was);
            grow_to_surface(gone_low, gone_high, ivec2(floor(q)));
            gone_bits |= i < 32 ? uvec2(1u << i, 0u) : uvec2(0u, 1u << (i - 32));
            sure = sure || max(way.x, way.y) < 0.01;
        }
    }
    bool gone = sure || has_block(gone_bits);
    tile_low = vec4(first, 1.0);
    tile_high = vec4(last, 1.0);
    change_low = vec4(gone ? min(low, gone_low) : low, 1.0);
    change_high = vec4(gone ? max(high, gone_high) : high, 1.0);
}
