/* Kajalin 2009, ComputeSSAO: the share of a sphere about the surface point that lies in front of the depth buffer.
 * The comment at the top of crytek_ssao.c says where the listing is corrected. */
#include "common/facing.glsl"

/* The rotation that takes the z axis to unit vector v (the listing's rotMat; its rows are the columns here). */
mat3 turn_to(vec3 v)
{
    float h = 1.0 / (1.0 + v.z);
    return mat3(h * v.y * v.y + v.z, -h * v.x * v.y, -v.x, -h * v.x * v.y, h * v.x * v.x + v.z, -v.y, v.x, v.y, v.z);
}

/* The listing's kernels have up to three cubes, which share their corners' directions. More cubes would only sample
 * the lengths more finely: those are turned, evenly over all rotations (Shoemake 1992; Roberts's R3 sequence). */
mat3 cube_turn(int cube)
{
    vec3 u = fract(vec3(0.8191725, 0.6710436, 0.5497005) * float(cube) + 0.5);
    vec2 a = 2.0 * AOB_PI * u.yz;
    vec4 q = vec4(sqrt(1.0 - u.x) * vec2(sin(a.x), cos(a.x)), sqrt(u.x) * vec2(sin(a.y), cos(a.y)));
    vec3 t = 2.0 * q.xyz;
    return mat3(1.0 - t.y * q.y - t.z * q.z, t.x * q.y + t.z * q.w, t.x * q.z - t.y * q.w, t.x * q.y - t.z * q.w,
                1.0 - t.x * q.x - t.z * q.z, t.y * q.z + t.x * q.w, t.x * q.z + t.y * q.w, t.y * q.z - t.x * q.w,
                1.0 - t.x * q.x - t.y * q.y);
}

/* Length of the longest offset at depth z. */
float reach(float z)
{
#if SIZE == 0
    return param.radius;
#else
    return 2.0 * z * param.screen_radius;
#endif
}

/* What one sample counts: 1 in front of the surface there, 0 behind it, and towards the default where that surface is
 * so much nearer than the centre that it is another object (the listing's fRangeIsValid). */
float access_of(vec3 position, vec3 normal, vec3 direction, float size)
{
    vec3 s = position + size * direction;
    s.z = min(s.z, 1e-3 * position.z); /* not behind the eye, where nothing projects */
    ivec2 q = ivec2(floor(aob_project(s)));
    float z = aob_view_z(q);
    /* By differences: of a place that is rounded a short offset is no more than the rounding, and ties. */
    float nearer = -position.z - z, open = nearer < size * direction.z ? 1.0 : 0.0;
    float other = clamp(nearer / (z * param.range), 0.0, 1.0);
    float a = mix(open, param.range_default, other);
#if HEMISPHERE == 1
    /* What does not rise above the tangent plane hides nothing of this half: only its pixel makes it seem to. */
    vec3 d = aob_position_at(vec2(q) + 0.5, z) - position;
    a = dot(d, normal) <= 1e-5 * length(d) - 1e-6 * position.z ? 1.0 : a;
#endif
    return a;
}

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p);
    access = 1.0;
    if (aob_is_clear(p))
        return;
    vec3 v = normalize(2.0 * aob_fetch_tile(p & 3).xyz - 1.0);
#if HEMISPHERE == 1
    vec3 normal = facing_normal(aob_surface_normal(p), position);
#else
    vec3 normal = vec3(0.0);
#endif
    const float growth = 1.0 + 2.4 / float(SAMPLES);
    float size = reach(-position.z) * pow(growth, -float(SAMPLES)), sum = 0.0;
    mat3 pixel_turn = turn_to(v);
    for (int i = 0; i < SAMPLES; i++) {
        vec3 offset = vec3((i & 4) == 0 ? -1.0 : 1.0, (i & 2) == 0 ? -1.0 : 1.0, (i & 1) == 0 ? -1.0 : 1.0) *
                      inversesqrt(3.0);
        size *= growth;
#if SAMPLES > 24
        offset = i < 24 ? offset : cube_turn(i >> 3) * offset;
#endif
#if ROTATION == 0
        offset = pixel_turn * offset;
#else
        offset = reflect(offset, v);
#endif
#if HEMISPHERE == 1
        offset = dot(offset, normal) < 0.0 ? -offset : offset;
#endif
        sum += access_of(position, normal, offset, size);
    }
    float a = sum / float(SAMPLES);
#if AMPLIFICATION == 1
    a = min(1.0, a * a + a);
#endif
    access = aob_surface_is_sky(p) ? 1.0 : a;
}
