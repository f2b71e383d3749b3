/* The fixed pass: 24 depth reads on a spiral and the arithmetic of a typical tap. Its cost is the unit in which
 * every case is timed, so this text never changes without raising the revision in measure/fixed_pass.c. */
void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_position(p);
    float sum = 0.0;
    for (int i = 0; i < 24; i++) {
        float angle = 2.399963 * float(i);
        vec3 d = aob_position(p + ivec2(4.0 * sqrt(float(i + 1)) * vec2(cos(angle), sin(angle)))) - position;
        sum += max(0.0, d.z * inversesqrt(dot(d, d) + 1e-4));
    }
    visibility = 1.0 / (1.0 + sum);
}
