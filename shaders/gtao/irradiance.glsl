/* Occluded irradiance of the scene's light, over pi, from visibility and bent normal.
 * IRRADIANCE_BY 0: the visibility is the mean of what is open, weighed by the cosine, and the bent normal is its first moment, so
 * the bands 0 and 1 of the light are right as they are. Of band 2 what is closed takes its part: it lies about its own mean
 * direction, as narrow as the length of that says: a lobe of k in band 1 has k^p in band 2, with p such that a whole hemisphere, 2/3, has
 * the quarter that it must have, and one direction has 1.
 * For comparison: the text's directional GTAO, where what is open is a cone about the bent normal and so is the cosine, one
 * zonal function (1); the light of an open surface that faces the bent normal, times the visibility (2, Landis 2002); that of the
 * surface itself (3, plain ambient occlusion); and cone and cosine as two functions of nine harmonics each, whose product
 * with the light is integrated (4, the triple product of Snyder 2006). docs/decisions/0043 has all measured. */
#include "common/cone.glsl"
#include "common/facing.glsl"
#include "common/harmonics.glsl"
#include "common/open.glsl"

vec3 open_light(vec3 d) { return light_through(cut_cosine(0.0), d); }

/* Zonal coefficients of a cone that is 1 inside. */
vec3 whole_cone(float c)
{
    return sqrt(AOB_PI) * (1.0 - c) * vec3(1.0, 0.5 * sqrt(3.0) * (1.0 + c), 0.5 * sqrt(5.0) * c * (1.0 + c));
}

/* A zonal function of three bands about an axis, at a direction that has the cosine x with it. */
float zonal_at(vec3 z, float x)
{
    return dot(z * sqrt(vec3(1.0, 3.0, 5.0) / (4.0 * AOB_PI)), vec3(1.0, x, 1.5 * x * x - 0.5));
}

/* The integral of three functions of nine harmonics has the degree 6: four heights of Gauss and Legendre and seven azimuths are
 * exact. */
vec3 triple_product(vec3 normal, vec3 axis, float c)
{
    const vec4 heights = vec4(-0.8611363116, -0.3399810436, 0.3399810436, 0.8611363116);
    const vec4 weights = vec4(0.3478548451, 0.6521451549, 0.6521451549, 0.3478548451);
    vec3 sum = vec3(0.0), cosine = cut_cosine(0.0), cone = whole_cone(c);
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 7; k++) {
            float phi = 2.0 * AOB_PI / 7.0 * float(k), r = sqrt(1.0 - heights[i] * heights[i]);
            vec3 d = vec3(r * cos(phi), r * sin(phi), heights[i]);
            sum += weights[i] * zonal_at(cosine, dot(d, normal)) * zonal_at(cone, dot(d, axis)) * light_from(d);
        }
    return sum * 2.0 / 7.0; /* 2 pi / 7 a direction, over pi */
}

vec3 by_moments(vec3 normal, vec4 open)
{
    vec3 shut = 2.0 / 3.0 * normal - open.xyz;
    float closed = max(1.0 - open.w, 0.0), square = dot(shut, shut);
    vec3 axis = direction_or(shut, normal);
    float narrow = min(sqrt(square) / max(closed, 1e-4), 1.0), band2 = pow(narrow, 3.419023);
    return open.w * light_band0() + light_band1(open.xyz) + 0.25 * light_band2(normal)
        - closed * band2 * light_band2(axis);
}

void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_surface(p), normal = facing_normal(aob_surface_normal(p), position);
    vec4 open = open_texel(aob_fetch_open(p));
    vec3 axis = direction_or(open.xyz, normal);
#if IRRADIANCE_BY == 0
    vec3 light = by_moments(normal, open);
#elif IRRADIANCE_BY == 1
    vec3 light = light_through(cut_cosine(cone_cosine(open.w)), axis);
#elif IRRADIANCE_BY == 2
    vec3 light = open.w * open_light(axis);
#elif IRRADIANCE_BY == 3
    vec3 light = open.w * open_light(normal);
#else
    vec3 light = triple_product(normal, axis, cone_cosine(open.w));
#endif
    const float most = 65504.0; /* the largest half float: a probe may hold the sun */
    irradiance = vec4(aob_surface_is_sky(p) ? vec3(0.0) : clamp(light, vec3(0.0), vec3(most)), 1.0);
}
