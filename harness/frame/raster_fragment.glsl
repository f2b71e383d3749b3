/* The plane n.p = d, met by the ray from o along r, at the depth (d - n.o) / n.r; within the triangle's own depths,
 * because a pixel that is covered by a hair may lie beside a triangle seen from its edge. */
layout(std140, BIND(0)) uniform View { vec4 scale; vec4 centre; vec4 ray; vec4 range; };
layout(BIND(1)) uniform sampler2D triangles;
layout(location = 0) flat in int triangle;
layout(location = 1) in vec3 shading;
layout(location = 0) out vec4 surface;
layout(location = 1) out vec4 shaded;
vec4 texel(int i) { return texelFetch(triangles, ivec2(triangle % 2048 * 7 + i, triangle / 2048), 0); }
/* The shading normal s bent towards v, the direction to the camera: AOB_LEAST_FACING of reference/tracer.h. */
vec3 face(vec3 s, vec3 n, vec3 v) {
    float along = dot(s, v), least = min(1.0 / 64.0, dot(n, v));
    vec3 across = s - v * along;
    float square = dot(across, across);
    vec3 bent = across * sqrt((1.0 - least * least) / max(square, 1e-30)) + v * least;
    return along >= least ? s : square > 0.0 ? bent : v;
}
void main() {
    bool perspective = range.z > 0.0;
    vec2 across = (gl_FragCoord.xy - ray.xy) * ray.zw;
    vec3 o = perspective ? vec3(0.0) : vec3(across, 0.0);
    vec3 r = perspective ? vec3(across, -1.0) : vec3(0.0, 0.0, -1.0);
    vec4 plane = texel(3);
    vec3 n = plane.xyz;
    float along = dot(n, r), low = texel(0).w, high = texel(1).w;
    float depth = along != 0.0 ? (plane.w - dot(n, o)) / along : low;
    depth = min(max(depth, low), high);
    n = along > 0.0 ? -n : n;
    float size = dot(shading, shading);
    vec3 s = size > 0.0 ? shading * inversesqrt(size) : n;
    surface = vec4(n, depth);
    shaded = vec4(face(dot(s, n) < 0.0 ? -s : s, n, -r * inversesqrt(dot(r, r))), float(triangle + 1));
    gl_FragDepth = perspective ? range.x / max(depth, range.x) : 1.0 - depth * range.x;
}
