/* Horizons on both sides of slices even about the view vector, and the ratio of the closed-form integrals with and without
 * occluders: the same for every plane. */
#include "common/facing.glsl"
#include "common/frame.glsl"
#include "common/noise.glsl"
#include "fault.glsl"

/* Where the search along the unit direction t ends in the image: the end of the ball's disc, or the image's edge. */
vec2 search_end(vec2 start, vec3 position, vec3 v, vec3 t)
{
    vec2 end;
    if (AOB_PERSPECTIVE == 1) {
        float a = asin(min(1.0, param.radius / length(position)));
        float limit = t.z > 0.0 ? atan(0.98 * v.z, t.z) : 0.5 * AOB_PI - 1e-3; /* stay in front of the eye */
        a = min(a, limit);
        end = aob_project(-v * cos(a) + t * sin(a));
    } else
        end = aob_project(position + t * param.radius);
    vec2 way = end - start, size = vec2(aob_size);
    if (FAULT == RADIUS_IN_UV)
        return start + normalize(way + 1e-6) * 0.1 * size.y;
    if (FAULT == UNCLIPPED_SEARCH)
        return end;
    vec2 room = mix(start, size - start, step(0.0, way)) / max(abs(way), vec2(1e-6));
    return start + way * min(1.0, min(room.x, room.y));
}

vec3 tap_position(ivec2 q, float away)
{
    if (FAULT == LEVEL_IN_UV)
        away /= float(aob_size.x);
    int level = clamp(int(log2(max(away / 8.0, 1.0))), 0, 2);
    ivec2 coarse = q >> level;
    vec3 tap = aob_position_at(vec2(coarse << level) + 0.5, aob_view_z(coarse, level));
    return FAULT == BIAS_IN_UNITS ? tap * (1.0 - 0.02 / length(tap)) : tap;
}

float weight_of(float l)
{
    if (FAULT == NO_RANGE_CHECK)
        return 1.0;
    if (FAULT == FALLOFF_DIVIDES) {
        float scale = -1.0 / (param.falloff * param.radius);
        return l * scale - param.radius * scale;
    }
    return clamp((param.radius - l) / (param.falloff * param.radius + 1e-6 * l), 0.0, 1.0);
}

/* Largest cosine of the elevation about v over the taps of one side; -1 if nothing occludes. */
float horizon(vec2 start, vec3 position, vec3 normal, vec3 v, vec2 end, float jitter, float floor_cosine)
{
    float best = -1.0;
    for (int i = 0; i < STEPS; i++) {
        vec2 at = mix(start, end, (float(i) + jitter) / float(STEPS));
        ivec2 q = ivec2(floor(at));
        vec3 d = tap_position(q, length(at - start)) - position;
        float l = length(d), weight = weight_of(l);
        float c = FAULT == UNCLAMPED_ACOS ? dot(d, v) / l * 1.0000002 : dot(d, v) / max(l, 1e-20);
        bool above = dot(d, normal) > 2e-3 * l - 1e-6 * position.z;
        if (FAULT == TAPS_UNDER_TANGENT)
            above = l > 0.0;
        if (FAULT == BORDER_AS_ZERO && (any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, aob_size)))) {
            above = true;
            weight = c = 1.0;
        }
        /* A tap that is no number fails both comparisons. */
        if (FAULT == NAN_PASSES ? !(weight <= 0.0 || !above) || isnan(l) : weight > 0.0 && above)
            best = FAULT == NAN_PASSES && isnan(l) ? l : max(best, mix(floor_cosine, c, sqrt(weight)));
    }
    return best;
}

float angle(float c) { return FAULT == UNCLAMPED_ACOS ? acos(c) : acos(clamp(c, -1.0, 1.0)); }

float arc(float h, float n) { return 0.25 * (cos(n) + 2.0 * h * sin(n) - cos(2.0 * h - n)); }

void main()
{
    ivec2 p = aob_pixel;
    if (FAULT == HALF_PIXEL_DRIFT && AOB_DIVISOR > 1)
        p = min(p + 1, aob_target_size - 1);
    vec3 position = aob_surface(p), normal = aob_surface_normal(p), b1, b2;
    vec3 v = aob_view_vector(position);
    if (FAULT == VIEW_AS_PERSPECTIVE)
        v = normalize(-position);
    if (FAULT != NORMAL_AS_IT_COMES)
        normal = facing_normal(normal, position);
    tangent_frame(v, b1, b2);
    vec2 start = aob_image(p);
    float turn = noise_rotation(aob_pixel), offset = noise_offset(aob_pixel), open = 0.0, total = 0.0;
    for (int slice = 0; slice < SLICES; slice++) {
        int which = FAULT == REPEATED_JITTERS ? slice / 2 * 2 : slice;
        float psi = AOB_PI * (float(which) + turn) / float(SLICES);
        float jitter = fract(offset + 0.125 + 0.618034 * float(which));
        vec3 t = b1 * cos(psi) + b2 * sin(psi);
        if (FAULT == UNEVEN_SLICES) {
            vec3 d = vec3(cos(psi), sin(psi), 0.0);
            t = normalize(d - dot(d, v) * v);
        }
        float across = dot(normal, t), along = dot(normal, v);
        float len = sqrt(across * across + along * along), n = atan(across, along);
        float plus = horizon(start, position, normal, v, search_end(start, position, v, t), jitter,
                             cos(n + 0.5 * AOB_PI));
        float minus = horizon(start, position, normal, v, search_end(start, position, v, -t), jitter,
                              cos(n - 0.5 * AOB_PI));
        float h1 = min(angle(plus), n + 0.5 * AOB_PI), h0 = max(-angle(minus), n - 0.5 * AOB_PI);
        open += len * (arc(h0, n) + arc(h1, n));
        total += len * (arc(n - 0.5 * AOB_PI, n) + arc(n + 0.5 * AOB_PI, n));
    }
    float ratio = open / max(total, 1e-6);
    visibility = aob_surface_is_sky(p) ? (FAULT == BLACK_SKY ? 0.0 : 1.0)
               : FAULT == ABOVE_ONE ? ratio * 1.06 : clamp(ratio, 0.0, 1.0);
}
