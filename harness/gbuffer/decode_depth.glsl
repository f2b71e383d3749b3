/* The depth along the view axis that a texel holds; AOB_SKY_Z for the sky. Comparisons are phrased so that what is no number
 * fails them and is sky too. AOB_DEPTH_ENCODING is the place in enum aob_depth_encoding (technique/option.h);
 * param.aob_range.xy are the planes near and far.
 *
 * aob_depth_error(z) is how far the depth z may lie from the surface's, as the texel was rounded to the nearest. AOB_DEPTH_EXACT is 1
 * where the texel is a float as fine as a shader's own numbers, and the error is 0. */
#if AOB_DEPTH_ENCODING == 0 || AOB_DEPTH_ENCODING == 9 || (AOB_DEPTH_ENCODING == 8 && AOB_PERSPECTIVE == 1)
#define AOB_DEPTH_EXACT 1
#else
#define AOB_DEPTH_EXACT 0
#endif
#if AOB_DEPTH_ENCODING == 0 /* r32f */
float aob_decode_depth(float d) { return d; }
#elif AOB_DEPTH_ENCODING == 1 /* r16f: its greatest value stands for all that is farther */
float aob_decode_depth(float d) { return d <= 65504.0 ? d : AOB_SKY_Z; }
float aob_depth_error(float z) { return z / 2048.0; }
#elif AOB_DEPTH_ENCODING == 2 /* unorm16 */
float aob_decode_depth(float d) { return d < 1.0 ? d * param.aob_range.y : AOB_SKY_Z; }
float aob_depth_error(float z) { return param.aob_range.y / 131070.0; }
#elif AOB_DEPTH_ENCODING == 3 /* packed16: the high and the low byte, beside a normal */
float aob_decode_depth(vec4 d)
{
    float k = floor(d.z * 255.0 + 0.5) * 256.0 + floor(d.w * 255.0 + 0.5);
    return k >= 65535.0 ? AOB_SKY_Z : k / 65535.0 * param.aob_range.y;
}
float aob_depth_error(float z) { return param.aob_range.y / 131070.0; }
#elif AOB_DEPTH_ENCODING == 4 || AOB_DEPTH_ENCODING == 7 /* device */
float aob_decode_depth(float d)
{
    float n = param.aob_range.x, f = param.aob_range.y;
    return !(d < 1.0) ? AOB_SKY_Z : AOB_PERSPECTIVE == 1 ? n * f / (f - d * (f - n)) : n + d * (f - n);
}
#elif AOB_DEPTH_ENCODING == 5 || AOB_DEPTH_ENCODING == 8 /* device, reversed */
float aob_decode_depth(float d)
{
    float n = param.aob_range.x, f = param.aob_range.y;
    return !(d > 0.0) ? AOB_SKY_Z : AOB_PERSPECTIVE == 1 ? n * f / (n + d * (f - n)) : f - d * (f - n);
}
#else /* device, the far plane at infinity */
float aob_decode_depth(float d) { return d > 0.0 ? param.aob_range.x / d : AOB_SKY_Z; }
#endif
#if AOB_DEPTH_EXACT == 1
float aob_depth_error(float z) { return 0.0; }
#elif AOB_DEPTH_ENCODING == 6
float aob_depth_error(float z) { return z * z / param.aob_range.x / 8388608.0; }
#elif AOB_DEPTH_ENCODING >= 4 /* half a step of 24 bits, and what decoding it rounds */
float aob_depth_error(float z)
{
    float n = param.aob_range.x, f = param.aob_range.y;
    return (AOB_PERSPECTIVE == 1 ? z * z * (f - n) / (f * n) : f - n) / 8388608.0;
}
#endif
