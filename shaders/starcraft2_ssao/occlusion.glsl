/* Filion 2010, listings 1.2.2 to 1.2.6: offsets mirrored by a random normal per pixel, flipped into the hemisphere of
 * the surface's normal, and each point's depth compared with the depth buffer's. */
#include "common/facing.glsl"

float blocked(float delta, float full, float none, float power, int row)
{
#if BLOCKER == 1
    return aob_fetch_blocker(ivec2(floor(clamp(delta / none, 0.0, 1.0) * 255.0 + 0.5), row));
#else
    float fall = clamp((none - delta) / (none - full), 0.0, 1.0);
    return delta > param.epsilon ? pow(fall, power) : 0.0;
#endif
}

/* Weighted mean occlusion of the offsets first..end-1. */
float occlusion(vec3 normal, int first, int end, float radius, float full, float none, float power, int row)
{
    vec3 position = aob_surface(aob_pixel);
    vec3 mirror = normalize(aob_fetch_noise(aob_pixel % NOISE_SIZE).xyz * 2.0 - 1.0);
    float pixels = aob_pixel_radius(-position.z, radius) * float(AOB_DEPTH_DIVISOR);
    float reach = param.max_screen_radius > 0.0 ? min(1.0, param.max_screen_radius / pixels) : 1.0;
    float sum = 0.0, weights = 0.0;
    for (int i = first; i < SAMPLES * NEAR_FACTOR; i++) {
        if (i >= end)
            break;
        vec4 offset = aob_fetch_offset(ivec2(i, 0));
        vec3 ray = offset.xyz - 2.0 * dot(offset.xyz, mirror) * mirror;
        ray *= dot(ray, normal) < 0.0 ? -1.0 : 1.0;
        vec3 point = position + radius * reach * ray;
        float block = 0.0;
        if (point.z < 0.0) {
            vec3 surface = aob_position(ivec2(floor(aob_project(point))));
            /* The depth is that of a texel's centre, not of the point's own place: on a slanted plane it would occlude
             * itself. What lies in the tangent plane cannot stand before a point above it. */
            bool above = dot(surface - position, normal) > param.epsilon;
            block = above ? blocked(surface.z - point.z, full, none, power, row) : 0.0;
        }
        sum += offset.w * block;
        weights += offset.w;
    }
    return sum / weights;
}

void main()
{
    float z = aob_surface_z(aob_pixel);
    visibility = 1.0;
    if (aob_is_clear(aob_pixel))
        return;
    vec3 normal = facing_normal(aob_surface_normal(aob_pixel), aob_surface(aob_pixel));
    int count = int(float(SAMPLES) * clamp(NEAR_DISTANCE / z, 1.0, float(NEAR_FACTOR)));
#if RADII == 1
    float small = occlusion(normal, 0, count / 4, param.small_radius, param.small_full_occlusion,
                            param.small_no_occlusion, param.small_power, 1);
    float wide =
        occlusion(normal, count / 4, count, param.radius, param.full_occlusion, param.no_occlusion, param.power, 0);
    float dark = max(small, wide);
#else
    float dark = occlusion(normal, 0, count, param.radius, param.full_occlusion, param.no_occlusion, param.power, 0);
#endif
    visibility = aob_surface_is_sky(aob_pixel) ? 1.0 : 1.0 - dark;
}
