/* Whether a vector's length is 1; not of one that is no number. */
bool is_unit(vec3 n) { return abs(dot(n, n) - 1.0) <= 1e-4; }

/* Whether the surface at `position` shows the eye its front, by a normal of about unit length. In 8 bits a normal that is
 * seen from the side leans by up to 1.3 degrees, and may point away by as much: that is no reason to turn it round. */
bool faces_eye(vec3 n, vec3 position)
{
    return AOB_PERSPECTIVE == 1 ? dot(n, position) <= -0.03 * position.z : n.z >= -0.03;
}

/* The way over the surface from pixel p along an axis, towards the neighbour nearer in depth. */
vec3 surface_step(ivec2 p, vec3 position, ivec2 axis)
{
    ivec2 before = max(p - axis, ivec2(0)), after = min(p + axis, aob_target_size - 1);
    vec3 a = aob_surface(before), b = aob_surface(after);
    bool forward = before == p || (after != p && abs(b.z - position.z) < abs(position.z - a.z));
    return forward ? b - position : position - a;
}

/* A unit vector, or where a vector has no direction another one. Any length will do but one that squares to nothing or to
 * infinity: bits are in the order of the floats, and those of what is no number lie outside, whatever a device makes of
 * comparing it. */
vec3 direction_or(vec3 n, vec3 other)
{
    float square = dot(n, n);
    const uint least = floatBitsToUint(1e-30), most = floatBitsToUint(1e30);
    return floatBitsToUint(square) - least < most - least ? n * inversesqrt(square) : other;
}

/* Of a normal that is none: with a direction it is turned towards the eye, without one the depth's serves. */
vec3 mended_normal(vec3 n, vec3 position)
{
    ivec2 p = aob_pixel;
    vec3 surface = cross(surface_step(p, position, ivec2(0, 1)), surface_step(p, position, ivec2(1, 0)));
    vec3 unit = direction_or(n, direction_or(surface, aob_view_vector(position)));
    return faces_eye(unit, position) ? unit : -unit;
}

/* The normal of this pixel, whose surface lies at `position`: a unit vector towards the eye, whatever the G-buffer holds.
 * There may be zeros where nothing was written, no numbers after a division, other lengths after a filter, and the backs of
 * surfaces. A normal that is right keeps its bits, and costs the asking alone. */
vec3 facing_normal(vec3 n, vec3 position)
{
    if (!is_unit(n) || !faces_eye(n, position))
        n = mended_normal(n, position);
    return n;
}
