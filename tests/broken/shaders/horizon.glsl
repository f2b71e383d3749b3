/* Horizons on both sides of slices even about the view vector, and the ratio of the closed-form integrals with and without
 * occluders: the same for every plane. */
#include "common/bent.glsl"
#include "common/noise.glsl"
#include "common/frame.glsl"
#include "fault.glsl"
#include "common/facing.glsl"
#include "normal.glsl"

/* Where a pixel stands at depth z. */
vec3 place_at(vec2 q, float z)
{
    vec3 place = aob_position_at(q, z);
    return FAULT == VIEW_AS_PERSPECTIVE && AOB_PERSPECTIVE == 0 ? place * vec3(z, z, 1.0) : place;
}

/* Where the search along the unit direction t ends in the image: the end of the ball's disc, or the image's edge. */
vec2 search_end(vec2 start, vec3 position, vec3 v, vec3 t)
{
    vec2 end;
    if (AOB_PERSPECTIVE == 1) {
        float a = asin(min(1.0, param.radius / length(position)));
        float limit = t.z > 0.0 ? atan(0.98 * v.z, t.z) : 0.5 * AOB_PI - 1e-3; /* stay in front of the eye */
        a = min(a, limit);
        end = aob_project(-v * cos(a) + t * sin(a));
    } else if (FAULT == VIEW_AS_PERSPECTIVE)
        end = aob_project((position + t * param.radius) / -position.z);
    else
        end = aob_project(position + t * param.radius);
    vec2 way = end - start, size = vec2(aob_size);
    if (FAULT == RADIUS_IN_UV)
        return start + normalize(way + 1e-6) * 0.1 * size.y;
    if (FAULT == RADIUS_IN_PIXELS)
        return start + normalize(way + 1e-6) * 12.0;
    if (FAULT == UNCLIPPED_SEARCH || FAULT == BORDER_AS_ZERO)
        return end;
    vec2 room = mix(start, size - start, step(0.0, way)) / max(abs(way), vec2(1e-6));
    return start + way * min(1.0, min(room.x, room.y));
}

vec3 tap_position(ivec2 q, float away)
{
    if (FAULT == LEVEL_IN_UV)
        away /= float(aob_size.x);
    int level = away < 8.0 ? 0 : 1;
    ivec2 coarse = q >> level;
    vec3 tap = place_at(vec2(coarse << level) + 0.5, aob_view_z(coarse, level));
    return FAULT == BIAS_IN_UNITS ? tap * (1.0 + 0.02 / length(tap)) : tap;
}

float distance_to(vec3 d)
{
    float square = dot(d, d);
    return sqrt(FAULT == SQUARES_IN_HALVES ? unpackHalf2x16(packHalf2x16(vec2(square))).x : square);
}

float weight_of(float l)
{
    if (FAULT == NO_RANGE_CHECK)
        return 1.0;
    if (FAULT == FALLOFF_DIVIDES) {
        float scale = -1.0 / (param.falloff * param.radius);
        return min(l * scale - param.radius * scale, 1.0);
    }
    return clamp((param.radius - l) / (param.falloff * param.radius + 1e-6 * l), 0.0, 1.0);
}

/* Cosine of the highest elevation about v over the taps of one side; floor_cosine, that of the tangent plane, if nothing
 * occludes. What rises above that plane by less than a degree is the plane itself, read of a rounded normal. */
