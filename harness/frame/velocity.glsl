/* What the velocity texture holds is in frame/velocity_texels.h. */
vec3 aob_before(ivec2 f) {
    ivec2 q = clamp(f, ivec2(0), param.aob_sizes.xy - 1);
    vec4 moved = aob_texel_velocity(q);
    return vec3(vec2(q) + 0.5 - moved.xy, moved.w > 0.5 ? aob_gbuffer_z(q) + moved.z : AOB_SKY_Z);
}
vec3 aob_direction_before(vec3 d) {
    return vec3(dot(param.aob_then[0].xyz, d), dot(param.aob_then[1].xyz, d), dot(param.aob_then[2].xyz, d));
}
vec3 aob_place_before(vec3 v) {
    return aob_direction_before(v) + vec3(param.aob_then[0].w, param.aob_then[1].w, param.aob_then[2].w);
}
vec3 aob_direction_now(vec3 d) {
    return param.aob_then[0].xyz * d.x + param.aob_then[1].xyz * d.y + param.aob_then[2].xyz * d.z;
}
vec3 aob_place_now(vec3 v) {
    return aob_direction_now(v - vec3(param.aob_then[0].w, param.aob_then[1].w, param.aob_then[2].w));
}
