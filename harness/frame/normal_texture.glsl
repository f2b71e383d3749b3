vec3 aob_gbuffer_normal(ivec2 f) {
    return aob_decode_normal(aob_texel_normal(clamp(f, ivec2(0), param.aob_sizes.xy - 1)));
}
