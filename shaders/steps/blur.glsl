/* One axis of a separable cross-bilateral filter: BLUR taps (odd) along AXIS (0 x, 1 y), Gaussian with a standard
 * deviation of a quarter of the taps, times how far each tap is of the same surface. The loop is
 * unrolled everywhere: else exp() of its counter is the compiler's in one program and the device's in another, a traced
 * one, say, and their last bits differ. */
#include "common/surface.glsl"

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p), normal = aob_surface_normal(p), alike;
    make_unit(normal, alike);
    AOB_TYPE_RAW centre = aob_fetch_raw(p), sum = centre;
    float weights = 1.0;
    const float sigma = float(BLUR) / 4.0;
    [[unroll]] for (int i = -(BLUR / 2); i <= BLUR / 2; i++) {
        ivec2 q = p + (AXIS == 0 ? ivec2(i, 0) : ivec2(0, i));
        float same = same_surface(position, normal, aob_surface(q), dot(aob_surface_normal(q), alike));
        float w = i == 0 ? 0.0 : exp(-0.5 * float(i * i) / (sigma * sigma)) * same;
        sum += w * aob_fetch_raw(q);
        weights += w;
    }
    blurred = aob_surface_is_sky(p) ? centre : sum / weights;
}
