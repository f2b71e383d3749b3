/* What bounds the surfaces of a cell of the image. They lie on rays between its four corners: within the depths ends.z to ends.w,
 * and along `n` within ends.x to ends.y where all four rays meet the plane from one side. Both are convex bodies of eight corners,
 * and the surfaces are in both. */
struct hull {
    vec3 low, high; /* its box */
    float top;      /* farthest along the direction that was asked for */
};

bool is_empty(vec4 ends) { return !(ends.z <= ends.w); }

/* How deep the ray through q is where it is s along n; below 0 where it does not meet that, or hardly. */
float depth_on_plane(vec2 q, vec3 n, float s)
{
#if AOB_PERSPECTIVE == 1
    float facing = dot(n, aob_position_at(q, 1.0));
    return facing < -1e-3 ? s / facing : -1.0;
#else
    return n.z > 1e-3 ? (dot(n, aob_position_at(q, 0.0)) - s) / n.z : -1.0;
#endif
}

void reach(inout hull h, vec3 v, vec3 along)
{
    h.low = min(h.low, v);
    h.high = max(h.high, v);
    h.top = max(h.top, dot(v, along));
}

hull hull_of(ivec2 cell, int side, vec3 n, vec4 ends, vec3 along)
{
    hull deep = hull(vec3(1e30), vec3(-1e30), -1e30), flat_one = deep;
    vec2 first = vec2(cell * side), last = vec2(min((cell + 1) * side, aob_size));
    bool met = true;
    for (int k = 0; k < 4; k++) {
        vec2 q = vec2((k & 1) == 0 ? first.x : last.x, (k & 2) == 0 ? first.y : last.y);
        vec2 z = vec2(depth_on_plane(q, n, ends.x), depth_on_plane(q, n, ends.y));
        met = met && min(z.x, z.y) > 0.0;
        reach(deep, aob_position_at(q, ends.z), along);
        reach(deep, aob_position_at(q, ends.w), along);
        reach(flat_one, aob_position_at(q, z.x), along);
        reach(flat_one, aob_position_at(q, z.y), along);
    }
    if (met)
        deep = hull(max(deep.low, flat_one.low), min(deep.high, flat_one.high), min(deep.top, flat_one.top));
    if (n == along) /* without the rounding of a corner */
        deep.top = min(deep.top, ends.y);
    return deep;
}
