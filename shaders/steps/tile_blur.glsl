/* Mean over a tile of 4x4 pixels with equal weights, for noise that repeats every four pixels. An even box has no middle
 * pixel: this one is 4 wide about the pixel's centre, so of 5x5 taps the outer ones weigh one half, and the filter is
 * its own mirror image and transpose. Each of the 16 places in the tile weighs the same. A tap counts if it lies within
 * param.blur_tolerance, a share of the depth, of the centre's tangent plane: a surface seen at a flat angle is one
 * surface, and nothing is mixed over a depth edge. */
#include "common/surface.glsl"

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p), normal = aob_surface_normal(p), alike;
    make_unit(normal, alike);
    AOB_TYPE_RAW centre = aob_fetch_raw(p), sum = AOB_TYPE_RAW(0.0);
    float weights = 0.0;
    for (int y = -2; y <= 2; y++)
        for (int x = -2; x <= 2; x++) {
            ivec2 q = p + ivec2(x, y);
            float off_plane = abs(dot(aob_surface(q) - position, normal));
            float w = (abs(x) == 2 ? 0.5 : 1.0) * (abs(y) == 2 ? 0.5 : 1.0);
            w = off_plane <= -position.z * param.blur_tolerance ? w : 0.0;
            sum += w * aob_fetch_raw(q);
            weights += w;
        }
    blurred = !aob_surface_is_sky(p) && weights > 0.0 ? sum / weights : centre; /* none: the normal is no number */
}
