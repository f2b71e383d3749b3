/* Visibility after bounces, for each channel: what an open share of the light becomes where the rest comes back from surfaces
 * like this one (common/bounce.glsl). Nothing bounces in the sky. */
#include "common/open.glsl"
#include "common/bounce.glsl"

void main()
{
    ivec2 p = aob_pixel;
    vec3 albedo = aob_albedo(p) * (1.0 - aob_metalness(p));
    vec3 light = bounced_light(open_share(aob_fetch_open(p)), albedo);
    bounced = vec4(aob_surface_is_sky(p) ? vec3(1.0) : light, 1.0);
}
