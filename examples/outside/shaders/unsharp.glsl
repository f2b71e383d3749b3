#include "common/noise.glsl"

/* How far the surface in pixel q lies before depth z: in radii, at most one. */
float nearer(ivec2 q, float z)
{
    return clamp((z - aob_view_z(q)) / param.radius, -1.0, 1.0);
}

void main()
{
    ivec2 p = aob_pixel;
    float z = aob_view_z(p), sum = 0.0;
    for (int i = 0; i < SAMPLES; i++) {
        float angle = AOB_PI * (noise_rotation(p) + 0.618034 * float(i));
        float u = (float(i) + 0.5) / float(SAMPLES);
        float r = 0.5 * param.kernel * sqrt(-2.0 * log(u)); /* the share u of a Gaussian lies farther out */
        ivec2 d = ivec2(floor(0.5 + r * vec2(cos(angle), sin(angle))));
        sum += nearer(p + d, z) + nearer(p - d, z);
    }
    float shade = max(0.0, sum / float(2 * SAMPLES));
    visibility = aob_is_sky(p) ? 1.0 : clamp(1.0 - param.strength * shade, 0.0, 1.0);
}
