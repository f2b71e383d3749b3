/* One axis of a separable cross-bilateral filter: BLUR taps (odd) along AXIS (0 x, 1 y), Gaussian with a standard
 * deviation of a quarter of the taps. A tap counts only if it lies near the tangent plane of the centre and faces
 * the same way, so that nothing bleeds over a depth edge or a crease. */
void main()
{
    ivec2 p = aob_pixel;
    vec3 position = aob_position(p), normal = aob_normal(p);
    float centre = aob_fetch_raw(p);
    float sum = centre, weights = 1.0;
    const float sigma = float(BLUR) / 4.0;
    for (int i = -(BLUR / 2); i <= BLUR / 2; i++) {
        ivec2 q = p + (AXIS == 0 ? ivec2(i, 0) : ivec2(0, i));
        vec3 d = aob_position(q) - position;
        float off_plane = abs(dot(d, normal));
        float near = off_plane <= 0.05 * length(d) + 1e-4 * -position.z ? 1.0 : 0.0;
        float facing = pow(max(dot(aob_normal(q), normal), 0.0), 8.0);
        float w = i == 0 ? 0.0 : exp(-0.5 * float(i * i) / (sigma * sigma)) * near * facing;
        sum += w * aob_fetch_raw(q);
        weights += w;
    }
    blurred = aob_is_sky(p) ? centre : sum / weights;
}
