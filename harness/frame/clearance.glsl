/* A tile is clear, and so is the sky, and a pixel that no sample leaves. A sample at p + r d, with d at most 1 long, is no nearer than
 * z - r and so looks at most r * longer / (z - r) away from p, in units of the image at depth 1: longer is the length of the ray to
 * depth 1, by which a ball looks longer off the axis. z - r * longer in place of z - r leaves room for rounding. Taps into a divided
 * depth begin at the edge of a texel. The twin in C is is_small() of left_out.c. */
bool aob_is_clear(ivec2 p) {
    float z = aob_surface_z(p);
    float longer = AOB_PERSPECTIVE == 1 ? length(aob_position_at(aob_image(p), 1.0)) : 1.0;
    float nearest = AOB_PERSPECTIVE == 1 ? z - param.radius * longer : 1.0;
    bool small = AOB_DEPTH_DIVISOR == 1 && nearest > 0.0 && aob_pixel_radius(nearest, param.radius) * longer < 0.5;
    return aob_no_depth(z) || small || aob_fetch_clearance(p * AOB_DIVISOR / AOB_DIVISOR_CLEARANCE) > 0.5;
}
