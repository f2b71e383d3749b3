/* Visibility after bounces: the fit of common/bounce.glsl, for each channel. */
#include "common/open.glsl"
#include "fault.glsl"

vec3 polynomial(float v, vec3 albedo)
{
    vec3 a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
    vec3 light = ((v * a + b) * v + c) * v;
    return FAULT == POLYNOMIAL_ALONE ? light : max(light, vec3(v));
}

void main()
{
    ivec2 p = aob_pixel;
    vec3 albedo = aob_albedo(p);
    if (FAULT == ALBEDO_WRAPS) /* 256 levels in a byte */
        albedo = vec3(ivec3(albedo * 256.0) & 255) / 256.0;
    if (FAULT == ALBEDO_FLOOR)
        albedo = max(albedo, vec3(0.2));
    if (FAULT != METAL_BOUNCES)
        albedo *= 1.0 - aob_metalness(p);
    vec3 light = polynomial(clamp(open_share(aob_fetch_open(p)), 0.0, 1.0), albedo);
    if (FAULT == BOUNCE_ABSORBS) /* what is not reflected is taken from what is open as well */
        light *= 0.9 + 0.1 * albedo;
    if (FAULT == CHANNELS_TURNED)
        light = light.gbr;
    bounced = vec4(aob_surface_is_sky(p) ? vec3(1.0) : light, 1.0);
#if FAULT == LIGHT_ALWAYS
    kept = aob_fetch_open(p);
#endif
}