float horizon(vec2 start, vec3 position, vec3 normal, vec3 v, vec2 end, float jitter, float floor_cosine)
{
    float best = floor_cosine;
    for (int i = 0; i < STEPS; i++) {
        vec2 at = mix(start, end, (float(i) + jitter) / float(STEPS));
        ivec2 q = ivec2(floor(at));
        vec3 d = tap_position(q, length(at - start)) - position;
        float l = distance_to(d), weight = weight_of(l), c = dot(d, v) / max(l, 1e-20);
        float least = FAULT == FAR_PLANE_COUNTS ? 1e-3 * param.aob_range.y : 0.02 * l;
        bool above = dot(d, normal) > least - 1e-6 * position.z || (FAULT == TAPS_UNDER_TANGENT && dot(normal, v) < 0.3);
        if (FAULT == BORDER_AS_ZERO && (any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, aob_size)))) {
            above = true;
            weight = 0.01;
            c = 1.0;
        }
        if (FAULT == NAN_PASSES && isnan(l))
            return l;
        /* A tap that is no number fails both comparisons. */
        if (weight > 0.0 && above)
            best = max(best, mix(floor_cosine, c, sqrt(weight)));
    }
    return best;
}

float arc(float h, float n) { return 0.25 * (cos(n) + 2.0 * h * sin(n) - cos(2.0 * h - n)); }

/* The same of the direction itself, along the slice's direction and along v. */
vec2 arc_mean(float h, float n)
{
    return vec2(6.0 * sin(h - n) - sin(3.0 * h - n) + 8.0 * sin(n) - 3.0 * sin(h + n),
                4.0 * cos(n) - cos(3.0 * h - n) - 3.0 * cos(h + n)) / 12.0;
}

/* The angle from v of the normal's part in the slice of v and t. */
float lean_of(vec3 normal, vec3 v, vec3 t)
{
    float whole = FAULT == UNCLAMPED_ACOS ? acos(dot(normal, v)) : 0.0; /* none where the product rounds above 1 */
    return isnan(whole) ? whole : atan(dot(normal, t), dot(normal, v));
}

/* Direction of slice k of the pixel, perpendicular to v. */
vec3 direction_of(float psi, vec3 v)
{
    vec3 b1, b2;
    if (FAULT == UNEVEN_SLICES) { /* even in the image */
        vec3 along = vec3(cos(psi), sin(psi), 0.0);
        return normalize(along - v * dot(along, v));
    }
    tangent_frame(v, b1, b2);
    if (FAULT == SINGULAR_FRAME && AOB_PERSPECTIVE == 1) {
        float a = 1.0 / (1.0 - v.z);
        b1 = vec3(1.0 - v.x * v.x * a, -v.x * v.y * a, v.x);
        b2 = vec3(-v.x * v.y * a, 1.0 - v.y * v.y * a, v.y);
    }
    return b1 * cos(psi) + b2 * sin(psi);
}

/* Sums over the slices: x with the occluders, y without; and of the directions that are closed. */
vec2 gather(vec2 start, vec3 position, vec3 normal, vec3 v, out vec3 closed)
{
    vec2 sums = vec2(0.0);
    closed = vec3(0.0);
    ivec2 tile = aob_pixel;
    if (FAULT == NOISE_ABOUT_MIDDLE)
        tile -= aob_target_size / 2;
    int frame = HISTORY > 1 ? aob_frame : 5; /* the text's sixth turns nothing, and its first four offsets are 0 */
    float turn = fract(noise_rotation(tile) + noise_frame_rotation(frame));
    float offset = noise_offset(tile) + noise_frame_offset(frame);
    if (FAULT == BENT_NOISE)
        offset += 0.3 * float(BENT);
    if (FAULT == LIGHT_NOISE)
        offset += 0.3 * float(LIGHT);
    for (int slice = 0; slice < SLICES; slice++) {
        int which = FAULT == REPEATED_JITTERS ? slice / 2 * 2 : slice;
        vec3 t = direction_of(AOB_PI * (float(which) + turn) / float(SLICES), v);
        float jitter = fract(offset + 0.125 + 0.618034 * float(which));
        float len = length(vec2(dot(normal, t), dot(normal, v))), n = lean_of(normal, v, t);
        float low = n - 0.5 * AOB_PI, high = n + 0.5 * AOB_PI;
        float plus = horizon(start, position, normal, v, search_end(start, position, v, t), jitter, cos(high));
        float minus = horizon(start, position, normal, v, search_end(start, position, v, -t), jitter, cos(low));
        if (isnan(plus + minus)) /* only a fault hands it on */
            return vec2(plus + minus);
        float h1 = min(acos(clamp(plus, -1.0, 1.0)), high), h0 = max(-acos(clamp(minus, -1.0, 1.0)), low);
        vec2 mean = arc_mean(low, n) + arc_mean(high, n) - arc_mean(h0, n) - arc_mean(h1, n);
        if (FAULT == BENT_ROTATED) /* what is open, in slices that a rotation from the axis took out of their planes */
            t = vec3(cos(AOB_PI * (float(which) + turn) / float(SLICES)), sin(AOB_PI * (float(which) + turn) / float(SLICES)), 0.0);
        if (FAULT == BENT_ROTATED)
            mean = arc_mean(h0, n) + arc_mean(h1, n);
        closed += len * ((FAULT == BENT_MIRRORED ? -mean.x : mean.x) * t + mean.y * v);
        sums += len * vec2(arc(FAULT == ONE_SIDED ? low : h0, n) + arc(h1, n), arc(low, n) + arc(high, n));
    }
    return sums;
}

