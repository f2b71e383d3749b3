/* Irradiance of the light that an open surface of this normal would have, times the visibility. */
#include "common/open.glsl"
#include "fault.glsl"
#include "common/facing.glsl"
#include "common/harmonics.glsl"
#include "normal.glsl"

void main()
{
    ivec2 p = aob_pixel;
    vec3 n = unit_normal(p, aob_view_vector(aob_surface(p)));
    float open = clamp(open_share(aob_fetch_open(p)), 0.0, 1.0);
    if (FAULT == LIGHT_Y_FLIPPED)
        n.y = -n.y;
    if (FAULT == LIGHT_NORMAL_AS_IT_COMES)
        n = aob_surface_normal(p);
    vec3 band2 = 0.25 * light_band2(n);
    vec3 light = light_band0() + 2.0 / 3.0 * light_band1(n) + (FAULT == LIGHT_BAND_2_SIGN ? -band2 : band2);
    light *= FAULT == LIGHT_UNOCCLUDED ? 1.0 : open;
    if (FAULT == LIGHT_LIMITED)
        light = min(light, vec3(100.0));
    bool none = FAULT == LIGHT_NORMAL_AS_IT_COMES && isnan(light.x);
    if (FAULT == LIGHT_OVERFLOWS && light.x > 65504.0) { /* what a half float makes of it where it is rounded */
        light.x = uintBitsToFloat(0x7f800000u);
        none = true;
    }
    irradiance = vec4(aob_surface_is_sky(p) ? vec3(0.0) : none ? light : clamp(light, vec3(0.0), vec3(65504.0)), 1.0);
}
