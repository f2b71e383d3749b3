/* Pixel f of the whole G-buffer lies at (f / divisor) + 1/2 among the pixels of a divided depth: the projection in
 * param.aob_lens is scaled so (aob_prelude_uniforms). */
float aob_gbuffer_z(ivec2 f) { return aob_decode_depth(aob_texel_depth(f)); }
float aob_view_z(ivec2 p) {
    ivec2 q = clamp(p, ivec2(0), aob_size - 1);
    float z = aob_own_z(q);
    return AOB_BORDER_FAR == 0 || q == p ? z : AOB_SKY_Z;
}
float aob_view_z(ivec2 p, int level) {
#if AOB_DEPTH_LEVELS > 1
    int l = clamp(level, 0, AOB_DEPTH_LEVELS - 1);
    ivec2 q = clamp(p, ivec2(0), aob_divided(AOB_DEPTH_DIVISOR << l) - 1);
    float z = aob_own_z(q, l);
    return AOB_BORDER_FAR == 0 || q == p ? z : AOB_SKY_Z;
#else
    return aob_view_z(p);
#endif
}
/* Not a surface's depth: the sky's, or what is no depth at all. Of floats the bits of 1e-15 to those below the sky's rise
 * with them; outside lie what is not above 0, what is so small that its square is 0, infinity and NaN, whatever a device
 * makes of comparing those. */
bool aob_no_depth(float z) {
    const uint least = floatBitsToUint(1e-15);
    return floatBitsToUint(z) - least >= floatBitsToUint(0.5 * AOB_SKY_Z) - least;
}
bool aob_is_sky(ivec2 p) { return aob_no_depth(aob_view_z(p)); }
vec3 aob_position(ivec2 p) { return aob_position_at(vec2(p) + 0.5, aob_view_z(p)); }
vec2 aob_image(ivec2 p) {
    return AOB_DIVISOR == AOB_DEPTH_DIVISOR ? vec2(p) + 0.5
        : vec2(p * AOB_DIVISOR) / float(AOB_DEPTH_DIVISOR) + 0.5;
}
float aob_surface_z(ivec2 p) {
#if AOB_DIVISOR == AOB_DEPTH_DIVISOR
    return aob_view_z(p);
#else
    ivec2 q = clamp(p, ivec2(0), aob_target_size - 1);
    float z = aob_gbuffer_z(q * AOB_DIVISOR);
    return AOB_BORDER_FAR == 0 || q == p ? z : AOB_SKY_Z;
#endif
}
bool aob_surface_is_sky(ivec2 p) { return aob_no_depth(aob_surface_z(p)); }
vec3 aob_surface(ivec2 p) { return aob_position_at(aob_image(p), aob_surface_z(p)); }
