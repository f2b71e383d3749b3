/* A box about the changes of 8 x 8 tiles. */
void main()
{
    vec3 low = vec3(1e30), high = vec3(-1e30);
    ivec2 last = (aob_size - 1) / 8;
    for (int i = 0; i < 64; i++) {
        ivec2 tile = min(aob_pixel * 8 + ivec2(i & 7, i >> 3), last);
        low = min(low, aob_fetch_tile_low(tile).xyz);
        high = max(high, aob_fetch_tile_high(tile).xyz);
    }
    change_low = vec4(low, 1.0);
    change_high = vec4(high, 1.0);
}
