/* The fault itself: of four low pixels, whatever surfaces they show. */
void main()
{
    ivec2 p = aob_pixel, base = p / AOB_DIVISOR_LOW, last = (aob_size - 1) / AOB_DIVISOR_LOW;
    vec2 part = vec2(p - base * AOB_DIVISOR_LOW) / float(AOB_DIVISOR_LOW);
    AOB_TYPE_LOW above = mix(aob_fetch_low(base), aob_fetch_low(min(base + ivec2(1, 0), last)), part.x);
    AOB_TYPE_LOW below = mix(aob_fetch_low(min(base + ivec2(0, 1), last)), aob_fetch_low(min(base + 1, last)), part.x);
    full = aob_surface_is_sky(p) ? AOB_TYPE_LOW(1.0) : mix(above, below, part.y);
}
