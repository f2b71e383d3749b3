/* Base colours are held as their square roots (gbuffer/material_texels.h). */
ivec2 aob_material_texel(ivec2 p) { return clamp(p * AOB_DIVISOR, ivec2(0), param.aob_sizes.xy - 1); }
vec3 aob_albedo(ivec2 p) {
    vec3 root = aob_texel_albedo(aob_material_texel(p)).xyz;
    return root * root;
}
vec2 aob_shine(ivec2 p) { return aob_texel_shine(aob_material_texel(p)); }
float aob_roughness(ivec2 p) { return aob_shine(p).x; }
float aob_metalness(ivec2 p) { return aob_shine(p).y; }
