/* The lit image of what a technique gives (harness/technique/composite.h has the formula). LIT_BOUNCES, LIT_SPECULAR and
 * LIT_IRRADIANCE say which outputs are there; LIT_PACKED that the visibility lies behind a bent normal, in w; LIT_BENT that a bent
 * normal is there, in a texture of its own (1) or that one (2). */
#include "common/facing.glsl"
#include "common/harmonics.glsl"

const ivec2 TABLE = ivec2(32, 32); /* cosines, roughnesses: AOB_COMPOSITE_COSINES, AOB_COMPOSITE_SHAPES */

float share_of(float texel, int packed) { return texel; }
float share_of(vec2 texel, int packed) { return texel.x; }
float share_of(vec4 texel, int packed) { return packed == 1 ? texel.w : texel.x; }

vec3 open_light(vec3 d) { return light_through(cut_cosine(0.0), d); }

/* Irradiance over pi that a surface of this visibility gets, no bounces counted. */
vec3 plain_light(ivec2 p, vec3 normal, float visibility)
{
#if LIT_IRRADIANCE == 1
    return aob_fetch_irradiance(p).rgb;
#elif LIT_BENT == 1
    return visibility * open_light(direction_or(aob_fetch_bent(p).xyz, normal));
#elif LIT_BENT == 2
    return visibility * open_light(direction_or(aob_fetch_visible(p).xyz, normal));
#else
    return visibility * open_light(normal);
#endif
}

/* By how much bounces raise it. Where next to nothing is open the quotient is that of what a half float can tell from nothing. */
vec3 gain(ivec2 p, float visibility)
{
#if LIT_BOUNCES == 1
    return aob_fetch_bounced(p).rgb / max(visibility, 1.0 / 1024.0);
#else
    return vec3(1.0);
#endif
}

float open_share_of_lobe(ivec2 p, float visibility)
{
#if LIT_SPECULAR == 1
    return share_of(aob_fetch_open_lobe(p), 0);
#else
    return visibility;
#endif
}

vec4 lobe_part(int part, float roughness, float cosine)
{
    vec2 at = vec2(sqrt(cosine), roughness) * vec2(TABLE - 1) + 0.5;
    return aob_sample_lobes(vec2(at.x, at.y + float(part * TABLE.y)) / vec2(TABLE * ivec2(1, 3)));
}

/* Band 2 of the light as a form of two vectors, 0 for the unit matrix. */
vec3 light_form(vec3 a, vec3 b)
{
    return 0.54627422 * ((a.x * b.y + a.y * b.x) * aob_light(4) + (a.y * b.z + a.z * b.y) * aob_light(5)
                         + (a.x * b.z + a.z * b.x) * aob_light(7) + (a.x * b.x - a.y * b.y) * aob_light(8))
        + 0.31539157 * (3.0 * a.z * b.z - dot(a, b)) * aob_light(6);
}

/* The light times a lobe of these moments. With w = view - cosine * normal, across the normal and as long as the sine, the mean of
 * directions is x w + z n, and that of their squares yy (1 - n n) + (xx - yy) w w + zz n n + xz (w n + n w). */
struct axes {
    vec3 normal, across, form_nn, form_ww, form_nw;
};
vec3 mirrored(axes a, vec4 head, vec2 tail)
{
    float yy = 0.5 * (head.x - head.w - tail.y * dot(a.across, a.across));
    return head.x * light_band0() + light_band1(head.z * a.across + head.y * a.normal) + (head.w - yy) * a.form_nn
        + tail.y * a.form_ww + 2.0 * tail.x * a.form_nw;
}

/* What the lobe mirrors of the light where all is open, and of a light that is 1 from everywhere. */
struct mirror {
    vec3 open, even;
};
mirror mirror_of(vec3 normal, vec3 view, float roughness, vec3 f0)
{
    float cosine = clamp(dot(normal, view), 0.0, 1.0);
    vec3 across = view - cosine * normal;
    axes a = axes(normal, across, light_form(normal, normal), light_form(across, across), light_form(normal, across));
    vec4 whole = lobe_part(0, roughness, cosine), edge = lobe_part(1, roughness, cosine), tail = lobe_part(2, roughness, cosine);
    vec3 open = f0 * mirrored(a, whole, tail.xy) + (1.0 - f0) * mirrored(a, edge, tail.zw);
    return mirror(max(open, 0.0), f0 * whole.x + (1.0 - f0) * edge.x);
}

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p), normal = facing_normal(aob_surface_normal(p), position);
    vec3 base = aob_albedo(p);
    float metal = aob_metalness(p), visibility = share_of(aob_fetch_visible(p), LIT_PACKED);
    vec3 plain = plain_light(p, normal, visibility), light = plain * gain(p, visibility);
    vec3 closed = max(light - plain, 0.0) / max(1.0 - visibility, 1.0 / 256.0);
    mirror m = mirror_of(normal, aob_view_vector(position), aob_roughness(p), mix(vec3(0.04), base, metal));
    vec3 sum = base * (1.0 - metal) * light + mix(closed * m.even, m.open, open_share_of_lobe(p, visibility));
    lit = vec4(aob_surface_is_sky(p) ? vec3(0.0) : min(sum, 65504.0), 1.0);
}
