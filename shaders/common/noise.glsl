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
