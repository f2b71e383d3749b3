/* Edge-aware upsampling by FACTOR: of the four pixels of `low` around a full pixel, bilinear weights times how far each
 * is of the same surface. Where none is, the one nearest to the tangent plane stands in, so that no value between two
 * depths appears. */
#include "common/surface.glsl"

void main()
{
    ivec2 p = aob_pixel, base = p / FACTOR;
    ivec2 last = (aob_size - 1) / FACTOR;
    vec2 part = vec2(p - base * FACTOR) / float(FACTOR);
    vec3 position = aob_surface(p), normal = aob_surface_normal(p);
    float sum = 0.0, weights = 0.0, nearest = aob_fetch_low(base), least = AOB_SKY_Z;
    for (int i = 0; i < 4; i++) {
        ivec2 corner = ivec2(i & 1, i >> 1);
        ivec2 q = min(base + corner, last);
        vec3 other = aob_position(q * FACTOR);
        float bilinear = (corner.x == 1 ? part.x : 1.0 - part.x) * (corner.y == 1 ? part.y : 1.0 - part.y);
        float w = bilinear * same_surface(position, normal, other, aob_normal(q * FACTOR));
        float off_plane = abs(dot(other - position, normal));
        float value = aob_fetch_low(q);
        sum += w * value;
        weights += w;
        nearest = off_plane < least ? value : nearest;
        least = min(least, off_plane);
    }
    full = weights > 1e-3 ? sum / weights : nearest;
}
