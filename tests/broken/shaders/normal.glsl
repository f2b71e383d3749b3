/* The surface's normal, of unit length; v where there is none. */
vec3 unit_normal(ivec2 p, vec3 v)
{
    vec3 n = aob_surface_normal(p);
    float square = dot(n, n);
    if (FAULT == NORMAL_AS_IT_COMES)
        return n;
    return square > 1e-12 && square < 1e12 ? n * inversesqrt(square) : v;
}
