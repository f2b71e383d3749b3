/* A texel of an open texture (aob_open_format): the visibility, or a bent normal with the visibility behind it. */
float open_share(float open) { return open; }
float open_share(vec4 open) { return open.w; }
vec4 open_texel(float open) { return vec4(0.0, 0.0, 0.0, open); }
vec4 open_texel(vec4 open) { return open; }
