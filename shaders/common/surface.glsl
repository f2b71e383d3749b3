/* How far another point belongs to the surface of the centre, 0..1: it must lie near the centre's tangent plane and
 * face the same way, by the cosine of the two normals, so that nothing is mixed over a depth edge or a crease. A cosine
 * that is no number is of no surface, and so is a point off a plane that is none. */
float same_surface(vec3 centre, vec3 normal, vec3 other, float cosine)
{
    vec3 d = other - centre;
    float off_plane = abs(dot(d, normal));
    /* Places round with the depth. Without perspective nothing else grows with it: a camera that stands far off sees the
     * same edges, and 1e-4 of its distance would reach over them. */
    bool near = off_plane <= 0.05 * length(d) + (AOB_PERSPECTIVE == 1 ? 1e-4 : 1e-6) * -centre.z;
    float facing = min(cosine, 1.01); /* above 1 by rounding, or where a single normal is no unit vector */
    facing *= facing; /* its eighth power: pow() took a quarter of a blur's time on llvmpipe */
    facing *= facing;
    return near && cosine > 0.0 ? facing * facing : 0.0;
}

float same_surface(vec3 centre, vec3 normal, vec3 other, vec3 other_normal)
{
    return same_surface(centre, normal, other, dot(other_normal, normal));
}

/* Makes a centre's normal a unit vector. `alike` is what to multiply other normals by for the cosine: where a G-buffer's
 * normals are all of one length, they are as if it were 1. Unit vectors keep their bits. */
void make_unit(inout vec3 normal, out vec3 alike)
{
    float square = dot(normal, normal);
    alike = normal;
    if (abs(square - 1.0) > 1e-4) {
        normal *= inversesqrt(square);
        alike /= square;
    }
}
