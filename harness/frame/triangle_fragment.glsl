/* Handed on by the vertices: a fragment that fetched them would pay more for that than for all else. */
vec3 aob_corner(int k) {
    return k == 0 ? aob_corner_0.xyz : k == 1 ? aob_corner_1.xyz : aob_corner_2.xyz;
}
vec3 aob_front() { return vec3(aob_corner_0.w, aob_corner_1.w, aob_corner_2.w); }
