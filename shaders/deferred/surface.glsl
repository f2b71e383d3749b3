/* What is seen lies in the triangle's plane, up to the depth's rounding. */
void main()
{
    vec3 front = aob_front(), surface = aob_position(aob_pixel);
    bool seen = !aob_is_sky(aob_pixel) && abs(dot(front, surface - aob_corner(0))) <= 1e-4 * length(surface);
    vec3 facing = dot(front, surface) > 0.0 ? -front : front;
    normal = seen ? vec4(facing, 1.0) : vec4(0.0);
    lit = seen ? vec4(vec3(0.5 + 0.5 * facing.y), 1.0) : vec4(0.0);
}
