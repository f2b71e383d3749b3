/* Bavoil and Sainz, ShaderX7 6.2: directions even in the image, horizons about the view axis, an attenuation for each
 * sample that raises the horizon, integrated in steps (equations 6.2.8 and 6.2.9). The text's space is left-handed;
 * here a surface nearer to the eye has the larger z. Outside the image there is nothing: the text clamps to the
 * edge, and reports the false occlusion that this makes. A direction's steps are even up to the image's edge. */
#include "common/bent.glsl"
#include "common/facing.glsl"
#include "common/mean.glsl"
#include "common/search.glsl"

/* Sine of the elevation of the surface's own plane along v, raised by the angle bias; 1 from the zenith on. */
float tangent_along(vec2 v, vec3 normal)
{
    vec2 plane = vec2(max(normal.z, 1e-3) * length(v), -dot(normal.xy, v));
    plane *= inversesqrt(max(dot(plane, plane), 1e-30));
    vec2 bias = vec2(cos(param.angle_bias), sin(param.angle_bias));
    return plane.x * bias.x > plane.y * bias.y ? plane.y * bias.x + plane.x * bias.y : 1.0;
}

/* The integral over the elevations up to the one of this sine, along azimuth v: 0 to 1 from the tangent to the zenith
 * on average over the azimuths. Uniform weighting as in equation 6.2.5; with the cosine to the normal likewise. */
float share_below(float sine, vec2 v, vec3 normal)
{
#if WEIGHTING == 1
    return sine;
#else
    float lean = dot(normal.xy, v) * inversesqrt(max(dot(v, v), 1e-30));
    float cosine = sqrt(max(0.0, 1.0 - sine * sine));
    return lean * (atan(sine, cosine) + sine * cosine) + normal.z * sine * sine;
#endif
}

/* The same integral of the direction itself, not in the text. */
vec3 mean_below(float sine, vec2 v, vec3 normal)
{
    vec2 along = v * inversesqrt(max(dot(v, v), 1e-30));
    float cosine = sqrt(max(0.0, 1.0 - sine * sine));
#if WEIGHTING == 1
    vec2 mean = 0.5 * vec2(atan(sine, cosine) + sine * cosine, sine * sine);
#else
    float lean = dot(normal.xy, along), cube = cosine * cosine * cosine;
    vec2 mean = 2.0 / 3.0 * vec2(lean * sine * (3.0 - sine * sine) - normal.z * cube,
                                 normal.z * sine * sine * sine - lean * cube);
#endif
    return vec3(along * mean.x, mean.y);
}

/* View-space point of sample i, 1 to STEPS, of a direction. */
vec3 sample_of(vec2 start, vec2 step_size, float jitter, int i)
{
#if SNAPPING == 1
    ivec2 first = ivec2(floor(start + step_size * (1.0 + jitter)));
    return aob_position(first + (i - 1) * ivec2(floor(step_size + 0.5)));
#else
    vec2 q = start + step_size * (float(i) + jitter);
    return SNAPPING == 0 ? aob_position(ivec2(floor(q))) : aob_position_at(q, aob_view_z(ivec2(floor(q))));
#endif
}

/* The inner sum of equation 6.2.9 (or 6.2.8) for one direction; in xyz the same sum of the closed directions. */
vec4 occlusion_along(vec2 start, vec3 position, vec3 normal, vec2 step_size, float jitter)
{
    step_size *= share_in_image(start, start + step_size * float(STEPS + 1));
    vec2 along = vec2(step_size.x, -step_size.y);
    float ground = tangent_along(along, normal), highest = ground;
    vec4 above = vec4(0.0), sum = vec4(0.0);
    for (int i = 1; i <= STEPS; i++) {
        vec3 v = sample_of(start, step_size, jitter, i) - position;
        float l = length(v), r = l / param.radius, elevation = v.z / max(l, 1e-20);
        vec2 own = TANGENTS == 0 ? v.xy : along;
        float tangent = TANGENTS == 0 ? tangent_along(own, normal) : ground;
        vec4 grown = vec4(mean_below(elevation, own, normal) - mean_below(tangent, own, normal),
                          share_below(elevation, own, normal) - share_below(tangent, own, normal));
        /* A sample on the point itself has no elevation. One in the surface's own plane closes nothing: seen edge on, that plane
         * has every elevation. A normal of 8 bits leans by a degree. A tangent of the direction does not know in which
         * plane a sample lies. */
        float least = -1e-6 * position.z + (TANGENTS == 0 ? 0.02 * l : 0.0);
        float off_plane = TANGENTS == 0 ? dot(normal.xy, v.xy) + normal.z * v.z : l;
        bool raises = r <= 1.0 && elevation > highest && off_plane > least;
        sum += raises ? (1.0 - param.attenuation * r * r) * (grown - above) : vec4(0.0);
        above = raises ? grown : above;
        highest = raises ? elevation : highest;
    }
    return sum;
}

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p), normal = facing_normal(aob_surface_normal(p), position);
    vec4 jitter = aob_fetch_jitter(p & 3);
    float pixels = aob_pixel_radius(-position.z, param.radius) / float(STEPS + 1);
    vec4 sum = vec4(0.0);
    vec3 open = normal * (WEIGHTING == 1 ? 0.5 : 2.0 / 3.0); /* the mean over the whole hemisphere */
    visibility = open_of(1.0, open);
    if (aob_surface_is_sky(p) || pixels < param.min_step || aob_is_clear(p))
        return;
    for (int i = 0; i < DIRECTIONS; i++) {
        float angle = 2.0 * AOB_PI * float(i) / float(DIRECTIONS);
        vec2 d = vec2(cos(angle), sin(angle));
        d = vec2(d.x * jitter.x - d.y * jitter.y, d.x * jitter.y + d.y * jitter.x);
        sum += occlusion_along(aob_image(p), position, normal, d * pixels, jitter.z);
    }
    sum /= float(DIRECTIONS);
    visibility = open_of(clamp(1.0 - param.intensity * sum.w, 0.0, 1.0), bounded_mean(open - sum.xyz));
}
