/* What a pass writes of a pixel: its visibility, and where the bent normal is wanted (BENT) the mean open direction in front of
 * it, so that one texture and one filter carry both. A sum that is no number is that of a surface that is none, and stands
 * for closed. */
#if BENT == 1
vec4 open_of(float visibility, vec3 mean)
{
    /* Bits of infinity, which those of what is no number exceed, whatever a device makes of comparing them. */
    const uint infinity = 0x7f800000u;
    return vec4(floatBitsToUint(dot(mean, mean)) < infinity ? mean : vec3(0.0), visibility);
}
#else
float open_of(float visibility, vec3 mean) { return visibility; }
#endif
