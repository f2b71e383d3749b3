/* A cross of taps on the same surface, BLUR along each axis. */
#include "common/surface.glsl"
#include "fault.glsl"
#include "common/facing.glsl"
#include "normal.glsl"

const int HALF = BLUR / 2, TABLE = 4;

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p), normal = unit_normal(p, aob_view_vector(position));
    AOB_TYPE_RAW centre = aob_fetch_raw(p), sum = centre;
    float weights = 1.0;
    for (int i = 0; i < 4 * HALF; i++) {
        int away = i / 4 + 1, axis = i >> 1 & 1;
        bool after = (i & 1) == 0 || (FAULT == SWAPPED_TAPS && axis == 0);
        ivec2 side = after ? ivec2(away) : ivec2(-away), q = p + side * ivec2(1 - axis, axis);
        vec3 other = aob_surface(q);
        float w = 0.5 * same_surface(position, normal, other, unit_normal(q, aob_view_vector(other)));
        AOB_TYPE_RAW none = AOB_TYPE_RAW(0.0), tap = FAULT == SHORT_FILTER_TABLE && away > TABLE ? none : aob_fetch_raw(q);
        bool counts = w > 0.0 || FAULT == NAN_SPREADS;
        sum += counts ? w * tap : none;
        weights += counts ? w : 0.0;
    }
    softened = aob_surface_is_sky(p) ? centre : sum / weights;
}
