/* The surface's normal, a unit vector towards the eye; v where there is none. */
vec3 unit_normal(ivec2 p, vec3 v)
{
    vec3 n = aob_surface_normal(p);
    if (FAULT == NORMAL_AS_IT_COMES || (FAULT == NAN_SPREADS && isnan(n.x)))
        return n;
    n = is_unit(n) ? n : direction_or(n, v);
    return dot(n, v) < -0.03 ? -n : n;
}
