/* Specular occlusion from visibility, view and roughness alone (Lagarde and de Rousiers 2014). */
#include "common/open.glsl"
#include "fault.glsl"
#include "common/facing.glsl"
#include "normal.glsl"

void main()
{
    ivec2 p = aob_pixel;
    vec3 v = aob_view_vector(aob_surface(p)), n = unit_normal(p, v);
    float rough = aob_roughness(p), open = clamp(open_share(aob_fetch_open(p)), 0.0, 1.0);
    float facing = max(dot(n, v), 0.0);
    float share = pow(max(facing + open, 0.0), exp2(-16.0 * rough - 1.0)) - 1.0 + open;
    if (FAULT == LOBE_BELOW_PLANE) /* what of the lobe lies below the surface is taken for closed */
        share *= clamp(0.5 + 0.5 * facing / max(rough, 0.01), 0.0, 1.0);
    specular = aob_surface_is_sky(p) ? 1.0 : FAULT == LOBE_UNCLAMPED ? share : clamp(share, 0.0, 1.0);
}
