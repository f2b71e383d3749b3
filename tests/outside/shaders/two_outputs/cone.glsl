/* The mean normal of a row of surfaces, and how far it is from being one of them. */
void main()
{
    vec3 sum = vec3(0.0);
    for (int i = -TAPS / 2; i <= TAPS / 2; i++)
        sum += aob_surface_normal(aob_pixel + ivec2(i, 0));
    sum /= float(TAPS / 2 * 2 + 1);
    visibility = aob_surface_is_sky(aob_pixel) ? 1.0 : clamp(length(sum) * 0.5 + 0.5 * abs(sum.y), 0.0, 1.0);
#if WANTED == 1
    bent = vec4(sum, 0.0);
#endif
}
