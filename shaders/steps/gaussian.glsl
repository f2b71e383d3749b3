/* One axis of a separable Gaussian blur with tests (Filion 2010, listing 1.2.7): BLUR taps (odd) along AXIS (0 x, 1 y),
 * standard deviation a quarter of the taps. A tap whose depth differs by more than param.blur_depth, or whose normal
 * has a cosine below param.blur_normal with the centre's, weighs nothing; the sum is normalised again. The loop is
 * unrolled everywhere: else exp() of its counter is the compiler's in one program and the device's in another, a traced
 * one, say, and their last bits differ. */
void main()
{
    ivec2 p = aob_pixel;
    float depth = aob_surface_z(p);
    vec3 normal = aob_surface_normal(p);
    float least = param.blur_normal * dot(normal, normal); /* as if it were of length 1, where all have another */
    AOB_TYPE_RAW centre = aob_fetch_raw(p), sum = centre;
    float weights = 1.0;
    const float sigma = float(BLUR) / 4.0;
    [[unroll]] for (int i = -(BLUR / 2); i <= BLUR / 2; i++) {
        ivec2 q = p + (AXIS == 0 ? ivec2(i, 0) : ivec2(0, i));
        bool same = abs(aob_surface_z(q) - depth) <= param.blur_depth &&
                    dot(aob_surface_normal(q), normal) >= least; /* false of what is no number */
        float w = i != 0 && same ? exp(-0.5 * float(i * i) / (sigma * sigma)) : 0.0;
        sum += w * aob_fetch_raw(q);
        weights += w;
    }
    blurred = aob_surface_is_sky(p) ? centre : sum / weights;
}
