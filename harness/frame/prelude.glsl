/* What every pass has, whatever it reads. `aob_texel_*` are written for each pass, after this. */

/* Pixels that a divisor leaves of the whole G-buffer. */
ivec2 aob_divided(int divisor) { return (param.aob_sizes.xy + (divisor - 1)) / divisor; }
#define aob_size aob_divided(AOB_DEPTH_DIVISOR)
#define aob_target_size (param.aob_sizes.zw)
#define aob_frame (param.aob_misc.x)
#define aob_pixel (ivec2(gl_FragCoord.xy))
float aob_unless_first(float t) { return mix(0.0, t, aob_frame != 0); }
vec2 aob_unless_first(vec2 t) { return mix(vec2(0.0), t, bvec2(aob_frame != 0)); }
vec4 aob_unless_first(vec4 t) { return mix(vec4(0.0), t, bvec4(aob_frame != 0)); }
const float AOB_PI = 3.14159265358979;
const float AOB_SKY_Z = 1e9;
vec3 aob_position_at(vec2 q, float z) {
    float s = AOB_PERSPECTIVE == 1 ? z : 1.0;
    vec2 xy = (q - param.aob_lens.zw) * param.aob_lens.xy * s;
    return vec3(xy.x, -xy.y, -z);
}
vec2 aob_project(vec3 v) {
    float s = AOB_PERSPECTIVE == 1 ? -v.z : 1.0;
    return vec2(v.x, -v.y) / (param.aob_lens.xy * s) + param.aob_lens.zw;
}
vec3 aob_view_vector(vec3 v) { return AOB_PERSPECTIVE == 1 ? normalize(-v) : vec3(0.0, 0.0, 1.0); }
float aob_pixel_radius(float z, float r) { return r / (param.aob_lens.y * (AOB_PERSPECTIVE == 1 ? z : 1.0)); }
float aob_random(ivec2 p, int i) {
    uvec3 v = uvec3(uint(p.x), uint(p.y), uint(i) + uint(AOB_SEED) * 2654435769u) * 1664525u + 1013904223u;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    v ^= v >> 16;
    v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
    return float(v.x >> 8) * (1.0 / 16777216.0);
}
