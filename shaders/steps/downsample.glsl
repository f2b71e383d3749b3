/* The depth divided: the first pixel of each block, an exact point of a surface. */
void main()
{
    depth = aob_view_z(aob_pixel * AOB_DIVISOR);
}
