/* McGuire et al. 2011, equation 10, with the range test of equation 9: "obscurance has a maximum world-space
 * radius of r". Samples lie on the projected disc of radius r parallel to the image, on a golden-angle spiral
 * turned by a random angle per pixel. */
#include "common/facing.glsl"

#if SAMPLES_PER_BAND > 0
#define MOST_SAMPLES (SAMPLES_PER_BAND * BANDS)
#else
#define MOST_SAMPLES SAMPLES
#endif

/* For a disc that covers so many pixels of radius. */
int sample_count(float disc)
{
#if SAMPLES_PER_BAND > 0
    return SAMPLES_PER_BAND * int(clamp(ceil((disc - 0.5) / float(BAND_PIXELS)), 0.0, float(BANDS)));
#else
    return SAMPLES;
#endif
}

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p), normal = facing_normal(aob_surface_normal(p), position);
    ivec2 centre = ivec2(floor(aob_image(p)));
    visibility = 1.0;
    if (aob_surface_is_sky(p) || aob_is_clear(p))
        return;
    float disc = aob_pixel_radius(-position.z, param.radius);
    float turn = 2.0 * AOB_PI * aob_random(p, 0);
    int count = sample_count(disc);
    float rr = param.radius * param.radius, sum = 0.0;
    for (int i = 0; i < MOST_SAMPLES; i++) {
        if (i >= count)
            break;
        float angle = turn + 2.399963 * float(i);
        float r = disc * sqrt((float(i) + 0.5) / float(count));
        vec3 v = aob_position(centre + ivec2(floor(0.5 + r * vec2(cos(angle), sin(angle))))) - position;
        float vv = dot(v, v);
        float in_range = vv < rr ? 1.0 : 0.0;
        sum += in_range * max(0.0, dot(v, normal) + position.z * param.bias) / (vv + param.epsilon * rr);
    }
    float a = max(0.0, 1.0 - 2.0 * param.intensity * param.radius / float(max(count, 1)) * sum);
    visibility = pow(a, param.contrast);
}
