/* Light that reaches a point whose visibility is v after all bounces between surfaces of this diffuse albedo, in a light that is
 * the same from everywhere: the fit of Jimenez et al. 2016 (GTAO) to path-traced scenes. It is never below v. */
vec3 bounced_light(float v, vec3 albedo)
{
    vec3 a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
    return max(vec3(v), ((v * a + b) * v + c) * v);
}
