/* The depth along the view axis that a texel holds; AOB_SKY_Z for the sky. Comparisons are phrased so that what is no number
 * fails them and is sky too. AOB_DEPTH_ENCODING is the place in enum aob_depth_encoding (technique/option.h);
 * param.aob_range.xy are the planes near and far. */
#if AOB_DEPTH_ENCODING == 0 /* r32f */
float aob_decode_depth(float d) { return d; }
#elif AOB_DEPTH_ENCODING == 1 /* r16f: its greatest value stands for all that is farther */
float aob_decode_depth(float d) { return d <= 65504.0 ? d : AOB_SKY_Z; }
#elif AOB_DEPTH_ENCODING == 2 /* unorm16 */
float aob_decode_depth(float d) { return d < 1.0 ? d * param.aob_range.y : AOB_SKY_Z; }
#elif AOB_DEPTH_ENCODING == 3 /* packed16: the high and the low byte, beside a normal */
float aob_decode_depth(vec4 d)
{
    float k = floor(d.z * 255.0 + 0.5) * 256.0 + floor(d.w * 255.0 + 0.5);
    return k >= 65535.0 ? AOB_SKY_Z : k / 65535.0 * param.aob_range.y;
}
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
