/* One axis of the text's cross-bilateral filter (Eisemann and Durand 2004, made separable): BLUR taps (odd) along AXIS
 * (0 x, 1 y), Gaussian in the distance, with a standard deviation of a quarter of the taps, and in the depth. */
void main()
{
    ivec2 p = aob_pixel;
    AOB_TYPE_RAW centre = aob_fetch_raw(p), sum = centre;
    float depth = aob_surface_z(p), weights = 1.0;
    const float sigma = float(BLUR) / 4.0;
    for (int i = -(BLUR / 2); i <= BLUR / 2; i++) {
        ivec2 q = p + (AXIS == 0 ? ivec2(i, 0) : ivec2(0, i));
        float near = float(i) / sigma, delta = (aob_surface_z(q) - depth) / param.blur_depth;
        float apart = near * near + delta * delta;
        float w = apart > 0.0 ? exp(-0.5 * apart) : 0.0; /* nor the centre again, nor what has no depth */
        sum += w * aob_fetch_raw(q);
        weights += w;
    }
    blurred = aob_surface_is_sky(p) ? centre : sum / weights;
}
