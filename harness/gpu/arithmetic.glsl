/* Each function is the formula of the GLSL specification; only the order of its additions is chosen here. */
float aob_dot(float a, float b) { return a * b; }
float aob_dot(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
float aob_dot(vec3 a, vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
float aob_dot(vec4 a, vec4 b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
#define AOB_FOR_VECTORS(T)                                          \
    float aob_length(T v) { return sqrt(aob_dot(v, v)); }           \
    T aob_normalize(T v) { return v * inversesqrt(aob_dot(v, v)); } \
    T aob_reflect(T i, T n) { return i - 2.0 * aob_dot(n, i) * n; }
float aob_length(float v) { return abs(v); }
float aob_normalize(float v) { return sign(v); }
float aob_reflect(float i, float n) { return i - 2.0 * n * i * n; }
AOB_FOR_VECTORS(vec2) AOB_FOR_VECTORS(vec3) AOB_FOR_VECTORS(vec4)
#define AOB_MIX(T, A) T aob_mix(T x, T y, A a) { return x * (1.0 - a) + y * a; }
#define AOB_CHOOSE(T, A) T aob_mix(T x, T y, A a) { return mix(x, y, a); }
AOB_MIX(float, float) AOB_MIX(vec2, float) AOB_MIX(vec3, float) AOB_MIX(vec4, float)
AOB_MIX(vec2, vec2) AOB_MIX(vec3, vec3) AOB_MIX(vec4, vec4)
AOB_CHOOSE(float, bool) AOB_CHOOSE(vec2, bvec2) AOB_CHOOSE(vec3, bvec3) AOB_CHOOSE(vec4, bvec4)
#define dot(a, b) aob_dot(a, b)
#define length(v) aob_length(v)
#define distance(a, b) aob_length((a) - (b))
#define normalize(v) aob_normalize(v)
#define reflect(i, n) aob_reflect(i, n)
#define mix(x, y, a) aob_mix(x, y, a)
