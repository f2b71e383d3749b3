void main()
{
    /* The depth is read, so that the floor holds what no technique can avoid. */
    visibility = aob_view_z(aob_pixel) > 0.0 ? 1.0 : 0.0;
}
