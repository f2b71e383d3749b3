/* Of the two neighbours along each axis the one nearer in depth lies on the same surface. */
vec3 aob_gbuffer_position(ivec2 f) {
    return aob_position_at(vec2(f) / float(AOB_DEPTH_DIVISOR) + 0.5, aob_gbuffer_z(f));
}
vec3 aob_depth_step(ivec2 f, vec3 c, ivec2 axis) {
    ivec2 last = param.aob_sizes.xy - 1;
    ivec2 before = max(f - axis, ivec2(0)), after = min(f + axis, last);
    vec3 a = aob_gbuffer_position(before), b = aob_gbuffer_position(after);
    bool forward = before == f || (after != f && abs(b.z - c.z) < abs(c.z - a.z));
    return forward ? b - c : c - a;
}
vec3 aob_gbuffer_normal(ivec2 p) {
    ivec2 f = clamp(p, ivec2(0), param.aob_sizes.xy - 1);
    vec3 c = aob_gbuffer_position(f);
    vec3 n = cross(aob_depth_step(f, c, ivec2(0, 1)), aob_depth_step(f, c, ivec2(1, 0)));
    return n * inversesqrt(max(dot(n, n), 1e-30));
}
