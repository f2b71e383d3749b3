/* Line samples through the sphere about the surface point. A line stands on the image at an offset of the sphere's
 * disc; all behind the surface that is seen there is solid. Offsets come in pairs (d, -d), rounded to the same whole
 * pixels, so that a plane through the centre is half solid at any tilt. Radii are even in area, shifted per pixel: few
 * fixed ones would weigh the sphere's rim wrongly, the same way in each pixel.
 * ROLE: 0 the only image, 1 the coarse one of two, 2 the fine one, which mixes with the coarse. Where nothing is in front of the
 * plane no line is drawn: none of them would be solid. */
#include "common/facing.glsl"

/* Depth z relative to the centre's, zc, positive behind it. In a perspective view zc (1 - zc/z), which is the difference
 * to first order, and straight along the image on every plane; so pairs stay exact. */
float behind(float z, float zc)
{
#if AOB_PERSPECTIVE
    return zc * (1.0 - zc / z);
#else
    return z - zc;
#endif
}

/* The same of the plane through `position`, `normal`, at image position q; `facing` is how far it faces the eye. */
float behind_plane(vec2 q, vec3 position, vec3 normal, float facing)
{
    return dot(normal, aob_position_at(q, -position.z) - position) / facing;
}

/* Adds one line: x its solid length, y its whole length, z and w those of the part above the tangent plane. */
vec2 line(ivec2 centre, ivec2 offset, float disc, float r, vec3 position, vec3 normal, float facing)
{
    float half_length = r * sqrt(max(0.0, 1.0 - dot(vec2(offset), vec2(offset)) / (disc * disc)));
    float surface = behind(aob_view_z(centre + offset), -position.z);
#if HEMISPHERE
    float end = clamp(behind_plane(vec2(centre + offset) + 0.5, position, normal, facing), -half_length, half_length);
#else
    float end = half_length;
#endif
    return vec2(clamp(end - surface, 0.0, end + half_length), end + half_length);
}

/* All lines of pixel p together. */
vec2 lines(ivec2 p, vec3 position, vec3 normal, float facing)
{
    ivec2 centre = ivec2(floor(aob_image(p)));
    float r = ROLE == 2 ? param.radius * param.fine_radius : param.radius;
    float disc = aob_pixel_radius(-position.z, r);
    float turn = AOB_PI * aob_random(p, 2 * ROLE), shift = aob_random(p, 2 * ROLE + 1);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < SAMPLES / 2; i++) {
        float angle = turn + AOB_PI * 0.618034 * float(i);
        float distance = disc * sqrt((float(i) + shift) / float(SAMPLES / 2));
        ivec2 offset = ivec2(floor(0.5 + distance * vec2(cos(angle), sin(angle))));
        sum += line(centre, offset, disc, r, position, normal, facing);
        sum += line(centre, -offset, disc, r, position, normal, facing);
    }
    return sum;
}

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p);
#if HEMISPHERE
    vec3 normal = facing_normal(aob_surface_normal(p), position);
    float facing = max(AOB_PERSPECTIVE == 1 ? dot(normal, -position) / -position.z : normal.z, 1e-6);
#else
    vec3 normal = vec3(0.0);
    float facing = 1.0;
#endif
    visibility = 1.0;
    if (aob_surface_is_sky(p))
        return;
    vec2 sum = vec2(0.0);
    if (!aob_is_clear(p))
        sum = lines(p, position, normal, facing);
    float empty = sum.y > 0.0 ? 1.0 - sum.x / sum.y : HEMISPHERE == 1 ? 1.0 : 0.5;
    empty *= HEMISPHERE == AMPLIFICATION ? 1.0 : HEMISPHERE == 1 ? 0.5 : 2.0;
#if ROLE == 2
    empty = 0.5 * (empty + aob_fetch_coarse(p));
#endif
    visibility = ROLE == 1 ? empty : clamp(empty, 0.0, 1.0);
}
