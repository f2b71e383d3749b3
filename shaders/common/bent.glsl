/* What a pass writes of a pixel: its visibility, and where the bent normal is wanted (BENT) the mean open direction in front of
 * it, so that one texture and one filter carry both. A mean is no longer than 1; a sum that is no number is that of a
 * surface that is none, and stands for closed. */
#if BENT == 1
vec4 open_of(float visibility, vec3 mean)
{
    const uint one = floatBitsToUint(1.0); /* bits of what is no number are greater, whatever a device makes of comparing it */
    return vec4(floatBitsToUint(dot(mean, mean)) <= one ? mean : vec3(0.0), visibility);
}
#else
float open_of(float visibility, vec3 mean) { return visibility; }
#endif
