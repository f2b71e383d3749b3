/* Bavoil and Sainz, ShaderX7 6.2, with ray marching: rays in the hemisphere about the normal, even steps in space from
 * P to the end at distance R; the first sample below the height field counts. A sample of the depth under P's tangent
 * plane cannot stop a ray that rises from it: without that test the half pixel between a step and its texel's centre
 * darkens tilted planes. The plane is raised by a degree, since a normal of 8 bits leans by as much. Outside the image
 * there is nothing: a ray that leaves it ends there, and its steps are even up to there. */
#include "common/bent.glsl"
#include "common/facing.glsl"
#include "common/frame.glsl"
#include "common/mean.glsl"
#include "common/noise.glsl"
#include "common/search.glsl"

/* What the ray from `position` along unit vector d adds: W of its hit, or 0. */
float occlusion_along(vec3 position, vec3 normal, vec3 d)
{
    d *= param.radius * share_in_view(position, position + d * param.radius);
    for (int i = 1; i <= STEPS; i++) {
        vec3 x = position + d * (float(i) / float(STEPS));
        ivec2 q = ivec2(floor(aob_project(x)));
        vec3 s = aob_position(q);
        vec3 v = s - position;
        float l = length(v), r = l / param.radius;
        bool above_plane = dot(v, normal) > 0.02 * l - 1e-6 * position.z;
        if (x.z < s.z && r <= 1.0 && above_plane)
            return 1.0 - param.attenuation * r * r;
    }
    return 0.0;
}

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p), normal = facing_normal(aob_surface_normal(p), position), b1, b2;
    float sum = 0.0;
    vec3 open = normal * (WEIGHTING == 1 ? 0.5 : 2.0 / 3.0); /* the mean over the whole hemisphere */
    vec3 away = vec3(0.0);
    visibility = open_of(1.0, open);
    if (aob_is_clear(p))
        return;
    tangent_frame(normal, b1, b2);
    for (int i = 0; i < DIRECTIONS && !aob_surface_is_sky(p); i++) {
        float angle = 2.0 * AOB_PI * (float(i) + noise_rotation(p)) / float(DIRECTIONS);
        float offset = fract(noise_offset(p) + 0.125 + 0.618034 * float(i));
        vec3 along = b1 * cos(angle) + b2 * sin(angle);
        for (int k = 0; k < RAYS; k++) {
            /* Of a share u of the hemisphere's weight: every ray weighs the same. */
            float u = (float(k) + offset) / float(RAYS);
            float rise = WEIGHTING == 1 ? 1.0 - u : sqrt(1.0 - u);
            vec3 d = normal * rise + along * sqrt(max(0.0, 1.0 - rise * rise));
            float closed = occlusion_along(position, normal, d);
            sum += closed;
            away += closed * d;
        }
    }
    const float rays = float(DIRECTIONS * RAYS);
    visibility = open_of(clamp(1.0 - sum / rays, 0.0, 1.0), bounded_mean(open - away / rays));
}
