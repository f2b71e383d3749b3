/* Specular occlusion from visibility, bent normal and roughness, by the table of the share of a GGX lobe in a cone (lobe.h).
 * SPECULAR_BY 0: what is closed is a cap about a direction in the surface's plane, against the bent normal's tilt, as wide as the
 * visibility says: a wall within the radius closes such a cap exactly. SPECULAR_BY 1 is the text's GTSO, for comparison: what
 * is open is a cone about the bent normal, over that share of the whole hemisphere. docs/decisions/0043 has both measured. */
#include "common/cone.glsl"
#include "common/facing.glsl"
#include "common/open.glsl"

float table_share(float edge, float cone, float shape)
{
    vec2 at = vec2(edge * float(EDGES - 1) + 0.5, cone * float(CONES - 1) + 0.5 + shape * float(CONES));
    return aob_sample_lobes(at / vec2(EDGES, CONES * SHAPES));
}

/* Share of the lobe in a cone of half-angle alpha, up to pi / 2, whose axis is beta away from the lobe's. */
float lobe_share(float alpha, float beta, float roughness)
{
    const float least = float(LEAST_PERCENT) / 100.0;
    float rough = clamp(roughness, least, 1.0);
    float w = 4.0 * atan(rough * rough), d = beta - alpha;
    float edge = 0.5 + 0.5 * d / (abs(d) + w);
    float cone = alpha / (alpha + w) * (0.5 * AOB_PI + w) / (0.5 * AOB_PI);
    float shape = (rough - least) / (1.0 - least) * float(SHAPES - 1), below = min(floor(shape), float(SHAPES - 2));
    return mix(table_share(edge, cone, below), table_share(edge, cone, below + 1.0), shape - below);
}

float angle_between(vec3 a, vec3 b) { return acos(clamp(dot(a, b), -1.0, 1.0)); }

#if SPECULAR_BY == 0
/* Where the lobe of a rough surface is brightest: between the mirrored view and the normal (Lagarde and de Rousiers 2014). */
vec3 lobe_axis(vec3 normal, vec3 mirrored, float roughness)
{
    float a = roughness * roughness, smoothness = 1.0 - a;
    return normalize(mix(normal, mirrored, smoothness * (sqrt(smoothness) + a)));
}

/* Half-angle of a cap about a direction in the plane whose upper half has this cosine-weighted share of the hemisphere,
 * at most 1/2: seen from above it is the segment of a disc (Nusselt), share = (k - sin(k) cos(k)) / pi. */
float cap_angle(float share)
{
    float k = min(pow(1.5 * AOB_PI * share, 1.0 / 3.0), 0.5 * AOB_PI);
    for (int i = 0; i < 3; i++) {
        float s = sin(k);
        k -= (k - s * cos(k) - AOB_PI * share) / max(2.0 * s * s, 1e-3);
    }
    return clamp(k, 0.0, 0.5 * AOB_PI);
}

float open_lobe(vec4 open, vec3 normal, vec3 mirrored, float roughness)
{
    vec3 tilt = open.xyz - dot(open.xyz, normal) * normal, lobe = lobe_axis(normal, mirrored, roughness);
    float closed = clamp(1.0 - open.w, 0.0, 1.0), beta = angle_between(direction_or(-tilt, normal), lobe);
    /* A cap of more than half a sphere is what its opposite leaves. */
    bool most = closed > 0.5;
    float angle = cap_angle(most ? 1.0 - closed : closed), inside = lobe_share(angle, most ? AOB_PI - beta : beta, roughness);
    /* Its tilt is 2 sin^3 / (3 pi). Where what is closed tilts less it stands on several sides, at last all round, and no cap is
     * like it. */
    float s = sin(angle), like = clamp(length(tilt) / max(2.0 / (3.0 * AOB_PI) * s * s * s, 1e-4), 0.0, 1.0);
    return mix(open.w, most ? inside : 1.0 - inside, like);
}
#else
float open_lobe(vec4 open, vec3 normal, vec3 mirrored, float roughness)
{
    vec3 axis = direction_or(open.xyz, normal);
    float inside = lobe_share(acos(cone_cosine(open.w)), angle_between(axis, mirrored), roughness);
    return inside / max(lobe_share(0.5 * AOB_PI, angle_between(normal, mirrored), roughness), 1e-4);
}
#endif

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p), normal = facing_normal(aob_surface_normal(p), position);
    vec3 mirrored = reflect(-aob_view_vector(position), normal);
    float open = open_lobe(aob_fetch_open(p), normal, mirrored, aob_roughness(p));
    specular = aob_surface_is_sky(p) ? 1.0 : clamp(open, 0.0, 1.0);
}
