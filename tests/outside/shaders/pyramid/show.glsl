/* Of the block of 2^LAST pixels that a pixel lies in. */
void main() { visibility = min(1.0, aob_view_z(aob_pixel >> LAST, LAST) / param.scale); }
