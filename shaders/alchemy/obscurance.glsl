/* McGuire et al. 2011, equation 10, with the range test of equation 9: "obscurance has a maximum world-space
 * radius of r". Samples lie on the projected disc of radius r parallel to the image, on a golden-angle spiral
 * turned by a random angle per pixel. */
void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_position(p), normal = aob_normal(p);
    float disc = aob_pixel_radius(-position.z, param.radius);
    float turn = 2.0 * AOB_PI * aob_random(p, 0);
    float sum = 0.0;
    for (int i = 0; i < SAMPLES; i++) {
        float angle = turn + 2.399963 * float(i);
        float r = disc * sqrt((float(i) + 0.5) / float(SAMPLES));
        vec3 v = aob_position(p + ivec2(floor(0.5 + r * vec2(cos(angle), sin(angle))))) - position;
        float vv = dot(v, v);
        float in_range = vv < param.radius * param.radius ? 1.0 : 0.0;
        sum += in_range * max(0.0, dot(v, normal) + position.z * param.bias) / (vv + param.epsilon);
    }
    float a = max(0.0, 1.0 - 2.0 * param.intensity / float(SAMPLES) * sum);
    visibility = aob_is_sky(p) ? 1.0 : pow(a, param.contrast);
}
