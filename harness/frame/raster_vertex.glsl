layout(std140, BIND(0)) uniform View { vec4 scale; vec4 centre; vec4 ray; vec4 range; };
layout(BIND(1)) uniform sampler2D triangles;
layout(location = 0) flat out int triangle;
layout(location = 1) out vec3 shading;
vec4 texel(int i) { return texelFetch(triangles, ivec2(triangle % 2048 * 7 + i, triangle / 2048), 0); }
void main() {
    triangle = VERTEX_ID / 3;
    vec3 p = texel(VERTEX_ID % 3).xyz;
    shading = texel(4 + VERTEX_ID % 3).xyz;
    bool perspective = range.z > 0.0;
    float w = perspective ? -p.z : 1.0;
    float z = perspective ? range.x : 1.0 + p.z * range.x;
    gl_Position = vec4(p.xy * scale.xy + centre.xy * w, z, w);
}
