/* The mean over time (docs/decisions/0048). Each surface finds by its velocity what the frames before said of it, in those of the four
 * pixels about its old place that show the same surface: by the plane and by the normal. There are HISTORY frames that count at most:
 * up to that many count alike, then the newest is one in so many and the old ones fade. Where something within the radius has
 * changed, nothing of before counts. What is kept: the mean, and of the surface its normal times its depth and the frames that
 * count. */
#include "common/surface.glsl"

/* Bits of a share rise with it; those of what is negative or no number lie above. */
bool is_share(float x) { return floatBitsToUint(x) <= floatBitsToUint(1.0); }
bool is_open(float open) { return is_share(open); }
bool is_open(vec4 open) { return is_share(open.w) && is_share(0.99 * dot(open.xyz, open.xyz)); }

/* The mean of before, and how many frames it is of; 0: there is none. */
float recall(vec3 then, vec3 normal, out AOB_TYPE_NOW mean)
{
    vec3 place = aob_position_at(then.xy, then.z);
    ivec2 base = ivec2(floor(then.xy - 0.5));
    vec2 part = fract(then.xy - 0.5);
    float weights = 0.0, frames = 0.0;
    mean = AOB_TYPE_NOW(0.0);
    for (int k = 0; k < 4; k++) {
        ivec2 corner = ivec2(k & 1, k >> 1), q = base + corner;
        vec2 share = mix(1.0 - part, part, vec2(corner));
        vec4 surface = aob_fetch_surface_before(q);
        float z = length(surface.xyz), w = share.x * share.y;
        AOB_TYPE_NOW open = aob_fetch_open_before(q);
        bool inside = q == clamp(q, ivec2(0), aob_size - 1);
        if (!inside || aob_no_depth(z) || !is_open(open) || w == 0.0)
            continue;
        w *= same_surface(place, normal, aob_position_at(vec2(q) + 0.5, z), surface.xyz / z);
        mean += w * open;
        frames += w * surface.w;
        weights += w;
    }
    mean /= max(weights, 1e-6);
    return weights > 0.1 ? frames / weights : 0.0;
}

void main()
{
    ivec2 p = aob_pixel;
    vec3 normal = aob_surface_normal(p), then = aob_before(p), alike;
    make_unit(normal, alike);
    AOB_TYPE_NOW now = aob_fetch_now(p), mean = now;
    float frames = 0.0;
    if (!aob_surface_is_sky(p) && !aob_no_depth(then.z) && aob_fetch_changed(p / AOB_DIVISOR_CHANGED) < 0.5)
        frames = recall(then, aob_direction_before(normal), mean);
    frames = min(frames + 1.0, float(HISTORY));
    open = frames > 1.0 ? mix(mean, now, 1.0 / frames) : now;
    surface = aob_surface_is_sky(p) ? vec4(0.0) : vec4(normal * aob_surface_z(p), frames);
}
