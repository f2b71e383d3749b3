vec4 aob_triangle_texel(int triangle, int k) {
    return texelFetch(aob_triangles, ivec2(triangle % AOB_ROW * 3 + k, triangle / AOB_ROW), 0);
}
vec3 aob_corner(int triangle, int k) { return aob_triangle_texel(triangle, k).xyz; }
vec3 aob_front(int triangle) {
    return vec3(aob_triangle_texel(triangle, 0).w, aob_triangle_texel(triangle, 1).w,
                aob_triangle_texel(triangle, 2).w);
}

/* Image positions are in the depth's pixels, the rasteriser's in the outputs'; both have pixel 0 of the whole
 * G-buffer in the middle of their first one. */
vec4 aob_clip(vec2 q) {
    vec2 t = (q - 0.5) * (float(AOB_DEPTH_DIVISOR) / float(AOB_DIVISOR)) + 0.5;
    return vec4(2.0 * t / vec2(aob_target_size) - 1.0, 0.5, 1.0);
}
