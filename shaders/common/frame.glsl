/* Two unit vectors that span the plane perpendicular to unit vector n (Duff et al. 2017, without a branch). */
void tangent_frame(vec3 n, out vec3 b1, out vec3 b2)
{
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z);
    float b = n.x * n.y * a;
    b1 = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x);
    b2 = vec3(b, s + n.y * n.y * a, -n.y);
}
