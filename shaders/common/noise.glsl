/* 4x4 tiles of offsets in [0, 1): rotation and step offset of Jimenez et al. 2016 (GTAO), spatial part. Every
 * 4x4 block of pixels holds each of the 16 rotations once. */
float noise_rotation(ivec2 p)
{
    return float((((p.x + p.y) & 3) << 2) + (p.x & 3)) / 16.0;
}

float noise_offset(ivec2 p)
{
    return float((p.y - p.x) & 3) / 4.0;
}

/* The temporal part of the same noise for frame number i, as shares of a rotation and of a step: the text's 24, and from then on
 * the same again, each time moved within the gaps that they leave (golden ratios of one and two dimensions). */
float noise_frame_rotation(int i)
{
    int k = i % 6;
    float text = k == 0 ? 1.0 / 6.0 : k == 1 ? 5.0 / 6.0 : k == 2 ? 0.5 : k == 3 ? 2.0 / 3.0 : k == 4 ? 1.0 / 3.0 : 0.0;
    return text + fract(0.7548777 * float(i / 24)) / 6.0;
}

float noise_frame_offset(int i)
{
    int k = (i / 6) % 4;
    float text = k == 0 ? 0.0 : k == 1 ? 0.5 : k == 2 ? 0.25 : 0.75;
    return text + fract(0.5698403 * float(i / 24)) / 4.0;
}
