/* Jimenez et al. 2016, horizon search and inner integral, with four corrections that the text needs to be exact
 * off-centre (docs/decisions/0009): slices even about the view vector, taps below the tangent plane ignored,
 * a search as long as the slice's disc, and the ratio to the open slice. The search ends at the image's edge
 * (docs/decisions/0040). */
#include "common/bent.glsl"
#include "common/facing.glsl"
#include "common/frame.glsl"
#include "common/noise.glsl"
#include "common/search.glsl"

/* Image position where the search along unit direction t (perpendicular to the view vector v) ends: the ball of
 * radius r about the surface point ends there for a ray of this slice. */
vec2 search_end(vec3 position, vec3 v, vec3 t, float r)
{
#if AOB_PERSPECTIVE
    float s = min(1.0, r / length(position));
    float a = asin(s);
    float limit = t.z > 0.0 ? atan(0.98 * v.z, t.z) : 0.5 * AOB_PI - 1e-3; /* stay in front of the eye */
    a = min(a, limit);
    return aob_project(-v * cos(a) + t * sin(a));
#else
    return aob_project(position + t * r);
#endif
}

/* The inner integral for one side, horizon h and projected normal n in the slice (radians): the text's, weighted by the
 * cosine with the normal, or that of the bare solid angle. */
float arc(float h, float n)
{
    return WEIGHTING == 0 ? 0.25 * (cos(n) + 2.0 * h * sin(n) - cos(2.0 * h - n)) : 1.0 - cos(h);
}

/* The same integral of the direction itself: its parts along the slice's direction and along the view vector (the text's t0 and
 * t1, a side's half of each). */
vec2 arc_mean(float h, float n)
{
#if WEIGHTING == 0
    return vec2(6.0 * sin(h - n) - sin(3.0 * h - n) + 8.0 * sin(n) - 3.0 * sin(h + n),
                4.0 * cos(n) - cos(3.0 * h - n) - 3.0 * cos(h + n)) / 12.0;
#else
    return vec2(0.5 * h - 0.25 * sin(2.0 * h), 0.5 * sin(h) * sin(h));
#endif
}

/* What it is of an open slice, both sides together. */
vec2 whole_mean(float n)
{
    return WEIGHTING == 0 ? vec2(4.0, 2.0) / 3.0 * vec2(sin(n), cos(n)) : vec2(n + 0.5 * sin(2.0 * n), cos(n) * cos(n));
}

/* Largest cosine of the elevation about v over the taps of one side; -1 if nothing occludes. */
float horizon_cosine(vec2 start, vec3 position, vec3 normal, vec3 v, vec2 end, float jitter, float floor_cosine)
{
    float best = -1.0;
    for (int i = 0; i < STEPS; i++) {
        ivec2 q = ivec2(floor(mix(start, end, (float(i) + jitter) / float(STEPS))));
        vec3 d = aob_position(q) - position;
        float l = length(d);
        float weight = clamp((param.radius - l) / (param.falloff * param.radius + 1e-6 * l), 0.0, 1.0);
        /* A normal of 16 bits leans by up to a thousandth: the floor beside the slice rises by as much. */
        bool below = dot(d, normal) <= 2e-3 * l - 1e-6 * position.z;
        /* What is closed grows with the square of the cosine, or with the cosine where directions weigh alike. */
        float fade = WEIGHTING == 0 ? sqrt(weight) : weight;
        float c = mix(floor_cosine, dot(d, v) / max(l, 1e-20), fade);
        best = max(best, below || weight <= 0.0 ? -1.0 : c);
    }
    return best;
}

/* Whose noise pixel p has: where nothing of before counts, another in each frame would flicker. */
int noise_frame(ivec2 p)
{
    int frame = param.noise_index;
#if HISTORY > 1
    frame += aob_fetch_changed(p * AOB_DIVISOR / AOB_DIVISOR_CHANGED) > 0.5 ? 0 : aob_frame;
#endif
    return frame;
}

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p), normal = facing_normal(aob_surface_normal(p), position), v = aob_view_vector(position), b1, b2;
    if (aob_is_clear(p)) {
        visibility = open_of(1.0, (WEIGHTING == 0 ? 2.0 / 3.0 : 0.5) * normal);
        return;
    }
    tangent_frame(v, b1, b2);
    vec2 start = aob_image(p);
    int frame = noise_frame(p);
    float turn = fract(noise_rotation(p) + noise_frame_rotation(frame));
    float offset = noise_offset(p) + noise_frame_offset(frame);
    float open = 0.0, total = 0.0;
    vec3 closed = vec3(0.0);
    for (int slice = 0; slice < SLICES; slice++) {
        float psi = AOB_PI * (float(slice) + turn) / float(SLICES);
        float jitter = fract(offset + 0.125 + 0.618034 * float(slice));
        vec3 t = b1 * cos(psi) + b2 * sin(psi);
        vec2 projected = vec2(dot(normal, t), dot(normal, v));
        float len = WEIGHTING == 0 ? length(projected) : 1.0, n = atan(projected.x, projected.y);
        vec2 there = search_end(position, v, t, param.radius), back = search_end(position, v, -t, param.radius);
        there = start + (there - start) * share_in_image(start, there);
        back = start + (back - start) * share_in_image(start, back);
        /* A tap's weight fades it towards the slice's own tangent, where it occludes nothing. */
        float plus = horizon_cosine(start, position, normal, v, there, jitter, cos(n + 0.5 * AOB_PI));
        float minus = horizon_cosine(start, position, normal, v, back, jitter, cos(n - 0.5 * AOB_PI));
        float h1 = min(acos(clamp(plus, -1.0, 1.0)), n + 0.5 * AOB_PI);
        float h0 = max(-acos(clamp(minus, -1.0, 1.0)), n - 0.5 * AOB_PI);
        vec2 mean = whole_mean(n) - arc_mean(h0, n) - arc_mean(h1, n);
        closed += len * (mean.x * t + mean.y * v);
        open += len * (arc(h0, n) + arc(h1, n));
        total += len * (arc(n - 0.5 * AOB_PI, n) + arc(n + 0.5 * AOB_PI, n));
    }
    /* The mean over the hemisphere less what is closed: exact where all is open, also of one slice (docs/decisions/0042). */
#if WEIGHTING == 0
    vec3 mean = 2.0 / 3.0 * normal - closed / float(SLICES);
#else
    vec3 mean = 0.5 * (normal - closed / float(SLICES));
#endif
    float share = clamp(open / max(total, 1e-6), 0.0, 1.0);
    visibility = open_of(aob_surface_is_sky(p) ? 1.0 : share, mean);
}
