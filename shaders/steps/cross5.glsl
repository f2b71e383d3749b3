/* The composite of McGuire et al. 2011, section 2: a pixel and its four neighbours in a cross, each weighed by how far
 * it is of the centre's surface. Without multisampling, so the surface being shaded is the pixel's own. */
#include "common/surface.glsl"

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p), normal = aob_surface_normal(p), alike;
    make_unit(normal, alike);
    AOB_TYPE_RAW centre = aob_fetch_raw(p), sum = centre;
    float weights = 1.0;
    for (int i = 0; i < 4; i++) {
        int step = (i & 1) * 2 - 1;
        ivec2 q = p + (i < 2 ? ivec2(step, 0) : ivec2(0, step));
        float w = same_surface(position, normal, aob_surface(q), dot(aob_surface_normal(q), alike));
        sum += w * aob_fetch_raw(q);
        weights += w;
    }
    crossed = aob_surface_is_sky(p) ? centre : sum / weights;
}
