/* How far another point belongs to the surface of the centre, 0..1: it must lie near the centre's tangent plane and
 * face the same way, so that nothing is mixed over a depth edge or a crease. */
float same_surface(vec3 centre, vec3 normal, vec3 other, vec3 other_normal)
{
    vec3 d = other - centre;
    float off_plane = abs(dot(d, normal));
    float near = off_plane <= 0.05 * length(d) + (AOB_PERSPECTIVE == 1 ? 1e-4 : 1e-6) * -centre.z ? 1.0 : 0.0;
    float facing = max(dot(other_normal, normal), 0.0);
    facing *= facing; /* its eighth power: pow() took a quarter of a blur's time on llvmpipe */
    facing *= facing;
    return near * facing * facing;
}
