/* Cosine of the half-angle of the cone about the normal whose cosine-weighted share of the hemisphere is v: v is the square of
 * the sine. */
float cone_cosine(float v) { return sqrt(clamp(1.0 - v, 0.0, 1.0)); }
