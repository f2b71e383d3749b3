/* The depth divided by FACTOR: the first pixel of each block (NEAREST_OF 0) or the block's nearest surface (1). */
void main()
{
    ivec2 first = aob_pixel * FACTOR;
    float z = aob_view_z(first);
    for (int y = 0; y < (NEAREST_OF == 1 ? FACTOR : 1); y++)
        for (int x = 0; x < (NEAREST_OF == 1 ? FACTOR : 1); x++)
            z = min(z, aob_view_z(first + ivec2(x, y)));
    depth = z;
}
