/* One triangle that covers the target. */
void main()
{
    vec2 corner = vec2((VERTEX_ID << 1) & 2, VERTEX_ID & 2);
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
