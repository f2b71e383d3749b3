/* The normal that a texel holds, view space. AOB_NORMAL_ENCODING is the place in enum aob_normal_encoding
 * (technique/option.h). */
#if AOB_NORMAL_ENCODING == 0 /* rgba32f */
vec3 aob_decode_normal(vec4 n) { return n.xyz; }
#elif AOB_NORMAL_ENCODING == 1 || AOB_NORMAL_ENCODING == 5 /* oct_rg16f, oct_rg8: the octahedron unfolded */
vec3 aob_decode_normal(vec2 texel)
{
    vec2 e = AOB_NORMAL_ENCODING == 5 ? texel * 2.0 - 1.0 : texel;
    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    float fold = max(-n.z, 0.0);
    return normalize(vec3(n.x + (n.x >= 0.0 ? -fold : fold), n.y + (n.y >= 0.0 ? -fold : fold), n.z));
}
#elif AOB_NORMAL_ENCODING == 2 /* rgba8 */
vec3 aob_decode_normal(vec4 n) { return normalize(n.xyz * 2.0 - 1.0); }
#elif AOB_NORMAL_ENCODING == 4 /* rgba16f */
vec3 aob_decode_normal(vec4 n) { return normalize(n.xyz); }
#elif AOB_NORMAL_ENCODING == 6 /* rgb10: a byte of each component, and two bits of each in w */
vec3 aob_decode_normal(vec4 n)
{
    uvec4 k = uvec4(n * 255.0 + 0.5);
    return normalize(vec3(k.xyz | (uvec3(k.w, k.w >> 2, k.w >> 4) & 3u) << 8u) * (2.0 / 1023.0) - 1.0);
}
#elif AOB_NORMAL_ENCODING == 7 /* sphere_rg16f: of unit length by itself */
vec3 aob_decode_normal(vec2 e)
{
    float f = min(dot(e, e), 1.0);
    return vec3(2.0 * sqrt(1.0 - f) * e, 1.0 - 2.0 * f);
}
#else /* packed8: z follows from x and y */
vec3 aob_decode_normal(vec4 n)
{
    vec2 xy = n.xy * 2.0 - 1.0;
    return normalize(vec3(xy, sqrt(max(0.0, 1.0 - dot(xy, xy)))));
}
#endif
