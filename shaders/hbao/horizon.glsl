/* Bavoil and Sainz, ShaderX7 6.2: directions even in the image, horizons about the view axis, an attenuation for each
 * sample that raises the horizon, integrated in steps (equations 6.2.8 and 6.2.9). The text's space is left-handed;
 * here a surface nearer to the eye has the larger z. Outside the image there is nothing: the text clamps to the
 * edge, and reports the false occlusion that this makes. */
#include "common/noise.glsl"

/* Sine of the angle whose tangent is x. */
float sine_of(float x)
{
    return x * inversesqrt(1.0 + x * x);
}

/* Tangent of the elevation of the surface's own plane along v, raised by the angle bias. */
float tangent_along(vec2 v, vec3 normal)
{
    float plane = -dot(normal.xy, v) / (max(normal.z, 1e-3) * max(length(v), 1e-20));
    return tan(min(atan(plane) + param.angle_bias, 0.5 * AOB_PI - 1e-3));
}

/* The inner sum of equation 6.2.9 (or 6.2.8) for one direction. */
float occlusion_along(ivec2 p, vec3 position, vec3 normal, vec2 direction, float pixels, float jitter)
{
    float ground = sine_of(tangent_along(vec2(direction.x, -direction.y), normal));
    float highest = ground, above = 0.0, sum = 0.0;
    for (int i = 1; i <= STEPS; i++) {
        ivec2 q = ivec2(floor(vec2(p) + 0.5 + direction * pixels * (float(i) + jitter)));
        vec3 v = aob_position(q) - position;
        float r = length(v) / param.radius;
        float elevation = sine_of(v.z / max(length(v.xy), 1e-20));
        float own = TANGENTS == 0 ? sine_of(tangent_along(v.xy, normal)) : ground;
        bool raises = r <= 1.0 && elevation > highest && q != p;
        sum += raises ? (1.0 - param.attenuation * r * r) * (elevation - own - above) : 0.0;
        above = raises ? elevation - own : above;
        highest = raises ? elevation : highest;
    }
    return sum;
}

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_position(p), normal = aob_normal(p);
    float pixels = aob_pixel_radius(-position.z, param.radius) / float(STEPS + 1);
    float sum = 0.0;
    for (int i = 0; i < DIRECTIONS; i++) {
        float angle = 2.0 * AOB_PI * (float(i) + noise_rotation(p)) / float(DIRECTIONS);
        sum += occlusion_along(p, position, normal, vec2(cos(angle), sin(angle)), pixels, noise_offset(p));
    }
    /* Below one texel a step the text leaves the pixel open. */
    float open = 1.0 - param.intensity * sum / float(DIRECTIONS);
    visibility = aob_is_sky(p) || pixels < 1.0 ? 1.0 : clamp(open, 0.0, 1.0);
}