/* The depth of a block of low pixel p, of its first pixel or of all four at its corner. */
float depth_of(ivec2 p)
{
    ivec2 f = p * AOB_DIVISOR, last = aob_size - 1;
    if (FAULT != MEAN_DEPTH || AOB_DIVISOR == 1)
        return aob_surface_z(p);
    return 0.25 * (aob_view_z(f) + aob_view_z(min(f + ivec2(1, 0), last)) +
                   aob_view_z(min(f + ivec2(0, 1), last)) + aob_view_z(min(f + 1, last)));
}

void main()
{
    ivec2 p = aob_pixel;
    vec2 start = aob_image(p);
    vec3 position = place_at(start, depth_of(p)), v = aob_view_vector(position);
    if (FAULT == HALF_PIXEL_DRIFT && AOB_DIVISOR > 1) {
        ivec2 middle = min(p * AOB_DIVISOR + AOB_DIVISOR / 2, aob_size - 1);
        start = vec2(middle) + 0.5;
        position = aob_position(middle);
        v = aob_view_vector(position);
    }
    vec3 normal = unit_normal(p, v), closed;
    vec2 sums = gather(start, position, normal, v, closed);
    bool passes = FAULT == NAN_PASSES || FAULT == NAN_SPREADS;
    float ratio = passes && isnan(sums.x) ? sums.x : clamp(sums.x / max(sums.y, 1e-6), 0.0, 1.0);
    if (FAULT == ONE_ROW_DIVIDES) /* a gradient against banding, too small to see; 0/0 in an image of one row */
        ratio -= 1e-9 * dot(vec2(p) / vec2(aob_size - 1), vec2(1.0));
    if (FAULT == ONE_STEP_DIVIDES) /* by the spaces between steps */
        ratio -= 1e-9 / float(STEPS - 1);
    if (FAULT == CONSTANT_OUTPUT)
        ratio = 1.0;
    if (FAULT == COARSE_STEPS)
        ratio = floor(ratio * 32.0 + 0.5) / 32.0;
    if (FAULT == LOW_SIZE_CUT && any(greaterThanEqual(p, max(aob_size / AOB_DIVISOR, 1))))
        ratio = 0.0;
    vec3 mean = 2.0 / 3.0 * normal - closed / float(SLICES);
    if (FAULT == BENT_ROTATED)
        mean = closed / float(SLICES);
    if (FAULT == BENT_ON_AXIS) /* towards the eye, which sign() does not say of what lies across the axis */
        mean *= sign(normal.z);
    float value = aob_surface_is_sky(p) ? (FAULT == BLACK_SKY ? 0.0 : 1.0) : ratio;
    visibility = open_of(value, mean);
#if BENT == 1
    if (FAULT == BENT_NAN && isnan(aob_surface_normal(p).x))
        visibility.xyz = aob_surface_normal(p);
#endif
}
