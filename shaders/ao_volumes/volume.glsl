/* The form factor of a triangle T at the pixel's point x (equation 1): Lambert's sum over the edges of the clipped
 * polygon. All is done in the triangle's plane, with the point under x as origin and x at height h above it, where a
 * line at distance m from the origin is seen from x in a plane whose normal is the same all along it. */
#include "common/facing.glsl"
#include "common/frame.glsl"
#include "volume_size.glsl"

struct view { /* of x on the plane */
    float h;
    vec3 n; /* normal at x: along the plane's axes, and along its front */
};

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

/* Keeps of t the part where at + t * along >= 0. */
void clip(inout vec2 t, float at, float along)
{
    float crossing = -at / along;
    t.x = along > 0.0 ? max(t.x, crossing) : t.x;
    t.y = along < 0.0 ? min(t.y, crossing) : t.y;
    t.y = along == 0.0 && at < 0.0 ? -1e30 : t.y;
}

/* Of the part t of the line that passes the origin at m with direction d; t counts from there. */
float edge(view x, vec2 d, float m, vec2 t)
{
    float away = sqrt(x.h * x.h + m * m);
    float angle = atan(away * (t.y - t.x), away * away + t.x * t.y);
    float facing = dot(x.n, vec3(x.h * d.y, -x.h * d.x, m)) / away;
    return t.y > t.x ? -angle * facing : 0.0;
}

/* The triangle clipped to the tangent plane, where s >= 0: four corners, some of them twice. */
void clip_to_tangent(vec2 p[3], vec3 s, out vec2 q[4])
{
    bvec3 up = greaterThan(s, vec3(0.0));
    bool whole = all(up);
    /* a is the one corner on its side */
    int i = up.x == up.y ? 2 : up.x == up.z ? 1 : 0;
    vec2 a = i == 0 ? p[0] : i == 1 ? p[1] : p[2], b = i == 0 ? p[1] : i == 1 ? p[2] : p[0],
         c = i == 0 ? p[2] : i == 1 ? p[0] : p[1];
    s = i == 0 ? s : i == 1 ? s.yzx : s.zxy;
    bool alone = !whole && s.x > 0.0;
    vec2 ab = a + (b - a) * (s.x / (s.x - s.y)), ac = a + (c - a) * (s.x / (s.x - s.z));
    q[0] = whole || alone ? a : ab;
    q[1] = alone ? ab : b;
    q[2] = alone ? ac : c;
    q[3] = whole ? c : ac;
}

struct side { /* of the clipped polygon: from p along d, the part t of its length */
    vec2 p, d, t;
};

side make_side(vec2 from, vec2 to)
{
    float size = length(to - from);
    return side(from, size > 0.0 ? (to - from) / size : vec2(0.0), vec2(0.0, size));
}

float side_edge(view x, side s)
{
    return edge(x, s.d, cross2(s.p, s.d), s.t + dot(s.p, s.d));
}

/* Distance of the origin from the triangle, in its plane. */
float beside(vec2 p[3])
{
    float outside = 1e30;
    bool inside = true;
    for (int k = 0; k < 3; k++) {
        vec2 e = p[(k + 1) % 3] - p[k];
        float t = clamp(-dot(p[k], e) / dot(e, e), 0.0, 1.0);
        outside = min(outside, length(p[k] + t * e));
        inside = inside && cross2(e, p[k]) <= 0.0;
    }
    return inside ? 0.0 : outside;
}

/* Both clipped to the disc, whose polygon's sides close the gap: the sum over what is left of all sides. */
float clipped_factor(view x, vec2 p[3], inout side q[4], bool counts)
{
    float sum = 0.0, apothem = SIDE_OUT * sqrt(max(param.radius * param.radius - x.h * x.h, 0.0));
    float half_side = apothem * tan(0.5 * TURN);
    vec2 outward = vec2(1.0, 0.0);
    for (int k = 0; k < (counts ? SIDES : 0); k++) {
        vec2 t = vec2(-half_side, half_side), d = vec2(-outward.y, outward.x);
        for (int i = 0; i < 3; i++) {
            vec2 e = p[(i + 1) % 3] - p[i];
            clip(t, cross2(e, apothem * outward - p[i]), cross2(e, d));
        }
        clip(t, apothem * dot(x.n.xy, outward) - x.h * x.n.z, dot(x.n.xy, d));
        sum += edge(x, d, apothem, t);
        for (int i = 0; i < 4; i++)
            clip(q[i].t, apothem - dot(outward, q[i].p), -dot(outward, q[i].d));
        outward = vec2(outward.x * cos(TURN) - outward.y * sin(TURN), outward.x * sin(TURN) + outward.y * cos(TURN));
    }
    for (int i = 0; i < 4; i++)
        sum += side_edge(x, q[i]);
    return sum;
}

float tapered_factor(view x, vec2 p[3], side q[4])
{
    float sum = 0.0, off = beside(p);
    for (int i = 0; i < 4; i++)
        sum += side_edge(x, q[i]);
    return sum * max(0.0, 1.0 - sqrt(x.h * x.h + off * off) / param.radius);
}

void main()
{
    vec3 front = aob_front(), position = aob_surface(aob_pixel), b1, b2;
    vec3 normal = facing_normal(aob_surface_normal(aob_pixel), position);
    vec3 corner[3] = vec3[3](aob_corner(0) - position, aob_corner(1) - position,
                             aob_corner(2) - position);
    tangent_frame(front, b1, b2);
    view x = view(-dot(corner[0], front), vec3(dot(normal, b1), dot(normal, b2), dot(normal, front)));
    vec2 p[3], q[4];
    vec3 above;
    float extent = dot(position, position); /* squared */
    for (int k = 0; k < 3; k++) {
        p[k] = vec2(dot(corner[k], b1), dot(corner[k], b2));
        above[k] = dot(corner[k], normal);
        extent = max(extent, dot(corner[k], corner[k]));
    }
    /* A point in the triangle's plane, up to the rounding of places and of the plane over its extent, lies in a crease
     * if the triangle rises above it: it sees what a point just before the plane sees. Else it is of the same surface
     * and sees nothing of it, though a normal in 8 bits leans by up to 1 degree and makes one half of the plane rise. */
    float rounding = 1e-6 * sqrt(extent);
    float rise = max(above.x, max(above.y, above.z));
    bool crease = dot(x.n.xy, x.n.xy) > 9e-4 && rise > 10.0 * rounding;
    bool before = x.h > rounding ? rise > 0.0 : x.h > -rounding && crease;
    bool counts = before && x.h < param.radius && !aob_surface_is_sky(aob_pixel);
    x.h = max(x.h, rounding);
    clip_to_tangent(p, above, q);
    side sides[4] = side[4](make_side(q[0], q[1]), make_side(q[1], q[2]), make_side(q[2], q[3]),
                            make_side(q[3], q[0]));
#if FALLOFF == 0
    float sum = clipped_factor(x, p, sides, counts);
#else
    float sum = tapered_factor(x, p, sides);
#endif
    occlusion = counts ? max(0.0, sum / (2.0 * AOB_PI)) : 0.0;
}
