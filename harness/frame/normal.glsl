vec3 aob_normal(ivec2 p) { return aob_gbuffer_normal(p * AOB_DEPTH_DIVISOR); }
vec3 aob_surface_normal(ivec2 p) { return aob_gbuffer_normal(p * AOB_DIVISOR); }
