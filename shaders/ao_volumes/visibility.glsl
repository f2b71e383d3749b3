void main()
{
    visibility = clamp(1.0 - aob_fetch_occlusion(aob_pixel), 0.0, 1.0);
}
