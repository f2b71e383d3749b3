/* The mean over time (docs/decisions/0048). Each surface finds by its velocity what the frames before said of it. The four pixels about
 * its old place must show the same surface, by the plane and by the normal: a mean of fewer would lean away from every crease. There
 * are HISTORY frames that count at most: up to that many count alike, then the newest is one in so many and the old ones fade. What
 * was not read at the centre of a pixel counts as RESAMPLED frames at most, since each such reading bends the image a little. Where
 * something within the radius has changed, nothing of before counts. What is kept: the mean, and of the surface its normal times its
 * depth and the frames that count. */
#include "common/surface.glsl"

const float RESAMPLED = 3.0;

/* Bits of a share rise with it; those of what is no number lie above. Rounding may pass 1. */
bool is_share(float x) { return floatBitsToUint(abs(x)) <= floatBitsToUint(1.001); }
bool is_open(float open) { return is_share(open); }
bool is_open(vec4 open) { return is_share(open.w) && is_share(0.98 * dot(open.xyz, open.xyz)); }

/* A value as weights below 0 leave it, in its range again. */
float in_range(float open) { return clamp(open, 0.0, 1.0); }
vec4 in_range(vec4 open) { return vec4(open.xyz / max(1.0, length(open.xyz)), in_range(open.w)); }

/* The same in view space of now. */
float turned(float open) { return open; }
vec4 turned(vec4 open) { return vec4(aob_direction_now(open.xyz), open.w); }

/* `other` moved by what rounding may have moved it away from the tangent plane of `place`: both depths, along the line of sight, which
 * crosses the plane. */
vec3 unrounded(vec3 place, vec3 normal, vec3 other, float then)
{
    if (AOB_DEPTH_EXACT == 1)
        return other;
    float lean = AOB_PERSPECTIVE == 1 ? dot(other, normal) / other.z : normal.z;
    float slack = abs(lean) * (aob_depth_error(-place.z) + aob_depth_error(then));
    return other - normal * clamp(dot(other - place, normal), -slack, slack);
}

/* Whether the pixel of before at q shows the surface at `place`; what it holds, and how many frames that is of. */
bool shows(ivec2 q, vec3 place, vec3 normal, out AOB_TYPE_NOW open, out float frames)
{
    vec4 surface = aob_fetch_surface_before(q);
    float z = length(surface.xyz);
    open = aob_fetch_open_before(q);
    frames = surface.w;
    bool held = q == clamp(q, ivec2(0), aob_size - 1) && !aob_no_depth(z) && is_open(open);
    vec3 other = unrounded(place, normal, aob_position_at(vec2(q) + 0.5, z), z);
    return held && same_surface(place, normal, other, surface.xyz / z) > 0.5;
}

/* Weights of four samples in a row for a place a share t from the second to the third (Catmull and Rom 1974). */
vec4 cubic(float t)
{
    return vec4(t * (-0.5 + t * (1.0 - 0.5 * t)), 1.0 + t * t * (1.5 * t - 2.5), t * (0.5 + t * (2.0 - 1.5 * t)), 0.5 * t * t * (t - 1.0));
}

/* The mean of before, and how many frames it is of; 0: there is none. */
float recall(vec3 then, vec3 normal, out AOB_TYPE_NOW mean)
{
    vec3 place = aob_position_at(then.xy, then.z);
    ivec2 base = ivec2(floor(then.xy - 0.5));
    vec2 part = fract(then.xy - 0.5);
    vec4 x = cubic(part.x), y = cubic(part.y);
    AOB_TYPE_NOW inner = AOB_TYPE_NOW(0.0), all = AOB_TYPE_NOW(0.0), open;
    float frames = 0.0, count;
    bool within = true, around = true;
    bool resampled = max(part.x, part.y) > 0.0;
    for (int i = 0; i < (resampled ? 16 : 1); i++) {
        int k = (i + 5) & 15; /* the pixel of the old place first: it alone counts where that is its centre */
        ivec2 corner = ivec2(k & 3, k >> 2) - 1;
        bool same = shows(base + corner, place, normal, open, count), middle = corner == clamp(corner, ivec2(0), ivec2(1));
        vec2 share = mix(1.0 - part, part, vec2(corner));
        float w = middle ? share.x * share.y : 0.0;
        within = within && (same || w < 0.001);
        around = around && same;
        inner += w > 0.0 && same ? w * open : AOB_TYPE_NOW(0.0);
        frames += w > 0.0 && same ? w * count : 0.0;
        all += same ? x[k & 3] * y[k >> 2] * open : AOB_TYPE_NOW(0.0);
    }
    mean = turned(around && resampled ? in_range(all) : inner);
    return !within ? 0.0 : resampled ? min(frames, RESAMPLED) : frames;
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
