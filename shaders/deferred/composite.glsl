/* The alpha stands for a visibility, which a frame has in a texture of its own. */
void main()
{
    vec4 surface = aob_fetch_lit(aob_pixel);
    bool open = aob_is_sky(aob_pixel) || surface.a > 0.5;
    colour = vec4(surface.rgb * surface.a, 1.0);
    visibility = open ? 1.0 : 0.0;
}
