/* A tile is clear, and so is the sky, and a pixel that no tap would leave: the ball of the radius, which looks longer off the axis,
 * covers less than half of it. Taps into a divided depth begin at the edge of a texel. */
bool aob_is_clear(ivec2 p) {
    float z = aob_surface_z(p);
    float longer = AOB_PERSPECTIVE == 1 ? length(aob_position_at(aob_image(p), 1.0)) : 1.0;
    bool small = AOB_DEPTH_DIVISOR == 1 && aob_pixel_radius(z, param.radius) * longer < 0.5;
    return aob_no_depth(z) || small || aob_fetch_clearance(p * AOB_DIVISOR / AOB_DIVISOR_CLEARANCE) > 0.5;
}
