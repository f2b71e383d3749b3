/* Of each tile of 8 x 8 pixels: the normal of the plane through three of its surfaces, by how much the G-buffer's normals lean away
 * from it, and between which two planes across it and which depths its surfaces lie. Where one of the three is sky the normal is
 * that of the first surface, and so it is with IN_FRONT: a surface that is asked about the whole depth of the scene must be the
 * technique's own plane to the last bits. A tile of the sky alone has its depths in the wrong order. */
bool surface_at(ivec2 q, out vec3 position)
{
    float z = any(greaterThanEqual(q, aob_size)) ? AOB_SKY_Z : aob_view_z(q);
    position = aob_position_at(vec2(q) + 0.5, z);
    return !aob_no_depth(z);
}

/* 0 where one of the three is sky. */
vec3 fitted_normal(ivec2 first)
{
    vec3 a, b, c;
    bool whole = surface_at(first, a);
    whole = surface_at(first + ivec2(7, 0), b) && whole;
    whole = surface_at(first + ivec2(0, 7), c) && whole;
    vec3 n = cross(c - a, b - a);
    float size = length(n);
    return whole && size > 1e-20 && size < 1e20 ? n / size : vec3(0.0);
}

bool faces(vec3 n, vec3 position) { return AOB_PERSPECTIVE == 1 ? dot(n, position) < 0.0 : n.z > 0.0; }

void main()
{
    ivec2 first = aob_pixel * 8;
    vec3 n = IN_FRONT == 1 ? vec3(0.0) : fitted_normal(first);
    float lean = 0.0;
    vec4 found = vec4(1e30, -1e30, 1e30, -1e30);
    for (int i = 0; i < 64; i++) {
        ivec2 q = first + ivec2(i & 7, i >> 3);
        vec3 position;
        if (!surface_at(q, position)) {
            /* A depth that is none is at the eye, if it is not the sky's: where that is along n nothing says. */
            if (IN_FRONT == 1 && all(lessThan(q, aob_size)) && !(-position.z >= 1e-15))
                found = vec4(-1e30, 1e30, 0.0, max(found.w, 0.0));
            continue;
        }
        vec3 own = aob_normal(q);
        n = n == vec3(0.0) ? own : n;
        float height = dot(position, n), off = dot(own - n, own - n);
        /* A normal that is none, or looks away, makes a technique mend it: the tile is not clear. */
        lean = off <= 4.0 && abs(dot(n, n) - 1.0) <= 1e-3 && faces(n, position) ? max(lean, off) : 4.0;
        found = vec4(min(found.x, height), max(found.y, height), min(found.z, -position.z), max(found.w, -position.z));
        if (n == vec3(0.0)) /* heights along no direction bound nothing */
            found.xy = vec2(-1e30, 1e30);
    }
    plane = vec4(n, sqrt(lean));
    ends = found;
}
