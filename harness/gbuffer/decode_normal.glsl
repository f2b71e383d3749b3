/* The normal that a texel holds, view space. AOB_NORMAL_ENCODING is the place in enum aob_normal_encoding
 * (technique/option.h). */
#if AOB_NORMAL_ENCODING == 0 /* rgba32f */
vec3 aob_decode_normal(vec4 n) { return n.xyz; }
#elif AOB_NORMAL_ENCODING == 1 /* oct_rg16f: the octahedron unfolded */
vec3 aob_decode_normal(vec2 e)
{
    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    float fold = max(-n.z, 0.0);
    return normalize(vec3(n.x + (n.x >= 0.0 ? -fold : fold), n.y + (n.y >= 0.0 ? -fold : fold), n.z));
}
#elif AOB_NORMAL_ENCODING == 2 /* rgba8 */
vec3 aob_decode_normal(vec4 n) { return normalize(n.xyz * 2.0 - 1.0); }
#else /* packed8: z follows from x and y */
vec3 aob_decode_normal(vec4 n)
{
    vec2 xy = n.xy * 2.0 - 1.0;
    return normalize(vec3(xy, sqrt(max(0.0, 1.0 - dot(xy, xy)))));
}
#endif
