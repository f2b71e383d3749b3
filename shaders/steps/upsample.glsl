/* Edge-aware upsampling by the divisor of `low`: of the four pixels of `low` around a full pixel, bilinear weights times how far each
 * is of the same surface, asked of both: the tangent plane of a rim may meet a floor far behind. Where none is, as on
 * the rim of a curved object, the nearest in space stands in, one that faces another way counted up to three times as
 * far: no value between two depths appears. */
#include "common/surface.glsl"

/* What is written at the sky: it is open, and no bent normal belongs to it. The argument tells the type only. */
float open_sky(float like) { return 1.0; }
vec2 open_sky(vec2 like) { return vec2(1.0); }
vec4 open_sky(vec4 like) { return vec4(0.0, 0.0, 0.0, 1.0); }

void main()
{
    ivec2 p = aob_pixel, base = p / AOB_DIVISOR_LOW;
    ivec2 last = (aob_size - 1) / AOB_DIVISOR_LOW;
    vec2 part = vec2(p - base * AOB_DIVISOR_LOW) / float(AOB_DIVISOR_LOW);
    vec3 position = aob_surface(p), normal = aob_surface_normal(p), alike;
    make_unit(normal, alike);
    AOB_TYPE_LOW sum = AOB_TYPE_LOW(0.0), nearest = aob_fetch_low(base);
    float weights = 0.0, least = AOB_SKY_Z;
    for (int i = 0; i < 4; i++) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        ivec2 q = min(base + corner, last);
        vec3 other = aob_position(q * AOB_DIVISOR_LOW), other_normal = aob_normal(q * AOB_DIVISOR_LOW);
        float bilinear = (corner.x == 1 ? part.x : 1.0 - part.x) * (corner.y == 1 ? part.y : 1.0 - part.y);
        float cosine = dot(other_normal, alike);
        float w = bilinear * min(same_surface(position, normal, other, cosine),
                                 same_surface(other, other_normal, position, cosine));
        float away = length(other - position) * (2.0 - cosine);
        AOB_TYPE_LOW value = aob_fetch_low(q);
        sum += w * value;
        weights += w;
        nearest = away < least ? value : nearest;
        least = away < least ? away : least;
    }
    full = aob_surface_is_sky(p) ? open_sky(sum) : weights > 1e-3 ? sum / weights : nearest;
}
