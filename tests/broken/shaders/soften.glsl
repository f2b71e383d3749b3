/* A cross of five taps on the same surface. */
#include "common/surface.glsl"
#include "fault.glsl"

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p), normal = aob_surface_normal(p), alike;
    make_unit(normal, alike);
    if (FAULT == NORMAL_AS_IT_COMES)
        normal = alike = aob_surface_normal(p);
    float centre = aob_fetch_raw(p), sum = centre, weights = 1.0;
    for (int i = 0; i < 4; i++) {
        ivec2 q = p + (i < 2 ? ivec2(2 * i - 1, 0) : ivec2(0, 2 * i - 5));
        if (FAULT == SWAPPED_TAPS)
            q = p + (i < 2 ? ivec2(i + 1, 0) : ivec2(0, i - 1));
        float w = 0.5 * same_surface(position, normal, aob_surface(q), dot(aob_surface_normal(q), alike));
        float tap = aob_fetch_raw(q);
        sum += w > 0.0 ? w * tap : 0.0;
        weights += w > 0.0 ? w : 0.0;
    }
    softened = aob_surface_is_sky(p) ? centre : sum / weights;
}
